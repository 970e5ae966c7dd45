#include "document/document.h"
#include "document/tracker.h"
#include "sgml/random_document.h"
#include "sgml/work.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace document {

namespace {

std::string readSample(const std::string& name) {
    std::ifstream file(SOURCE_DIR "/samples/" + name, std::ios::binary);
    std::ostringstream bytes;
    bytes << file.rdbuf();
    return bytes.str();
}

const std::string twoScenes =
    "DOCUMENT CMEMO\n<CMEMO><BODY>\n"
    "<DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION ID=\"one\" WIDTH=\"300\" ALIGN=\"right\" "
    "ALT=\"first\">"
    "<ASGARD>{a \\{1\\}\nb {2}}</ASGARD></ANIMATION></DOCUMENT>\n"
    "<DOCUMENT>DOCUMENT CHART\n<CHART ID=\"two\" WIDTH=\"wide\"><DATA></DATA></CHART></DOCUMENT>\n"
    "</BODY></CMEMO>\n";

// A memo whose one animation, "one", has these bytes as its storage.
std::string memoWith(const std::string& storage) {
    return "DOCUMENT CMEMO\n<CMEMO><PARAGRAPH><DOCUMENT>\nDOCUMENT ANIMATION\n"
           "<ANIMATION ID=\"one\">" +
           storage + "</ANIMATION></DOCUMENT></PARAGRAPH></CMEMO>";
}

// The announced edits of texts, as a medium would apply it.
struct Mirror {
    std::string text;
    int revision = 0;
    SubdocumentId id;
    Mirror(Document& document, SubdocumentId of) : text(document.text(of)), id(of) {
        QObject::connect(
            &document, &Document::textChanged, &document,
            [this](SubdocumentId changed, const text::Edits& edits, int now, const QString&) {
                if (changed != id)
                    return;
                text = text::applied(text, edits);
                EXPECT_GT(now, revision);
                revision = now;
            });
    }
};

// A letter at the caret, as a view types it.
void typeLetter(Document& document, Selection& selection, char letter, int milliseconds,
                const QString& label = "Typing") {
    const Selection after{selection.caret + 1, selection.caret + 1};
    EXPECT_EQ(document.edit({{{selection.caret, selection.caret}, std::string(1, letter)}},
                            EditNote{.label = label,
                                     .before = selection,
                                     .after = after,
                                     .typed = std::chrono::milliseconds(milliseconds)}),
              EditResult::applied);
    selection = after;
}

} // namespace

TEST(Document, DescribesItsSubdocuments) {
    const Document document(twoScenes);
    ASSERT_EQ(document.subdocuments().size(), 2u);
    const Subdocument& one = *document.subdocument(document.subdocumentNamed("one"));
    EXPECT_EQ(one.className, "ANIMATION");
    EXPECT_EQ(one.storage, "ASGARD");
    EXPECT_EQ(one.width, 300);
    EXPECT_EQ(one.height, std::nullopt);
    EXPECT_EQ(one.placement, Placement::right);
    EXPECT_EQ(one.alternative, "first");
    EXPECT_EQ(document.text(one.id), "a {1}\nb {2}");
    const Subdocument& two = *document.subdocument(document.subdocumentNamed("two"));
    EXPECT_EQ(two.width, std::nullopt); // senseless
    EXPECT_TRUE(two.hasText);
    EXPECT_EQ(document.text(two.id), "");
}

// The medium counts in its own text; the file spells some characters with two bytes.
TEST(Document, PlacesOfAMediumBecomePlacesOfTheFile) {
    const Document document(twoScenes);
    const SubdocumentId one = document.subdocumentNamed("one");
    const text::Position start = document.filePosition(one, {1, 1});
    EXPECT_EQ(document.bytes().substr(text::Places(document.bytes()).offset(start), 4), "a \\{");
    EXPECT_EQ(document.filePosition(one, {1, 4}).column, start.column + 4);
    EXPECT_EQ(document.filePosition(one, {2, 3}), (text::Position{start.line + 1, 3}));
}

TEST(Document, EditsOfATextAreAnnouncedCheckedAndUndone) {
    Document document(twoScenes);
    const SubdocumentId one = document.subdocumentNamed("one");
    Mirror mirror(document, one);
    EXPECT_EQ(document.editText(one, 0, {{{3, 4}, "{7}"}}, "Move"), EditResult::applied);
    EXPECT_EQ(document.text(one), "a {{7}}\nb {2}");
    EXPECT_EQ(mirror.text, document.text(one));
    EXPECT_NE(document.bytes().find("{a \\{\\{7\\}\\}\nb {2}}"), std::string::npos)
        << "the rest keeps its spelling";
    EXPECT_EQ(document.editText(one, 0, {{{0, 1}, "x"}}, "Late"), EditResult::stale);
    EXPECT_EQ(document.editText(one, 1, {{{5, 99}, "x"}}, "Far"), EditResult::invalid);
    EXPECT_EQ(document.editText(one, 1, {{{0, 0}, "\xFF"}}, "Bytes"), EditResult::invalid);
    EXPECT_EQ(document.editText(one, 1, {{{0, 1}, "a"}}, "Same"), EditResult::nothing);
    EXPECT_EQ(document.editText(99, 1, {{{0, 1}, "a"}}, "Who"), EditResult::unknown);
    EXPECT_TRUE(document.isModified());
    EXPECT_EQ(document.undoLabel(), "Move");
    document.undo();
    EXPECT_EQ(document.bytes(), twoScenes);
    EXPECT_EQ(mirror.text, document.text(one));
    EXPECT_FALSE(document.isModified());
    EXPECT_EQ(document.redoLabel(), "Move");
}

// A copy of the bytes follows by the announced edits alone.
TEST(Document, EachChangeOfTheBytesIsAnnounced) {
    Document document(twoScenes);
    std::string bytes = document.bytes();
    int steps = 0;
    QObject::connect(&document, &Document::edited, &document, [&](const sgml::Change& change) {
        bytes = text::applied(bytes, change.edits);
        EXPECT_EQ(bytes, document.bytes());
    });
    QObject::connect(&document, &Document::changed, &document, [&] { ++steps; });
    const SubdocumentId one = document.subdocumentNamed("one");
    (void)document.editText(one, 0, {{{0, 1}, "x"}}, "Type", "typing");
    (void)document.editText(one, 1, {{{1, 1}, "y"}}, "Type", "typing");
    (void)document.edit({{{0, 8}, "DOCUMENT "}, {{16, 16}, "<TO>{you}</TO>"}}, "Insert");
    document.undo();
    document.undo();
    EXPECT_EQ(bytes, twoScenes);
    document.redo();
    EXPECT_EQ(steps, 6);
}

TEST(Document, AStorageWithoutBracesTakesText) {
    Document document(twoScenes);
    const SubdocumentId two = document.subdocumentNamed("two");
    Mirror mirror(document, two);
    EXPECT_EQ(document.editText(two, 0, {{{0, 0}, "1 {2}"}}, "Fill"), EditResult::applied);
    EXPECT_NE(document.bytes().find("<DATA>{1 \\{2\\}}</DATA>"), std::string::npos);
    EXPECT_EQ(mirror.text, "1 {2}");
}

TEST(Document, EditsOfOneGroupAreOneStep) {
    Document document(twoScenes);
    const SubdocumentId one = document.subdocumentNamed("one");
    Mirror mirror(document, one);
    for (int i = 0; i < 5; ++i)
        EXPECT_EQ(document.editText(one, i, {{{0, 1}, std::string(1, static_cast<char>('p' + i))}},
                                    "Drag", "d1"),
                  EditResult::applied);
    EXPECT_EQ(document.editText(one, 5, {{{0, 1}, "z"}}, "Drag", "d2"), EditResult::applied);
    document.undo();
    EXPECT_EQ(document.text(one)[0], 't');
    document.undo();
    EXPECT_EQ(document.bytes(), twoScenes);
    EXPECT_EQ(mirror.text, document.text(one));
    EXPECT_FALSE(document.canUndo());
}

TEST(Document, TypingIsGroupedByPauseAndPlaceAndUndoRestoresTheSelection) {
    const std::string first = "DOCUMENT A\n<A>{one two}</A>";
    Document document(first);
    std::vector<Selection> restored;
    QObject::connect(&document, &Document::selectionRestored, &document,
                     [&](const Selection& selection) { restored.push_back(selection); });
    const std::size_t at = first.find("one");
    Selection caret{at, at};
    for (int i = 0; i < 5; ++i)
        typeLetter(document, caret, static_cast<char>('a' + i), 900 * i);
    EXPECT_EQ(document.steps(), 1u);
    typeLetter(document, caret, 'x', 10'000); // a pause
    EXPECT_EQ(document.steps(), 2u);
    caret = {at, at}; // another place
    typeLetter(document, caret, 'y', 10'010);
    EXPECT_EQ(document.steps(), 3u);
    typeLetter(document, caret, 'z', 10'020, "Paste"); // another kind
    EXPECT_EQ(document.steps(), 4u);
    EXPECT_EQ(document.bytes(), "DOCUMENT A\n<A>{yzabcdexone two}</A>");

    document.undo();
    document.undo();
    document.undo();
    const Selection end{at + 5, at + 5};
    EXPECT_EQ(restored, (std::vector<Selection>{{at + 1, at + 1}, {at, at}, end}));
    caret = end; // what is typed behind an undo is a step of its own
    typeLetter(document, caret, 'f', 4'000);
    EXPECT_EQ(document.steps(), 2u);
    document.undo();
    document.undo();
    EXPECT_EQ(restored.back(), (Selection{at, at}));
    EXPECT_EQ(document.bytes(), first);
    document.redo();
    EXPECT_EQ(restored.back(), end);

    restored.clear();
    EXPECT_EQ(document.edit({{{at, at + 5}, ""}}, "Other"), EditResult::applied);
    document.undo();
    EXPECT_TRUE(restored.empty()) << "a step without a selection";
}

TEST(Document, LettersTypedInARowAreOneChangeAndPlacesInThemComeBack) {
    const std::string first = "DOCUMENT A\n<A>{one two}</A>";
    Document document(first);
    Tracker tracker(document);
    const std::size_t at = first.find("one") + 3;
    Selection caret{at, at};
    std::shared_ptr<const Tracker::Place> place;
    for (int i = 0; i < 1000; ++i) {
        typeLetter(document, caret, static_cast<char>('a' + i % 26), i);
        if (i == 500)
            place = tracker.track(caret.caret, text::Gravity::before);
    }
    EXPECT_EQ(document.keptChanges(), 1u);
    const std::string typed = document.bytes();
    const std::size_t inside = place->offset;
    for (int i = 0; i < 2; ++i) {
        document.undo();
        EXPECT_EQ(document.bytes(), first);
        EXPECT_EQ(place->offset, at);
        document.redo();
        EXPECT_EQ(document.bytes(), typed);
        EXPECT_EQ(place->offset, inside);
    }
    caret = {at, at}; // not behind them
    typeLetter(document, caret, 'x', 1000);
    EXPECT_EQ(document.keptChanges(), 2u);
}

TEST(Document, SubdocumentsKeepTheirNumberThroughEditsAndComeBackWithIt) {
    Document document(twoScenes);
    const SubdocumentId one = document.subdocumentNamed("one"),
                        two = document.subdocumentNamed("two");
    const std::size_t body = twoScenes.find("<BODY>") + 6;
    const std::string third =
        "<DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION ID=\"new\"></ANIMATION></DOCUMENT>";
    document.edit({{{body, body}, third}}, "Insert");
    ASSERT_EQ(document.subdocuments().size(), 3u);
    const SubdocumentId added = document.subdocuments()[0];
    EXPECT_EQ(document.subdocuments(), (std::vector<SubdocumentId>{added, one, two}));
    const sgml::Node& node = document.tree().node(document.subdocument(one)->element);
    document.edit({{node.range, ""}}, "Delete");
    EXPECT_EQ(document.subdocuments(), (std::vector<SubdocumentId>{added, two}));
    document.undo();
    EXPECT_EQ(document.subdocuments(), (std::vector<SubdocumentId>{added, one, two}));
    document.undo();
    EXPECT_EQ(document.subdocuments(), (std::vector<SubdocumentId>{one, two}));
    document.redo();
    document.redo();
    EXPECT_EQ(document.subdocuments(), (std::vector<SubdocumentId>{added, two}));
}

// Other tags say where such a text ends: "{>" and "{aXb<" would be read back otherwise.
TEST(Document, ATextThatNoBraceClosesIsNotEdited) {
    Document document(memoWith("<ASGARD>{a</ASGARD>"));
    const SubdocumentId one = document.subdocumentNamed("one");
    ASSERT_NE(document.subdocument(one), nullptr);
    EXPECT_EQ(document.text(one), "a");
    EXPECT_EQ(document.editText(one, 0, {{{0, 0}, "b"}}, "Type"), EditResult::unknown);
}

// Text written behind a tag that is not closed would be read as a part of the tag.
TEST(Document, AStorageWhoseTagIsNotClosedHasNoText) {
    Document document(memoWith("<ASGARD C{a}</ASGARD>"));
    const SubdocumentId one = document.subdocumentNamed("one");
    ASSERT_NE(document.subdocument(one), nullptr);
    EXPECT_EQ(document.editText(one, 0, {{{0, 0}, "b"}}, "Type"), EditResult::unknown);
}

// Undo to the start gives the first bytes, redo to the end the last; every listener keeps up.
TEST(Document, RandomEditsUndoAndRedoExactly) {
    sgml::RandomDocument random(40);
    for (int round = 0; round < 60; ++round) {
        const std::string first = round % 3 == 0 ? twoScenes : random.sound();
        Document document(first);
        std::vector<std::unique_ptr<Mirror>> mirrors;
        for (const SubdocumentId id : document.subdocuments())
            mirrors.push_back(std::make_unique<Mirror>(document, id));
        for (int step = 0; step < 40; ++step) {
            const std::vector<SubdocumentId> ids = document.subdocuments();
            const std::size_t kind = random.below(8);
            if (kind == 0) {
                document.undo();
            } else if (kind == 1) {
                document.redo();
            } else if (kind == 2) {
                const std::size_t at = random.below(document.bytes().size() + 1);
                (void)document.edit({{{at, std::min(at + random.below(9), document.bytes().size())},
                                      random.text(2)}},
                                    "Bytes");
            } else if (!ids.empty()) {
                const SubdocumentId id = ids[random.below(ids.size())];
                const std::size_t size = document.text(id).size();
                const std::size_t from = random.below(size + 1);
                (void)document.editText(
                    id, document.subdocument(id)->revision,
                    {{{from, from + random.below(size - from + 1)}, random.text(3)}}, "Text",
                    kind == 3 ? "group" : "");
            }
        }
        const std::string last = document.bytes();
        const auto expectMirrored = [&] {
            for (const auto& mirror : mirrors)
                if (document.subdocument(mirror->id) != nullptr) {
                    EXPECT_EQ(mirror->text, document.text(mirror->id));
                }
        };
        while (document.canRedo())
            document.redo();
        const std::string end = document.bytes();
        while (document.canUndo())
            document.undo();
        ASSERT_EQ(document.bytes(), first);
        expectMirrored();
        while (document.canRedo())
            document.redo();
        ASSERT_EQ(document.bytes(), end);
        ASSERT_TRUE(document.tree() == sgml::Tree::parse(end));
        expectMirrored();
    }
}

// A letter and an Enter in the middle of 4 MB with 500 scenes: what is read is the paragraph, and
// no scene is read or described again.
TEST(Document, ALetterAndAnEnterCostTheSameInALongDocument) {
    std::string text = "DOCUMENT REPORT\n<REPORT>\n";
    for (int i = 0; i < 500; ++i) {
        for (int k = 0; k < 60; ++k)
            text += "<PARAGRAPH>{" + std::string(110, 'w') + "}</PARAGRAPH>\n";
        text += "<DOCUMENT>DOCUMENT ANIMATION\n<ANIMATION><ASGARD>{s}</ASGARD></ANIMATION>"
                "</DOCUMENT>\n";
    }
    Document document(text + "</REPORT>");
    ASSERT_GT(document.bytes().size(), 4'000'000u);
    const std::vector<SubdocumentId> before = document.subdocuments();
    int texts = 0, structures = 0;
    QObject::connect(&document, &Document::textChanged, &document, [&] { ++texts; });
    QObject::connect(&document, &Document::subdocumentsChanged, &document, [&] { ++structures; });
    const std::size_t at = document.bytes().find("www", document.bytes().size() / 2) + 50;
    const auto cost = [&](const auto& act) {
        const sgml::Work work = sgml::work();
        act();
        EXPECT_LE(sgml::work().bytesRead - work.bytesRead, 300u);
        EXPECT_LE(sgml::work().nodesMade - work.nodesMade, 3u);
    };
    cost([&] { (void)document.edit({{{at, at}, "x"}}, "Type"); });
    EXPECT_EQ(structures, 0);
    cost([&] { (void)document.edit({{{at, at}, "}</PARAGRAPH><PARAGRAPH>{"}}, "Enter"); });
    EXPECT_EQ(structures, 1);
    cost([&] { document.undo(); });
    cost([&] { document.undo(); });
    cost([&] { document.redo(); });
    EXPECT_EQ(texts, 0);
    EXPECT_EQ(document.subdocuments(), before);
    document.undo();
    EXPECT_EQ(document.bytes(), text + "</REPORT>");
}

// A figure that an unclosed brace swallowed comes back with its number when the brace is closed.
TEST(Document, SubdocumentsThatABrokenTextHidesComeBackWithTheirNumber) {
    Document document(twoScenes);
    const std::vector<SubdocumentId> before = document.subdocuments();
    const std::size_t body = twoScenes.find("<BODY>") + 6;
    (void)document.edit({{{body, body}, "{"}}, "Type");
    EXPECT_TRUE(document.subdocuments().empty());
    document.undo();
    EXPECT_EQ(document.subdocuments(), before);
    document.redo();
    document.undo();
    EXPECT_EQ(document.subdocuments(), before);
}

TEST(Document, SamplesHoldWhatTheySay) {
    const Document memo(readSample("memo.ens"));
    EXPECT_TRUE(memo.faults().empty());
    ASSERT_EQ(memo.subdocuments().size(), 1u);
    EXPECT_NE(memo.text(memo.subdocuments()[0])
                  .find("shape_set ss1 -desc {-sub {-pos {0 0 0} -sphere 0.5}}"),
              std::string::npos);
    const Document report(readSample("report.ens"));
    EXPECT_TRUE(report.faults().empty());
    EXPECT_EQ(report.subdocuments().size(), 3u);
}

// At every byte: what was complete before the cut is there, with its place and its text.
TEST(Document, SamplesCutAnywhereAreReadUpToTheCut) {
    for (const std::string name : {"memo.ens", "report.ens"}) {
        const std::string text = readSample(name);
        const sgml::Tree whole = sgml::Tree::parse(text);
        const std::size_t end = whole.node(whole.classElement(whole.root())).range.to;
        for (std::size_t cut = 0; cut < text.size(); ++cut) {
            const sgml::Tree tree = sgml::Tree::parse(text.substr(0, cut));
            ASSERT_EQ(tree.bytes().size(), cut);
            ASSERT_EQ(tree.isBroken(), cut < end);
            bool same = true;
            for (sgml::NodeId id = 1; id < whole.size(); ++id)
                if (whole.node(id).kind == sgml::NodeKind::content &&
                    whole.node(id).range.to <= cut)
                    same = same && id < tree.size() &&
                           tree.node(id).kind == sgml::NodeKind::content &&
                           tree.contentRange(id) == whole.contentRange(id);
            ASSERT_TRUE(same) << name << " cut at " << cut;
        }
    }
}

} // namespace document
