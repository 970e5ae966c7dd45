// Footnotes, figures, formulas, references and values come in; text and structure are pasted.
#include "authoring/command_testing.h"
#include "authoring/images.h"

namespace authoring {
namespace {

TEST(Inserting, InsertsFootnotes) {
    EXPECT_EQ(memo("<P>{a|b}</P>", insertFootnote), "<P><T>{a}</T><F>{|}</F><T>{b}</T></P>");
    EXPECT_EQ(memo("<P><E>{a|}</E></P>", insertFootnote), "<P><E><T>{a}</T><F>{|}</F></E></P>");
    EXPECT_EQ(memo("<V>{a|b}</V>", insertFootnote), "refused: A footnote may not stand here.");
}

TEST(Inserting, InsertsBlocks) {
    const auto put = [](const std::string& name) {
        return [name](const Manuscript& manuscript, Selection selection) {
            return insertBlock(manuscript, selection, name);
        };
    };
    EXPECT_EQ(memo("<P>{a|b}</P>", put("PAGEBREAK")),
              "<P>{a}</P>\n<PAGEBREAK></PAGEBREAK>\n<P>{|b}</P>");
    EXPECT_EQ(memo("<P>{a|}</P>", put("PAGEBREAK")),
              "<P>{a}</P>\n<PAGEBREAK></PAGEBREAK>\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{|}</P>", put("PAGEBREAK")), "<PAGEBREAK></PAGEBREAK>\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{a}</P>\n<P>{|b}</P>", put("PAGEBREAK")),
              "<P>{a}</P>\n<PAGEBREAK></PAGEBREAK>\n<P>{|b}</P>");
    EXPECT_EQ(memo("<TABLE><R><C>{a|b}</C></R></TABLE>", put("PAGEBREAK")),
              "refused: A page break may not stand in a table.");
    EXPECT_EQ(memo("<P><T>{a}</T><F>{b|}</F></P>", put("PAGEBREAK")),
              "refused: A page break may not stand in a footnote.");
    EXPECT_EQ(memo("<P>{a|}</P>", put("RULE")), "<P>{a|}</P>\n<RULE></RULE>");
    EXPECT_EQ(memo("<P>{|}</P>", put("VERBATIM")), "<V>{|}</V>");
    EXPECT_EQ(memo("<P>{a|}</P>", put("VERBATIM")), "<P>{a}</P>\n<V>{|}</V>");
    EXPECT_EQ(report("<S>\n<H>{a|}</H>\n</S>", put("LIST")),
              "<S>\n<H>{a}</H>\n<L><I>{|}</I></L>\n</S>");
    EXPECT_EQ(memo("<P>{a|}</P>", put("ABSTRACT")),
              "refused: This class of documents has no such element.");
    const auto figure = [](const Manuscript& manuscript, Selection selection) {
        return insertFigure(manuscript, selection, {"ANIMATION", "ASGARD", "a {"});
    };
    EXPECT_EQ(memo("<P>{a|}</P>", figure),
              "<P>{a}</P>\n<FIGURE>\n<DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION>\n<ASGARD>{a "
              "\\{}</ASGARD>\n</ANIMATION>\n</DOCUMENT>\n<CAPTION>{|}</CAPTION>\n</FIGURE>");
    EXPECT_EQ(memo("<FIGURE><IMAGE></IMAGE>|</FIGURE>", insertCaption),
              "<FIGURE><IMAGE></IMAGE>\n<CAPTION>{|}</CAPTION></FIGURE>");
    EXPECT_EQ(memo("<P>{|a}</P>", insertCaption), "refused: Nothing here takes a caption.");
}

// A command on the first element of that name, or on its figure.
Command onElement(const std::string& name, bool whole,
                  const std::function<Result(const Manuscript&, sgml::NodeId)>& command) {
    return [=](const Manuscript& manuscript, Selection) {
        const sgml::Tree& tree = manuscript.document.tree();
        sgml::NodeId id = tree.root();
        while (!tree.isElement(id) || tree.name(id) != name)
            id = tree.following(id);
        return command(manuscript, whole ? wholeFigure(manuscript, id) : id);
    };
}

TEST(Inserting, AFigureGoesWithItsCaptionAndAloneWhereItIsNotAlone) {
    const Command removed =
        onElement("DOCUMENT", true, [](const Manuscript& manuscript, sgml::NodeId element) {
            return removeElement(manuscript, element, "Delete Figure");
        });
    const std::string scene =
        "<DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION><ASGARD>{a}</ASGARD></ANIMATION>\n</DOCUMENT>";
    EXPECT_EQ(
        memo("<P>{a|}</P>\n<FIGURE>" + scene + "\n<CAPTION>{c}</CAPTION></FIGURE>\n<P>{b}</P>",
             removed),
        "<P>{a}</P>\n<P>{|b}</P>");
    EXPECT_EQ(memo("<P>{a|}</P>\n<FIGURE>" + scene + "<IMAGE></IMAGE></FIGURE>", removed),
              "<P>{a}</P>\n<FIGURE>|<IMAGE></IMAGE></FIGURE>");
    EXPECT_EQ(memo("<P><T>{a|}</T>" + scene + "<T>{b}</T></P>", removed), "<P><T>{a|b}</T></P>");
    EXPECT_EQ(memo("<P>" + scene + "</P>\n<P>{a|}</P>", removed), "<P>{|}</P>\n<P>{a}</P>");
}

TEST(Inserting, WhatLiesInADocumentOfAMediumIsNotRemoved) {
    const Command removed =
        onElement("IMAGE", false, [](const Manuscript& manuscript, sgml::NodeId element) {
            return removeElement(manuscript, element, "Delete Figure");
        });
    EXPECT_EQ(memo("<P>{a|}</P>\n<DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION><IMAGE></IMAGE>"
                   "</ANIMATION>\n</DOCUMENT>",
                   removed),
              "refused: What was to be changed is not there any more.");
}

TEST(Inserting, WhatIsPastedHasIdsOfItsOwnThatItsReferencesFollow) {
    const auto pasted = [](const std::string& fragment) {
        return [fragment](const Manuscript& manuscript, Selection selection) {
            return paste(manuscript, selection, renamed("<BODY>" + fragment + "</BODY>", false));
        };
    };
    const std::string copied = "<P ID=\"a-1\">{c}</P><P><REF TO=\"a-1\"></REF></P>";
    EXPECT_EQ(memo("<P ID=\"a-1\">{x}</P>\n<P>{|}</P>", pasted(copied)),
              "<P ID=\"a-1\">{x}</P>\n<P ID=\"a-2\">{c}</P>\n<P><REF TO=\"a-2\"></REF>|</P>");
    EXPECT_EQ(memo("<P>{|}</P>", pasted(copied)),
              "<P ID=\"a-1\">{c}</P>\n<P><REF TO=\"a-1\"></REF>|</P>");
    EXPECT_EQ(memo("<P ID=\"a-1\">{x}</P>\n<P>{|}</P>", pasted("<P ID=\"a-1\">{c}</P><V>{d}</V>")),
              "<P ID=\"a-1\">{x}</P>\n<P>{c}</P>\n<V>{d|}</V>");
}

TEST(Inserting, PastedBlocksStandOnLinesOfTheirOwn) {
    const auto pasted = [](const std::string& fragment) {
        return [fragment](const Manuscript& manuscript, Selection selection) {
            return paste(manuscript, selection, renamed("<BODY>" + fragment + "</BODY>", false));
        };
    };
    EXPECT_EQ(memo("<P>{|}</P>", pasted("<L><I>{a}</I><I>{b}</I></L><TABLE><R><C>{c}</C><C>{d}</C>"
                                        "</R><R><C>{e}</C><C>{f}</C></R></TABLE><P>{g}</P>")),
              "<L>\n<I>{a}</I>\n<I>{b}</I>\n</L>\n<TABLE>\n<R><C>{c}</C><C>{d}</C></R>\n"
              "<R><C>{e}</C><C>{f}</C></R>\n</TABLE>\n<P>{g|}</P>");
    EXPECT_EQ(memo("<TABLE><R><C>{|}</C></R></TABLE>", pasted("<P>{a}</P><P>{b}</P>")),
              "<TABLE><R><C>\n<P>{a}</P>\n<P>{b|}</P></C></R></TABLE>");
    EXPECT_EQ(memo("<TABLE><R><C>{x|}</C></R></TABLE>", pasted("<P>{a}</P><P>{b}</P>")),
              "<TABLE><R><C><T>{x}</T>\n<P>{a}</P>\n<P>{b|}</P></C></R></TABLE>");
    EXPECT_EQ(memo("<TABLE><R><C>{x|y}</C></R></TABLE>", pasted("<P>{a}</P><P>{b}</P>")),
              "<TABLE><R><C><T>{x}</T>\n<P>{a}</P>\n<P>{b}</P><T>{|y}</T></C></R></TABLE>");
    EXPECT_EQ(memo("<TABLE><R><C>{|}</C></R></TABLE>", pasted("<L><I>{a}</I><I>{b}</I></L>")),
              "<TABLE><R><C>\n<L>\n<I>{a}</I>\n<I>{b|}</I>\n</L></C></R></TABLE>");
}

TEST(Inserting, AttributesAreSetAndRemovedInOneStep) {
    const auto sized = [](const std::string& width) {
        return [width](const Manuscript& manuscript, Selection selection) {
            const auto id = manuscript.document.subdocuments().front();
            return setAttributes(manuscript, selection,
                                 manuscript.document.subdocument(id)->classElement,
                                 {{"WIDTH", width}, {"HEIGHT", "20"}, {"ALT", ""}}, "Size");
        };
    };
    const auto scene = [](const std::string& attributes) {
        return "<P>{a}</P>\n<DOCUMENT>\nDOCUMENT ANIMATION\n<ANIMATION" + attributes +
               "></ANIMATION>\n</DOCUMENT>\n<P>{b|c}</P>";
    };
    EXPECT_EQ(memo(scene(""), sized("10")), scene(" WIDTH=\"10\" HEIGHT=\"20\""));
    EXPECT_EQ(memo(scene(" HEIGHT=\"5\" ALT=\"x\""), sized("10")),
              scene(" HEIGHT=\"20\" WIDTH=\"10\""));
    EXPECT_EQ(memo(scene(" WIDTH=\"1\" HEIGHT=\"20\""), sized("")), scene(" HEIGHT=\"20\""));
}

TEST(Inserting, Formulas) {
    const auto formula = [](const std::string& kind) {
        return [kind](const Manuscript& manuscript, Selection selection) {
            return insertFormula(manuscript, selection, "x^{2}", kind);
        };
    };
    EXPECT_EQ(memo("<P>{a|b}</P>", formula("")),
              "<P><T>{a}</T><FORMULA>{x^\\{2\\}}</FORMULA><T>{|b}</T></P>");
    EXPECT_EQ(memo("<P>{a|}</P>", formula("")), "<P><T>{a}</T><FORMULA>{x^\\{2\\}}</FORMULA>|</P>");
    EXPECT_EQ(memo("<P>{a|}</P>", formula(" KIND=\"display\"")),
              "<P><T>{a}</T>\n<FORMULA KIND=\"display\">{x^\\{2\\}}</FORMULA>|</P>");
    EXPECT_EQ(memo("<P>{|}</P>", formula(" KIND=\"display\"")),
              "<P>\n<FORMULA KIND=\"display\">{x^\\{2\\}}</FORMULA><T>{|}</T></P>");
    const auto changed = [](const Manuscript& manuscript, Selection selection) {
        const sgml::Tree& tree = manuscript.document.tree();
        sgml::NodeId element = tree.innermostAt(selection.caret);
        while (tree.name(element) != "FORMULA")
            element = tree.node(element).parent;
        return setText(manuscript, element, "z}");
    };
    EXPECT_EQ(memo("<P><FORMULA>{x|y}</FORMULA></P>", changed),
              "<P><FORMULA>{z\\}}</FORMULA>|</P>");
    EXPECT_EQ(memo("<P><FORMULA>|</FORMULA></P>", changed), "<P><FORMULA>{z\\}}</FORMULA>|</P>");
}

TEST(Inserting, BehindAnImageOneWritesOn) {
    const auto image = [](const Manuscript& manuscript, Selection selection) {
        return insertImage(manuscript, selection, {.file = "x.png"});
    };
    const std::string figure = "<FIGURE><IMAGE FILE=\"x.png\"></IMAGE></FIGURE>";
    EXPECT_EQ(memo("<P>{a|}</P>", image), "<P>{a}</P>\n" + figure + "\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{|}</P>", image), figure + "\n<P>{|}</P>");
    EXPECT_EQ(memo("<P>{|a}</P>", image), figure + "\n<P>{|a}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", image), "<P>{a}</P>\n" + figure + "\n<P>{|b}</P>");
}

TEST(Inserting, ReferencesNameTheirTargets) {
    const auto refer = [](const Manuscript& manuscript, Selection selection) {
        return insertReference(manuscript, selection, targets(manuscript).front());
    };
    EXPECT_EQ(memo("<P>{a|b}</P><FIGURE><IMAGE></IMAGE></FIGURE>", refer),
              "<P><T>{a}</T><REF TO=\"figure-1\"></REF><T>{|b}</T></P><FIGURE "
              "ID=\"figure-1\"><IMAGE></IMAGE></FIGURE>");
    EXPECT_EQ(memo("<P>{a|}</P><FIGURE ID=\"x\"><IMAGE></IMAGE></FIGURE>", refer),
              "<P><T>{a}</T><REF TO=\"x\"></REF>|</P><FIGURE ID=\"x\"><IMAGE></IMAGE></FIGURE>");
}

TEST(Inserting, AReferenceIsLedElsewhere) {
    const auto change = [](const Manuscript& manuscript, Selection selection) {
        const sgml::Tree& tree = manuscript.document.tree();
        sgml::NodeId reference = tree.root();
        while (tree.name(reference) != "REF")
            reference = tree.following(reference);
        return changeReference(manuscript, selection, reference, targets(manuscript).back(),
                               ReferBy::kindAndNumber);
    };
    const std::string other = "<FIGURE ID=\"x\"><IMAGE></IMAGE></FIGURE>";
    EXPECT_EQ(
        memo("<P><REF TO=\"x\"></REF></P>" + other + "<FIGURE><IMAGE></IMAGE></FIGURE><P>{b|}</P>",
             change),
        "<P><REF TO=\"figure-1\"></REF></P>" + other +
            "<FIGURE ID=\"figure-1\"><IMAGE></IMAGE></FIGURE><P>{b|}</P>");
}

TEST(Inserting, ValuesNameTheirFigureWhichGetsAnId) {
    const auto insert = [](const document::ValueUse& use) {
        return [use](const Manuscript& manuscript, Selection selection) {
            const document::Document& of = manuscript.document;
            return insertValue(manuscript, selection,
                               of.subdocument(of.subdocuments().back())->element, use);
        };
    };
    const auto figure = [](const std::string& attributes) {
        return "<P><DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION" + attributes +
               "><ASGARD>{}</ASGARD></ANIMATION></DOCUMENT></P>";
    };
    const document::ValueUse height{.of = {}, .expression = "b.y"};
    EXPECT_EQ(memo(figure("") + "<P>{a|b}</P>", insert(height)),
              figure(" ID=\"animation-1\"") +
                  "<P><T>{a}</T><VALUE OF=\"animation-1\" EXPRESSION=\"b.y\"></VALUE><T>{|b}</T>"
                  "</P>");
    EXPECT_EQ(memo("<P>{a[b|}</P>" + figure(" ID=\"x\""),
                   insert({.of = {},
                           .expression = "b.y",
                           .time = 2.5,
                           .digits = {.count = 2, .areDecimals = true}})),
              "<P><T>{a}</T><VALUE OF=\"x\" EXPRESSION=\"b.y\" FORMAT=\"2 decimals\" TIME=\"2.5 "
              "s\"></VALUE>|</P>" +
                  figure(" ID=\"x\""));
    const auto change = [&](const Manuscript& manuscript, Selection selection) {
        const document::Document& of = manuscript.document;
        const sgml::NodeId element = of.tree().innermostAt(of.bytes().find("<VALUE") + 1);
        return changeValue(manuscript, selection, element,
                           of.subdocument(of.subdocuments().front())->element, height);
    };
    EXPECT_EQ(memo("<P><T>{a|}</T><VALUE OF=\"x\" EXPRESSION=\"c\" TIME=\"1\"></VALUE></P>" +
                       figure(" ID=\"x\""),
                   change),
              "<P><T>{a|}</T><VALUE OF=\"x\" EXPRESSION=\"b.y\"></VALUE></P>" +
                  figure(" ID=\"x\""));
}

TEST(Inserting, PastesText) {
    const auto text = [](const std::string& pasted) {
        return [pasted](const Manuscript& manuscript, Selection selection) {
            return pasteText(manuscript, selection, pasted);
        };
    };
    EXPECT_EQ(memo("<P>{a|b}</P>", text("1\n2")), "<P>{a1 2|b}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", text("1\n\n2\n\n\n3")), "<P>{a1}</P>\n<P>{2}</P>\n<P>{3|b}</P>");
    EXPECT_EQ(memo("<L><I>{a[b|}</I></L>", text("1\n\n2")), "<L><I>{a1}</I>\n<I>{2|}</I></L>");
    EXPECT_EQ(memo("<V>{a|b}</V>", text("1\n\n2")), "<V>{a1\n\n2|b}</V>");
    EXPECT_EQ(memo("<FIGURE><IMAGE></IMAGE><CAPTION>{a|b}</CAPTION></FIGURE>", text("1\n\n2")),
              "<FIGURE><IMAGE></IMAGE><CAPTION>{a1 2|b}</CAPTION></FIGURE>");
}

// A copy that begins within an element has not its beginning: a section without its heading.
TEST(Inserting, PastesWhatWasCopiedAcrossTheEdgeOfAnElement) {
    const auto copied = [](const std::string& fragment) {
        return [fragment](const Manuscript& manuscript, Selection selection) {
            return paste(manuscript, selection, renamed(fragment, false));
        };
    };
    const std::string sections = "<BODY><S><L><I>{2}</I><I>{3}</I></L></S>"
                                 "<S><H>{B}</H><P>{half}</P></S></BODY>";
    EXPECT_EQ(memo("<P>{|}</P>", copied(sections)),
              "<L>\n<I>{2}</I>\n<I>{3}</I>\n</L>\n<S>\n<H>{B}</H>\n<P>{half|}</P>\n</S>");
    EXPECT_EQ(memo("<P>{x|y}</P>", copied(sections)),
              "<P>{x}</P>\n<L>\n<I>{2}</I>\n<I>{3}</I>\n</L>\n"
              "<S>\n<H>{B}</H>\n<P>{half}</P>\n</S>\n<P>{|y}</P>");
    // Two paragraphs of one section, and of one in it.
    EXPECT_EQ(memo("<P>{|}</P>", copied("<S><P>{a}</P><P>{b}</P></S>")), "<P>{a}</P>\n<P>{b|}</P>");
    EXPECT_EQ(memo("<P>{|}</P>", copied("<S><S><P>{a}</P></S>"
                                        "<S><H>{C}</H><P>{b}</P></S></S>")),
              "<P>{a}</P>\n<S>\n<H>{C}</H>\n<P>{b|}</P>\n</S>");
    // A whole section stays one.
    EXPECT_EQ(memo("<P>{|}</P>", copied("<S><H>{A}</H><P>{a}</P></S>")),
              "<S>\n<H>{A}</H>\n<P>{a|}</P>\n</S>");
    // From a caption into the text below; the figure was not copied.
    EXPECT_EQ(memo("<P>{|}</P>", copied("<BODY><FIGURE><CAPTION>{c}</CAPTION></FIGURE>"
                                        "<P>{b}</P></BODY>")),
              "<P>{c}</P>\n<P>{b|}</P>");
    // A section that may not stand there leaves its heading as a paragraph.
    EXPECT_EQ(memo("<TABLE><R><C><P>{|}</P></C></R></TABLE>", copied(sections)),
              "<TABLE><R><C><L>\n<I>{2}</I>\n<I>{3}</I>\n</L>\n<P>{B}</P>\n<P>{half|}</P></C>"
              "</R></TABLE>");
}

TEST(Inserting, PastesStructure) {
    const auto elements = [](const std::string& pasted) {
        return [pasted](const Manuscript& manuscript, Selection selection) {
            return paste(manuscript, selection, renamed(pasted, false));
        };
    };
    EXPECT_EQ(memo("<P>{a|b}</P>", elements("<P>{1}</P>")), "<P>{a1|b}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", elements("<P><T>{1}</T><E>{2}</E></P>")),
              "<P><T>{a1}</T><E>{2}</E><T>{|b}</T></P>");
    EXPECT_EQ(memo("<P ID=\"i\">{a|b}</P>", elements("<BODY><P ID=\"i\">{1}</P><P>{2}</P></BODY>")),
              "<P ID=\"i\">{a}</P>\n<P>{1}</P>\n<P>{2}</P>\n<P>{|b}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", elements("<L><I>{1}</I></L>")),
              "<P>{a}</P>\n<L>\n<I>{1}</I>\n</L>\n<P>{|b}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", elements("<AUTHOR>{1}</AUTHOR>")), "<P>{a1|b}</P>");
    EXPECT_EQ(memo("<P>{a|b}</P>", elements("<P>{1}")),
              "refused: The clipboard holds nothing that can be read.");
}

} // namespace
} // namespace authoring
