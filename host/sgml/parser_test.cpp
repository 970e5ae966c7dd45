#include "sgml/faults_testing.h"
#include "sgml/random_document.h"
#include "sgml/tree.h"

#include <gtest/gtest.h>

#include <ctime>

namespace sgml {

namespace {

std::string faultsOf(const Tree& tree) { return formatted(tree.faults(), "f"); }

std::string faultsOf(std::string text) { return faultsOf(Tree::parse(std::move(text))); }

// The rules that hold of any tree, however broken the text.
void expectSound(const Tree& tree) {
    for (NodeId id = 1; id < tree.size(); ++id) {
        const Node& node = tree.node(id);
        const Node& parent = tree.node(node.parent);
        ASSERT_LE(node.range.from, node.range.to);
        ASSERT_GE(node.range.from, parent.range.from) << tree.printed();
        ASSERT_LE(node.range.to, parent.range.to) << tree.printed();
        if (node.next != noNode) {
            ASSERT_GE(tree.node(node.next).range.from, node.range.to) << tree.printed();
        }
        if (node.kind == NodeKind::content) {
            ASSERT_LE(tree.contentRange(id).from, tree.contentRange(id).to);
        }
    }
    std::size_t visited = 0;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id))
        ASSERT_EQ(id, visited++) << "nodes are numbered in document order";
    ASSERT_EQ(visited, tree.size());
}

std::string nested(std::size_t depth) {
    std::string text = "DOCUMENT A\n";
    for (std::size_t i = 0; i < depth; ++i)
        text += "<A>";
    return text;
}

} // namespace

TEST(Parser, ReadsAnEmbeddedDocument) {
    const Tree tree = Tree::parse(
        "DOCUMENT CMEMO\n<CMEMO>\n<TO>{Whom}</TO>\n"
        "<DOCUMENT ID=\"d\">\nDOCUMENT ANIMATION\n<ANIMATION WIDTH=\"300\"><ASGARD>{\nb \\{1\\}\n}"
        "</ASGARD></ANIMATION>\n</DOCUMENT>\n</CMEMO>\n");
    EXPECT_EQ(faultsOf(tree), "");
    EXPECT_EQ(tree.printed(), "DOCUMENT CMEMO 0..161\n"
                              "  <CMEMO> 15..160\n"
                              "    <TO> 23..38\n"
                              "      content 27..33 {Whom}\n"
                              "    <DOCUMENT> 39..151 ID=\"d\"\n"
                              "      DOCUMENT ANIMATION 57..139\n"
                              "        <ANIMATION> 76..139 WIDTH=\"300\"\n"
                              "          <ASGARD> 99..127\n"
                              "            content 107..118 {\\nb \\{1\\}\\n}\n");
    const NodeId animation = tree.innermostAt(78);
    EXPECT_EQ(tree.name(animation), "ANIMATION");
    EXPECT_EQ(tree.attribute(animation, "WIDTH"), "300");
    EXPECT_EQ(tree.attribute(animation, "width"), std::nullopt);
    EXPECT_EQ(tree.contentText(tree.childElement(animation, "ASGARD")), "\nb {1}\n");
}

TEST(Parser, EveryKindOfFaultIsListedByPlace) {
    struct {
        std::string text, faults;
    } cases[] = {
        {"", "f:1:1: error: the file is empty\n"},
        {"DOCUMENT A\n", "f:1:11: error: the document holds no element\n"},
        {"<A></A>", "f:1:1: error: a document begins with DOCUMENT and its class\n"},
        {"DOCUMENT\n<A></A>", "f:1:1: error: DOCUMENT is not followed by a class\n"},
        {"DOCUMENT<A></A>", "f:1:1: error: DOCUMENT is not followed by a class\n"},
        {"DOCUMENT A\n<B></B>",
         "f:2:1: error: the document's class is A, but its element is <B>\n"},
        {"DOCUMENT A\n<A><B>{x}</A>", "f:2:10: error: </B> is missing before \"</A>\"\n"},
        {"DOCUMENT A\n<A></B></A>", "f:2:4: error: </B> closes nothing: no <B> is open here\n"},
        {"DOCUMENT A\n<A><B>{x}",
         "f:2:10: error: the text ends inside <B> and 1 more open elements\n"},
        {"DOCUMENT A\n<A>stray {x}</A>", "f:2:4: error: text outside braces: \"stray\"\n"},
        {"DOCUMENT A\n<A>{x}{y}</A>", "f:2:7: error: <A> has two contents in braces\n"},
        {"DOCUMENT A\n<A>{x}<B></B></A>",
         "f:2:7: error: <A> holds both elements and content in braces\n"},
        {"DOCUMENT A\n<A><B></B>{x}</A>",
         "f:2:11: error: <A> holds both elements and content in braces\n"},
        {"DOCUMENT A\n<A><B>{x</B><C>{y}</C></A>",
         "f:2:7: error: this \"{\" is never closed with \"}\"\n"},
        {"DOCUMENT A\n<A><B>{x}}</B></A>", "f:2:10: error: text outside braces: \"}\"\n"},
        {"DOCUMENT A\n<A></A>\nmore", "f:3:1: error: the document has ended before this\n"},
        {"DOCUMENT A\n<A></A>\n<B></B>", "f:3:1: error: the document has ended before this\n"},
        {"DOCUMENT A\n<A X=\"1\" X=\"2\"></A>",
         "f:2:10: error: attribute X is given twice; the first counts\n"},
        {"DOCUMENT A\n<A X=1></A>",
         "f:2:6: error: the value of attribute X is not in double quotes\n"},
        {"DOCUMENT A\n<A X></A>", "f:2:4: error: attribute X has no value; write X=\"...\"\n"},
        {"DOCUMENT A\n<A 1=\"x\"></A>", "f:2:4: error: an attribute's name begins with a letter\n"},
        {"DOCUMENT A\n<A X=\"1></A>",
         "f:2:6: error: the value of attribute X is not closed with a quote\n"},
        {"DOCUMENT A\n<A><B {x}</B></A>",
         "f:2:4: error: the tag \"<B {x}\" is not closed with \">\"\n"
         "f:2:7: error: an attribute's name begins with a letter\n"},
        {"DOCUMENT A\n<A><1></A>",
         "f:2:4: error: \"<\" is not followed by a name, which begins with a letter: \"<1>\"\n"},
        {"DOCUMENT A\n<A><B/></A>",
         "f:2:4: error: a tag that closes itself; write </B> after it\n"},
        {"DOCUMENT A\n<A><!-- <B> --></A>", "f:2:4: error: comments do not belong to the format\n"},
        {"DOCUMENT A\n<A><?x?></A>",
         "f:2:4: error: declarations and processing instructions do not belong to the format\n"},
        {"DOCUMENT A\n<A><DOCUMENT></DOCUMENT></A>", ""},
        {"DOCUMENT A\n<A><DOCUMENT><B></B></DOCUMENT></A>",
         "f:2:14: error: a document begins with DOCUMENT and its class\n"},
        {"DOCUMENT A\n<A><DOCUMENT>DOCUMENT B\n<B></B><C></C></DOCUMENT></A>",
         "f:3:8: error: the nested document has ended before this\n"},
        {"DOCUMENT A\n<A>{a\xFF"
         "b}</A>",
         "f:2:6: warning: these bytes are not UTF-8; they are kept as they are\n"},
        {std::string("DOCUMENT A\n<A>{a\0b}</A>", 23),
         "f:2:6: warning: a NUL byte; it is kept as it is\n"},
        {"\xFF\xFE"
         "D",
         "f:1:1: error: the text is UTF-16; a document is UTF-8\n"},
    };
    for (const auto& [text, faults] : cases) {
        const Tree tree = Tree::parse(text);
        EXPECT_EQ(faultsOf(tree), faults) << text << "\n" << tree.printed();
        EXPECT_EQ(tree.bytes(), text);
        expectSound(tree);
    }
}

TEST(Parser, ReadsOnBehindAFault) {
    const Tree tree = Tree::parse("DOCUMENT A\n<A><B>{x</B><C>{y}</C></A>");
    const NodeId a = tree.classElement(tree.root());
    EXPECT_EQ(tree.contentText(tree.childElement(a, "B")), "x");
    EXPECT_EQ(tree.contentText(tree.childElement(a, "C")), "y");
}

TEST(Parser, ByteOrderMarkAndEveryLineEndAreFine) {
    EXPECT_EQ(faultsOf("\xEF\xBB\xBF"
                       "DOCUMENT A\r\n<A>\r<B>{x\r\ny}</B>\n</A>\r\n"),
              "");
}

TEST(Parser, TenThousandNestedElementsAreRead) {
    std::string text = nested(10'000);
    for (int i = 0; i < 10'000; ++i)
        text += "</A>";
    const Tree tree = Tree::parse(text);
    EXPECT_EQ(faultsOf(tree), "");
    EXPECT_EQ(tree.size(), 10'001u);
    expectSound(tree);
}

TEST(Parser, AMillionNestedElementsAreAnErrorAndNotReadFurther) {
    const std::clock_t start = std::clock(); // of the processor, not of the wall
    const Tree tree = Tree::parse(nested(1'000'000));
    EXPECT_EQ(tree.size(), 20'002u); // the document, the elements, the rest
    EXPECT_EQ(faultsOf(tree),
              "f:2:60001: error: elements are nested deeper than 20000; reading stops here\n");
    EXPECT_EQ(tree.bytes().size(), 11u + 3'000'000u);
    EXPECT_LT(std::clock() - start, 1 * CLOCKS_PER_SEC);
}

TEST(Parser, LimitsAreKept) {
    const Limits limits{.bytes = 200, .nodes = 10, .depth = 5, .attributes = 2, .faults = 4};
    EXPECT_EQ(faultsOf(Tree::parse(std::string(201, 'x'), limits)),
              "f:1:1: error: the text is longer than 200 bytes and is not read\n");
    EXPECT_EQ(
        faultsOf(Tree::parse(
            "DOCUMENT A\n<A><B></B><B></B><B></B><B></B><B></B><B></B><B></B><B></B><B></B></A>",
            limits)),
        "f:2:56: error: more than 10 elements and contents; reading stops here\n");
    EXPECT_EQ(faultsOf(Tree::parse("DOCUMENT A\n<A X=\"1\" Y=\"2\" Z=\"3\"></A>", limits)),
              "f:2:16: error: more than 2 attributes; the others are kept but not read\n");
    EXPECT_EQ(faultsOf(Tree::parse("DOCUMENT A\n<A></a></b></c></d></e></f></A>", limits)),
              "f:2:4: error: </a> closes nothing: no <a> is open here\n"
              "f:2:8: error: </b> closes nothing: no <b> is open here\n"
              "f:2:12: error: </c> closes nothing: no <c> is open here\n"
              "f:2:16: error: </d> closes nothing: no <d> is open here\n"
              "f:2:16: error: 2 more faults are not listed\n");
}

// Texts that make a reader with a careless recovery read the rest of the file again and again.
TEST(Parser, RecoveryIsLinear) {
    for (const std::string unit : {"<A>{</A>", "{", "<A X=\"", "<!--", "\\{", "<A>\\{</A>",
                                   "<A>}</A>", "</A>", "<A X=", "<DOCUMENT>", "<"}) {
        std::string text = "DOCUMENT A\n<A>";
        while (text.size() < 200'000)
            text += unit;
        const std::clock_t start = std::clock(); // of the processor, not of the wall
        const Tree tree = Tree::parse(text);
        EXPECT_TRUE(tree.isBroken());
        EXPECT_LT(std::clock() - start, 2 * CLOCKS_PER_SEC) << unit;
    }
}

TEST(Parser, TenThousandGeneratedAndMutatedDocumentsKeepTheirBytes) {
    RandomDocument random(20);
    for (int i = 0; i < 5000; ++i) {
        const std::string sound = random.sound();
        const Tree tree = Tree::parse(sound);
        ASSERT_EQ(faultsOf(tree), "") << sound;
        ASSERT_EQ(tree.bytes(), sound);
        expectSound(tree);
        const std::string mutated = random.mutated(sound);
        const Tree broken = Tree::parse(mutated);
        ASSERT_EQ(broken.bytes(), mutated);
        expectSound(broken);
    }
}

// Cut anywhere, a document yields the elements that were complete before the cut, with their text.
TEST(Parser, ATruncatedDocumentIsAPrefix) {
    RandomDocument random(21);
    std::string text;
    while (text.size() < 600)
        text = random.sound();
    const Tree whole = Tree::parse(text);
    std::size_t found = 0;
    for (std::size_t cut = 0; cut < text.size(); ++cut) {
        const Tree tree = Tree::parse(text.substr(0, cut));
        expectSound(tree);
        std::size_t complete = 0;
        for (NodeId id = 1; id < whole.size(); ++id) {
            // A nested document is complete when the end tag of its <DOCUMENT> is read.
            const bool document = whole.node(id).kind == NodeKind::document;
            if (whole.node(document ? whole.node(id).parent : id).range.to > cut)
                continue;
            ++complete;
            ASSERT_LT(id, tree.size());
            ASSERT_EQ(tree.node(id).kind, whole.node(id).kind) << cut;
            ASSERT_EQ(tree.node(id).range, whole.node(id).range) << cut;
            ASSERT_EQ(tree.node(id).parent, whole.node(id).parent) << cut;
        }
        ASSERT_LE(complete, tree.size());
        found += complete;
    }
    EXPECT_GT(found, text.size());
}

} // namespace sgml
