// Text is typed, erased, marked and broken into paragraphs; lists, sections and tables.
#include "authoring/command_testing.h"
#include "manuscript/leaves.h"
#include "manuscript/places.h"

namespace authoring {

using manuscript::place, manuscript::placeBeside, manuscript::lineAround, manuscript::everything,
    manuscript::widened;
namespace {

TEST(Authoring, Types) {
    EXPECT_EQ(memo("<P>{One| two}</P>", typed("x")), "<P>{Onex| two}</P>");
    EXPECT_EQ(memo("<P>{One| two}</P>", typed("{&<\\")), "<P>{One\\{&<\\\\| two}</P>");
    EXPECT_EQ(memo("<P>{One[ two|}</P>", typed("!")), "<P>{One!|}</P>");
    EXPECT_EQ(memo("<P>{One| two[}</P>", typed("!")), "<P>{One!|}</P>");
    EXPECT_EQ(memo("<P>|</P>", typed("a")), "<P>{a|}</P>");
    EXPECT_EQ(after("DOCUMENT CMEMO\n<CMEMO><BODY>|</BODY></CMEMO>", typed("a")),
              "DOCUMENT CMEMO\n<CMEMO><BODY><P>{a|}</P></BODY></CMEMO>");
    EXPECT_EQ(memo("<P>{a|b}</P>", typed("1\n2")), "<P>{a1 2|b}</P>");
    EXPECT_EQ(memo("<V>{a|b}</V>", typed("1\n2")), "<V>{a1\n2|b}</V>");
    EXPECT_EQ(memo("<P><T>{a }</T><E>{[b|}</E></P>", typed("c")), "<P><T>{a }</T><E>{c|}</E></P>");
    EXPECT_EQ(memo("<L>|</L>", typed("c")), "<L><I>{c|}</I></L>");
    EXPECT_EQ(memo("<RULE></RULE>|", typed("c")), "<RULE></RULE>\n<P>{c|}</P>");
    EXPECT_EQ(memo("<P><T>{a}</T><IMAGE></IMAGE>|</P>", typed("c")),
              "<P><T>{a}</T><IMAGE></IMAGE><T>{c|}</T></P>");
}

TEST(Authoring, ErasesACharacterOrAWord) {
    EXPECT_EQ(memo("<P>{One|}</P>", backspace), "<P>{On|}</P>");
    EXPECT_EQ(memo("<P>{|One}</P>", del), "<P>{|ne}</P>");
    // An "e" with two marks above it is one character.
    EXPECT_EQ(memo("<P>{xe\u0301\u0302|}</P>", backspace), "<P>{x|}</P>");
    EXPECT_EQ(memo("<P>{a\\{|b}</P>", backspace), "<P>{a|b}</P>");
    EXPECT_EQ(memo("<P>{a \n  |b}</P>", backspace), "<P>{a|b}</P>");
    EXPECT_EQ(memo("<P>{one two|}</P>", erased(Direction::backward, Unit::word)), "<P>{one |}</P>");
    EXPECT_EQ(memo("<P>{one| two three}</P>", erased(Direction::forward, Unit::word)),
              "<P>{one| three}</P>");
    EXPECT_EQ(memo("<P>{a|}</P>", backspace), "<P>{|}</P>");
    EXPECT_EQ(memo("<P><T>{a }</T><E>{b}</E><T>{|c}</T></P>", backspace), "<P><T>{a |c}</T></P>");
    // A unit, such as a footnote, is selected first.
    EXPECT_EQ(memo("<P><T>{a}</T><F>{note}</F><T>{|c}</T></P>", backspace),
              "<P><T>{a}</T>|<F>{note}</F>[<T>{c}</T></P>");
    EXPECT_EQ(memo("<P><T>{a}</T>|<F>{note}</F>[<T>{c}</T></P>", backspace), "<P><T>{a|c}</T></P>");
}

TEST(Authoring, ErasesASelection) {
    EXPECT_EQ(memo("<P>{O[ne tw|o}</P>", backspace), "<P>{O|o}</P>");
    EXPECT_EQ(memo("<P>{One[}</P>\n<P>{two|}</P>\n<P>{three}</P>", backspace),
              "<P>{One|}</P>\n<P>{three}</P>");
    EXPECT_EQ(memo("<P>{O[ne}</P>\n<P>{two}</P>\n<P><T>{th|}</T><E>{ree}</E></P>", del),
              "<P><T>{O|}</T><E>{ree}</E></P>");
    EXPECT_EQ(memo("<P><T>{a[b}</T><E>{cd}</E><T>{e|f}</T></P>", del), "<P><T>{a|f}</T></P>");
    EXPECT_EQ(memo("<P><T>{ab}</T><E>{[cd|}</E><T>{ef}</T></P>", del), "<P><T>{ab|ef}</T></P>");
    // A bare brace that loses its partner is escaped.
    EXPECT_EQ(memo("<P>{a {b[ c} d}</P>\n<P>{e|f}</P>", del), "<P>{a \\{b|f}</P>");
}

TEST(Authoring, JoinsParagraphs) {
    EXPECT_EQ(memo("<P>{One}</P>\n<P>{|two}</P>", backspace), "<P>{One|two}</P>");
    EXPECT_EQ(memo("<P>{One|}</P>\n<P ID=\"a\">{two}</P>", del), "<P>{One|two}</P>");
    EXPECT_EQ(memo("<P>{One}</P>\n<P><T>{|two}</T><E>{!}</E></P>", backspace),
              "<P><T>{One|two}</T><E>{!}</E></P>");
    EXPECT_EQ(memo("<P><T>{One}</T></P>\n<P><T>{|two}</T></P>", backspace),
              "<P><T>{One|two}</T></P>");
    EXPECT_EQ(memo("<P>{a|}</P>\n<L>\n<I>{b}</I>\n<I>{c}</I>\n</L>", del),
              "<P>{a|b}</P>\n<L>\n<I>{c}</I>\n</L>");
    EXPECT_EQ(memo("<P>{a|}</P>\n<L>\n<I>{b}</I>\n</L>", del), "<P>{a|b}</P>");
    // Backward, the first item leaves its list.
    EXPECT_EQ(memo("<P>{a}</P>\n<L>\n<I>{|b}</I>\n<I>{c}</I>\n</L>", backspace),
              "<P>{a}</P>\n<P>{|b}</P>\n<L>\n<I>{c}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I>{b}</I>\n<I>{|c}</I>\n</L>", backspace), "<L>\n<I>{b|c}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I>{a}</I>\n<I><T>{|b}</T><L><I>{c}</I></L></I>\n</L>", backspace),
              "<L>\n<I><T>{a|b}</T><L><I>{c}</I></L></I>\n</L>");
    EXPECT_EQ(report("<S><H>{A}</H>\n<P>{a}</P></S>\n<S><H>{|B}</H>\n<P>{b}</P></S>", backspace),
              "<S><H>{A}</H>\n<P>{a|B}</P>\n<P>{b}</P></S>");
    EXPECT_EQ(
        report("<S><H>{A[}</H>\n<P>{a}</P></S>\n<S><H>{B}</H>\n<P>{b|c}</P>\n<P>{d}</P></S>", del),
        "<S><H>{A|c}</H>\n<P>{d}</P></S>");
}

TEST(Authoring, DoesNotJoinWhatIsApart) {
    EXPECT_EQ(memo("<P>{|a}</P>", backspace),
              "refused: The lines on both sides of the caret cannot be joined.");
    EXPECT_EQ(memo("<TABLE><R><C>{a}</C><C>{|b}</C></R></TABLE>", backspace),
              "refused: The lines on both sides of the caret cannot be joined.");
    EXPECT_EQ(
        memo("<P>{x}</P><TABLE><R><C>{a[b}</C><C>{cd}</C></R><R><C>{e|f}</C></R></TABLE>", del),
        "<P>{x}</P><TABLE><R><C>{|}</C><C>{cd}</C></R><R><C>{}</C></R></TABLE>");
    EXPECT_EQ(memo("<P>{a}</P>|<RULE></RULE>[<P>{b}</P>", backspace), "<P>{a}</P><P>{|b}</P>");
    EXPECT_EQ(memo("<P>{a|}</P><FIGURE><IMAGE></IMAGE><CAPTION>{c}</CAPTION></FIGURE>", del),
              "<P>{a}</P><FIGURE>[<IMAGE></IMAGE>|<CAPTION>{c}</CAPTION></FIGURE>");
    EXPECT_EQ(memo("<P>{a}</P><FIGURE>[<IMAGE></IMAGE>|<CAPTION>{c}</CAPTION></FIGURE>", del),
              "<P>{a|}</P>");
}

TEST(Authoring, BreaksParagraphs) {
    EXPECT_EQ(memo("<P>{One| two}</P>", enter), "<P>{One}</P>\n<P>{| two}</P>");
    EXPECT_EQ(memo("  <P ID=\"p\">{One|}</P>", enter), "  <P ID=\"p\">{One}</P>\n  <P>{|}</P>");
    EXPECT_EQ(memo("<P>{|One}</P>", enter), "<P>{}</P>\n<P>{|One}</P>");
    EXPECT_EQ(memo("<P><T>{a}</T><E>{b|c}</E><T>{d}</T></P>", enter),
              "<P><T>{a}</T><E>{b}</E></P>\n<P><E>{|c}</E><T>{d}</T></P>");
    EXPECT_EQ(memo("<P>{a[b}</P>\n<P>{c|d}</P>", enter), "<P>{a}</P>\n<P>{|d}</P>");
    EXPECT_EQ(memo("<V>{a|b}</V>", enter), "<V>{a\n|b}</V>");
    EXPECT_EQ(memo("<L>\n<I>{a|b}</I>\n</L>", enter), "<L>\n<I>{a}</I>\n<I>{|b}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I><P>{a|b}</P></I>\n</L>", enter),
              "<L>\n<I><P>{a}</P></I>\n<I><P>{|b}</P></I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I>{a}</I>\n<I>{|}</I>\n</L>", enter),
              "<L>\n<I>{a}</I>\n</L>\n<P>{|}</P>");
    EXPECT_EQ(memo("<L>\n<I>{a}</I>\n<I>{|}</I>\n<I>{b}</I>\n</L>", enter),
              "<L>\n<I>{a}</I>\n</L>\n<P>{|}</P>\n<L>\n<I>{b}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I><T>{a}</T><L><I>{b}</I><I>{|}</I></L></I>\n</L>", enter),
              "<L>\n<I><T>{a}</T><L><I>{b}</I></L></I>\n<I>{|}</I>\n</L>");
    EXPECT_EQ(memo("<TABLE><R><C>{a|b}</C></R></TABLE>", enter),
              "<TABLE><R><C><P>{a}</P>\n<P>{|b}</P></C></R></TABLE>");
}

TEST(Authoring, AParagraphFollowsAHeading) {
    EXPECT_EQ(report("<S>\n<H>{A|}</H>\n<P>{b}</P>\n</S>", enter),
              "<S>\n<H>{A}</H>\n<P>{|}</P>\n<P>{b}</P>\n</S>");
    EXPECT_EQ(report("<S>\n<H ID=\"h\">{A|B}</H>\n</S>", enter),
              "<S>\n<H ID=\"h\">{A}</H>\n<P>{|B}</P>\n</S>");
    EXPECT_EQ(memo("<FIGURE><IMAGE></IMAGE><CAPTION>{a|}</CAPTION></FIGURE>", enter),
              "<FIGURE><IMAGE></IMAGE><CAPTION>{a}</CAPTION></FIGURE>\n<P>{|}</P>");
    EXPECT_EQ(memo("<FIGURE><IMAGE></IMAGE><CAPTION>{a|b}</CAPTION></FIGURE>", enter),
              "refused: This field takes one line only.");
}

TEST(Authoring, ASelectionThatReachesIntoADocumentBehindTheEndEndsBehindIt) {
    const std::string other =
        "<DOCUMENT>\nDOCUMENT CMEMO\n<CMEMO><BODY><P>{there|}</P></BODY></CMEMO>\n</DOCUMENT>\n";
    const Marked marked = readMarks(renamed(memoHead + "<P>{he[re}</P>" + memoTail + other, false));
    const document::Document document(marked.bytes);
    const std::size_t end = marked.bytes.size() - 1; // before the last line's end
    const Selection wide = widened({document, testGrammars()}, marked.selection);
    EXPECT_EQ(wide.anchor, marked.selection.anchor);
    EXPECT_EQ(wide.caret, end);
    const Selection back =
        widened({document, testGrammars()}, {marked.selection.caret, marked.selection.anchor});
    EXPECT_EQ(back.caret, marked.selection.anchor);
    EXPECT_EQ(back.anchor, end);
}

// In a damaged file.
TEST(Authoring, ASelectionFromADocumentIntoAFootnoteBehindItIsEmpty) {
    const std::string other = "<FOOTNOTE>{there|}</FOOTNOTE>\n";
    const Marked marked =
        readMarks(renamed(reportHead + "<P>{he[re}</P>" + reportTail + other, false));
    const document::Document document(marked.bytes);
    const Selection none = widened({document, testGrammars()}, marked.selection);
    EXPECT_EQ(none.anchor, marked.selection.anchor);
    EXPECT_EQ(none.caret, marked.selection.anchor);
}

TEST(Authoring, TogglesEmphasis) {
    const auto emphasis = [](const Manuscript& manuscript, Selection selection) {
        return toggle(manuscript, selection, schemas::ContainerRole::emphasis);
    };
    EXPECT_EQ(memo("<P>{a[b|c}</P>", emphasis), "<P><T>{a[}</T><E>{b}</E><T>{|c}</T></P>");
    EXPECT_EQ(memo("<P><T>{a[}</T><E>{b}</E><T>{|c}</T></P>", emphasis), "<P>{a[b|c}</P>");
    EXPECT_EQ(memo("<P>{[ab|}</P>", emphasis), "<P><E>{[ab|}</E></P>");
    EXPECT_EQ(memo("<P><T>{one tw|o}</T></P>", emphasis), "<P><T>{one }</T><E>{tw|o}</E></P>");
    EXPECT_EQ(memo("<P>{one two|}</P>", emphasis), "<P><T>{one }</T><E>{two|}</E></P>");
    EXPECT_EQ(memo("<P>{one |two}</P>", emphasis), "<P><T>{one |}</T><E>{two}</E></P>");
    EXPECT_EQ(memo("<P><T>{a}</T><E>{tw|o}</E></P>", emphasis), "<P>{atw|o}</P>");
    EXPECT_EQ(memo("<P><T>{a[b}</T><B>{c}</B><T>{d|e}</T></P>", emphasis),
              "<P><T>{a[}</T><E>{b}</E><B><E>{c}</E></B><E>{d|}</E><T>{e}</T></P>");
    EXPECT_EQ(memo("<P>{a[b}</P>\n<P>{c|d}</P>", emphasis),
              "<P><T>{a[}</T><E>{b}</E></P>\n<P><E>{c}</E><T>{|d}</T></P>");
    EXPECT_EQ(memo("<P><E>{a[b|c}</E></P>", emphasis), "<P><E>{a[}</E><T>{b|}</T><E>{c}</E></P>");
    EXPECT_EQ(memo("<P><T>{a[b}</T><E>{c|}</E></P>", emphasis), "<P><T>{a[}</T><E>{bc|}</E></P>");
    EXPECT_EQ(memo("<V>{[ab|}</V>", emphasis), "refused: Select the text first.");
}

TEST(Authoring, TypesIntoAndOutOfEmphasis) {
    const auto toggled = [](const Manuscript& manuscript, Selection selection) {
        return typeToggled(manuscript, selection, "x", schemas::ContainerRole::emphasis);
    };
    EXPECT_EQ(memo("<P>{a|b}</P>", toggled), "<P><T>{a}</T><E>{x|}</E><T>{b}</T></P>");
    EXPECT_EQ(memo("<P>{|}</P>", toggled), "<P><E>{x|}</E></P>");
    EXPECT_EQ(memo("<P><E>{a|}</E></P>", toggled), "<P><E>{a}</E><T>{x|}</T></P>");
    EXPECT_EQ(memo("<P><E>{a|b}</E><T>{c}</T></P>", toggled),
              "<P><E>{a}</E><T>{x|}</T><E>{b}</E><T>{c}</T></P>");
}

TEST(Authoring, EnterBesideUnitsAndFields) {
    EXPECT_EQ(memo("<FIGURE><IMAGE></IMAGE>|</FIGURE>", enter),
              "<FIGURE><IMAGE></IMAGE></FIGURE>\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{a}</P>\n<FIGURE>|<IMAGE></IMAGE></FIGURE>", enter),
              "<P>{a}</P>\n<P>{|}</P>\n<FIGURE><IMAGE></IMAGE></FIGURE>");
    EXPECT_EQ(
        after("DOCUMENT CMEMO\n<CMEMO><TO>{a|}</TO><FROM>{b}</FROM><BODY></BODY></CMEMO>", enter),
        "DOCUMENT CMEMO\n<CMEMO><TO>{a}</TO><FROM>{|b}</FROM><BODY></BODY></CMEMO>");
}

TEST(Authoring, Links) {
    const auto to = [](const std::string& target) {
        return [target](const Manuscript& manuscript, Selection selection) {
            return link(manuscript, selection, target);
        };
    };
    EXPECT_EQ(memo("<P>{a[b|c}</P>", to("x")),
              "<P><T>{a[}</T><LINK TO=\"x\">{b}</LINK><T>{|c}</T></P>");
    EXPECT_EQ(memo("<P><LINK TO=\"y\">{[bc|}</LINK></P>", to("x")),
              "<P><LINK TO=\"x\">{[bc|}</LINK></P>");
    EXPECT_EQ(memo("<P><LINK TO=\"y\">{[bc|}</LINK></P>", to("")), "<P>{[bc|}</P>");
}

TEST(Authoring, HeadingsHaveSections) {
    const auto to = [](int level) {
        return [level](const Manuscript& manuscript, Selection selection) {
            return makeHeading(manuscript, selection, level);
        };
    };
    EXPECT_EQ(report("<P>{a}</P>\n<P>{b|}</P>\n<P>{c}</P>\n<S><H>{d}</H></S>", to(1)),
              "<P>{a}</P>\n<S>\n<H>{b|}</H>\n<P>{c}</P>\n</S>\n<S><H>{d}</H></S>");
    EXPECT_EQ(report("<S>\n<H>{a}</H>\n<P ID=\"p\">{b|}</P>\n<P>{c}</P>\n</S>", to(1)),
              "<S>\n<H>{a}</H>\n</S>\n<S>\n<H ID=\"p\">{b|}</H>\n<P>{c}</P>\n</S>");
    EXPECT_EQ(report("<S>\n<H>{a}</H>\n<P>{b|}</P>\n<P>{c}</P>\n</S>", to(2)),
              "<S>\n<H>{a}</H>\n<S>\n<H>{b|}</H>\n<P>{c}</P>\n</S>\n</S>");
    EXPECT_EQ(report("<P>{b|}</P>", to(2)),
              "refused: A heading of this level needs one of the level above before it.");
    EXPECT_EQ(
        report("<S>\n<H>{a}</H>\n<S>\n<H>{b|}</H>\n<P>{c}</P></S>\n<S><H>{d}</H></S>\n</S>", to(1)),
        "<S>\n<H>{a}</H>\n</S>\n<S>\n<H>{b|}</H>\n<P>{c}</P>\n<S><H>{d}</H></S></S>");
    EXPECT_EQ(report("<S>\n<H>{a}</H>\n</S>\n<S>\n<H>{b|}</H>\n</S>", to(2)),
              "<S>\n<H>{a}</H>\n<S>\n<H>{b|}</H>\n</S>\n</S>");
    EXPECT_EQ(report("<S>\n<H>{a}</H>\n</S>\n<S>\n<H>{b|}</H>\n<P>{c}</P>\n</S>", makeParagraph),
              "<S>\n<H>{a}</H>\n<P>{b|}</P>\n<P>{c}</P>\n</S>");
    EXPECT_EQ(memo("<P>{b|}</P>", to(1)), "<S>\n<H>{b|}</H>\n</S>");
}

TEST(Authoring, Lists) {
    const auto list = [](const Manuscript& manuscript, Selection selection) {
        return makeList(manuscript, selection, "KIND", "number");
    };
    EXPECT_EQ(memo("<P>{[a}</P>\n<P ID=\"i\">{b|}</P>\n<P>{c}</P>", list),
              "<L KIND=\"number\">\n<I>{[a}</I>\n<I ID=\"i\">{b|}</I>\n</L>\n<P>{c}</P>");
    EXPECT_EQ(memo("<L>\n<I>{a}</I>\n<I>{b|}</I>\n<I>{c}</I>\n</L>", indentItems),
              "<L>\n<I><T>{a}</T><L>\n<I>{b|}</I></L></I>\n<I>{c}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I>{|a}</I>\n</L>", indentItems),
              "refused: The first item of a list cannot go into the one before it.");
    EXPECT_EQ(memo("<L>\n<I>{a}</I>\n<I>{b|}</I>\n<I>{c}</I>\n</L>", outdentItems),
              "<L>\n<I>{a}</I>\n</L>\n<P>{b|}</P>\n<L>\n<I>{c}</I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I>{[a}</I>\n<I>{b|}</I>\n</L>", outdentItems),
              "<P>{[a}</P>\n<P>{b|}</P>");
    EXPECT_EQ(memo("<L>\n<I><T>{a}</T><L><I>{b|}</I><I>{c}</I></L></I>\n</L>", outdentItems),
              "<L>\n<I><T>{a}</T></I>\n<I><T>{b|}</T><L><I>{c}</I></L></I>\n</L>");
    EXPECT_EQ(memo("<L>\n<I><T>{a}</T><L><I>{b|}</I></L></I>\n</L>", outdentItems),
              "<L>\n<I><T>{a}</T></I>\n<I>{b|}</I>\n</L>");
    EXPECT_EQ(memo("<P>{|a}</P>", outdentItems), "refused: The selection is in no list.");
    EXPECT_EQ(testGrammars().of("CMEMO")->variants("LIST"),
              (std::vector<Grammar::Variant>{{"KIND", "number"}}));
}

TEST(Authoring, MovesSections) {
    const auto up = [](const Manuscript& manuscript, Selection selection) {
        const std::vector<sgml::NodeId> all = targets(manuscript);
        (void)selection;
        return moveElement(manuscript, all[1], all[0], Direction::backward);
    };
    EXPECT_EQ(report("<S><H>{A}</H></S>\n<S><H>{B|}</H></S>", up),
              "<S><H>{|B}</H></S>\n<S><H>{A}</H></S>");
}

TEST(Authoring, KnowsWhatIsAllowed) {
    const std::string bytes = renamed("DOCUMENT REPORT\n<REPORT><S><H>{a}</H></S></REPORT>", false);
    const document::Document document(bytes);
    const std::vector<std::string> names =
        allowedAt({document, testGrammars()}, bytes.find("{a") + 1);
    const auto has = [&](const std::string& name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    EXPECT_TRUE(has("EMPH") && has("TABLE") && has("SECTION"));
    EXPECT_FALSE(has("HEADING") || has("CAPTION"));
}

TEST(Authoring, PreformattedText) {
    EXPECT_EQ(memo("<P>{a[b}</P>\n<P><E>{c}</E><T>{|d}</T></P>", makeVerbatim),
              "<V>{a[b\nc|d}</V>");
    EXPECT_EQ(memo("<P><T>{a|}</T><IMAGE></IMAGE></P>", makeVerbatim),
              "refused: Preformatted text holds nothing but text.");
    EXPECT_EQ(memo("<V>{a|b}</V>", makeParagraph), "<P>{a|b}</P>");
    const auto shiftEnter = [](const Manuscript& manuscript, Selection selection) {
        return breakLine(manuscript, selection);
    };
    EXPECT_EQ(memo("<V>{a|b}</V>", shiftEnter), "<V>{a\n|b}</V>");
    EXPECT_EQ(memo("<P>{a|b}</P>", shiftEnter),
              "refused: There are no line breaks within a paragraph of this class.");
}

TEST(Authoring, Tables) {
    const auto table = [](const Manuscript& manuscript, Selection selection) {
        return insertTable(manuscript, selection, {2, 2});
    };
    EXPECT_EQ(memo("<P>{|}</P>", table),
              "<TABLE>\n<R><C>{|}</C><C>{}</C></R>\n<R><C>{}</C><C>{}</C></R>\n</TABLE>");
    const auto row = [](const Manuscript& manuscript, Selection selection) {
        return insertRow(manuscript, selection, Direction::forward);
    };
    const auto column = [](const Manuscript& manuscript, Selection selection) {
        return insertColumn(manuscript, selection, Direction::backward);
    };
    const auto tab = [](const Manuscript& manuscript, Selection selection) {
        return goToCell(manuscript, selection, Direction::forward);
    };
    const std::string one =
        "<TABLE>\n<R><C>{a}</C><C>{b|}</C></R>\n<R><C>{c}</C><C>{d}</C></R></TABLE>";
    EXPECT_EQ(memo(one, row), "<TABLE>\n<R><C>{a}</C><C>{b}</C></R>\n<R><C>{}</C><C>{|}</C></R>\n"
                              "<R><C>{c}</C><C>{d}</C></R></TABLE>");
    EXPECT_EQ(memo(one, column), "<TABLE>\n<R><C>{a}</C><C>{|}</C><C>{b}</C></R>\n"
                                 "<R><C>{c}</C><C>{}</C><C>{d}</C></R></TABLE>");
    EXPECT_EQ(memo(one, removeRow), "<TABLE>\n<R><C>{c}</C><C>{|d}</C></R></TABLE>");
    EXPECT_EQ(memo(one, removeColumn), "<TABLE>\n<R><C>{|a}</C></R>\n<R><C>{c}</C></R></TABLE>");
    EXPECT_EQ(memo(one, tab),
              "<TABLE>\n<R><C>{a}</C><C>{b}</C></R>\n<R><C>{|c}</C><C>{d}</C></R></TABLE>");
    EXPECT_EQ(memo("<TABLE><R><C>{a}</C><C><P>{b|}</P></C></R></TABLE>", tab),
              "<TABLE><R><C>{a}</C><C><P>{b}</P></C></R>\n<R><C>{|}</C><C>{}</C></R></TABLE>");
    EXPECT_EQ(memo("<P>{|a}</P>", row), "refused: The caret is in no table.");
}

// A command opens what it edits and its neighbours, however long the document is.
TEST(Authoring, OpensOnlyWhatItEdits) {
    std::string before, behind;
    for (int i = 0; i < 3000; ++i)
        before += "<P>{p}</P>\n";
    behind = "<P>{[o|ne}</P>\n" + before;
    before = memoHead + before;
    const auto opened = [&](const Command& command, const std::string& at) {
        std::string bytes = before + behind;
        const Marked marked = readMarks(renamed(bytes, false));
        const document::Document document(marked.bytes);
        Selection selection = marked.selection;
        if (at.empty())
            selection.anchor = selection.caret = selection.anchor;
        Piece::made = 0;
        EXPECT_TRUE(std::holds_alternative<Step>(command({document, testGrammars()}, selection)));
        return Piece::made;
    };
    behind += memoTail;
    EXPECT_LT(opened(enter, ""), 40u);
    EXPECT_LT(opened(backspace, ""), 60u);
    EXPECT_LT(opened(typed("x"), "selected"), 40u);
    EXPECT_LT(opened(
                  [](const Manuscript& manuscript, Selection selection) {
                      return toggle(manuscript, selection, schemas::ContainerRole::emphasis);
                  },
                  "selected"),
              40u);
    EXPECT_LT(opened([](const Manuscript& manuscript,
                        Selection selection) { return makeList(manuscript, selection); },
                     ""),
              40u);
    EXPECT_LT(opened([](const Manuscript& manuscript,
                        Selection selection) { return insertBlock(manuscript, selection, "RULE"); },
                     ""),
              40u);
}

TEST(Authoring, KnowsThePlacesOfACaret) {
    const std::string bytes = renamed(
        "DOCUMENT CMEMO\n<CMEMO><BODY><P>{a\\{b}</P><P><T>{c}</T><E>{d}</E></P></BODY></CMEMO>",
        false);
    const document::Document document(bytes);
    const Manuscript manuscript{document, testGrammars()};
    const std::size_t a = bytes.find("{a") + 1, c = bytes.find("{c") + 1, d = bytes.find("{d") + 1;
    EXPECT_EQ(place(manuscript, 0, Direction::forward), a);
    EXPECT_EQ(place(manuscript, 0, Direction::backward), std::nullopt);
    EXPECT_EQ(place(manuscript, bytes.size(), Direction::backward), d + 1);
    EXPECT_EQ(place(manuscript, a + 2, Direction::forward), a + 3); // behind the backslash
    EXPECT_EQ(place(manuscript, a + 2, Direction::backward), a + 1);
    std::vector<std::size_t> walked;
    for (std::optional<std::size_t> at = a; at;
         at = placeBeside(manuscript, *at, Direction::forward, Unit::character))
        walked.push_back(*at);
    EXPECT_EQ(walked, (std::vector<std::size_t>{a, a + 1, a + 3, a + 4, c, c + 1, d + 1}));
    walked.clear();
    for (std::optional<std::size_t> at = d + 1; at;
         at = placeBeside(manuscript, *at, Direction::backward, Unit::character))
        walked.push_back(*at);
    EXPECT_EQ(walked, (std::vector<std::size_t>{d + 1, d, c, a + 4, a + 3, a + 1, a}));
    EXPECT_EQ(lineAround(manuscript, c + 1), (Selection{c, d + 1}));
    EXPECT_EQ(everything(manuscript, c), (Selection{a, d + 1}));
}

TEST(Authoring, APlaceInALongDocumentIsFoundWithoutALookAtEachParagraphBefore) {
    std::string text = "DOCUMENT CMEMO\n<CMEMO>\n<BODY>\n";
    for (int i = 0; i < 1000; ++i)
        text += "<PARAGRAPH>{a}</PARAGRAPH>\n";
    const document::Document document(text + "<PARAGRAPH>{here}</PARAGRAPH>\n</BODY>\n</CMEMO>\n");
    const Manuscript manuscript{document, testGrammars()};
    const std::size_t place = document.bytes().find("here") + 2;
    const manuscript::Leaves leaves(manuscript, place);
    EXPECT_TRUE(leaves.isContent(leaves.at(place)));
    EXPECT_LE(leaves.judged(), 20u);
}

TEST(Authoring, BehindWhatEndsADocumentAParagraphIsMade) {
    EXPECT_EQ(memo("<TABLE><R><C>{a|}</C><C>{b}</C></R></TABLE>", goBehindEnd),
              "<TABLE><R><C>{a}</C><C>{b}</C></R></TABLE>\n<P>{|}</P>");
    EXPECT_EQ(report("<BODY><S>\n<H>{h|}</H>\n<V>{a}</V>\n</S></BODY>", goBehindEnd),
              "<BODY><S>\n<H>{h}</H>\n<V>{a}</V>\n<P>{|}</P>\n</S></BODY>");
    EXPECT_EQ(memo("<P>{a|}</P>\n<FIGURE><IMAGE></IMAGE></FIGURE>", goBehindEnd),
              "<P>{a}</P>\n<FIGURE><IMAGE></IMAGE></FIGURE>\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{a|}</P>\n<FORMULA KIND=\"display\">{x}</FORMULA>", goBehindEnd),
              "<P>{a}</P>\n<FORMULA KIND=\"display\">{x}</FORMULA>\n<P>{|}</P>");
    const std::string refused = "refused: The document ends with a line for text already.";
    EXPECT_EQ(memo("<TABLE><R><C>{a|}</C></R></TABLE>\n<P></P>", goBehindEnd), refused);
    EXPECT_EQ(memo("<L><I>{a|}</I></L>", goBehindEnd), refused); // Enter leads out of it
}

} // namespace
} // namespace authoring
