#include "sgml/change.h"
#include "sgml/random_document.h"

#include <gtest/gtest.h>

namespace sgml {

namespace {

std::string around(const std::string& spelling) { return "DOCUMENT A\n<A>{" + spelling + "}</A>"; }

NodeId onlyContent(const Tree& tree) { return tree.content(tree.classElement(tree.root())); }

} // namespace

TEST(Edit, ContentEditsChangeOnlyTheirBytes) {
    struct {
        std::string before;
        text::Range range;
        std::string text, after;
    } cases[] = {
        {"\\{1 2\\} {3}", {1, 2}, "7", "\\{7 2\\} {3}"}, // the spelling around stays as it is
        {"abc", {1, 1}, "{x}", "a\\{x\\}bc"},            // new text is written escaped
        {"a{b}c", {1, 2}, "", "ab\\}c"},                 // the widowed brace is escaped
        {"a{b}c", {3, 4}, "", "a\\{bc"},
        {"a{b}c", {1, 4}, "", "ac"},
        {"a\\xb", {2, 3}, "{", "a\\\\\\{b"}, // the bare backslash would escape the new brace
        {"a\\xb", {2, 4}, "", "a\\\\"},      // and here the closing one
        {"a\\x\\{b", {2, 3}, "", "a\\\\\\{b"},
        {"\\\\", {0, 1}, "/", "/"},
    };
    for (const auto& [before, range, text, after] : cases) {
        const Tree tree = Tree::parse(around(before));
        ASSERT_FALSE(tree.isBroken()) << before;
        const text::Edits edits = contentEdit(tree, onlyContent(tree), range, text);
        EXPECT_EQ(text::applied(tree.bytes(), edits), around(after)) << before;
    }
}

TEST(Edit, AttributesAreSetAddedAndRemoved) {
    const Tree tree = Tree::parse("DOCUMENT A\n<A  X=\"1\"\tY = \"2\" ></A>");
    const NodeId a = tree.classElement(tree.root());
    EXPECT_EQ(text::applied(tree.bytes(), attributeEdit(tree, a, "Y", "a\"b")),
              "DOCUMENT A\n<A  X=\"1\"\tY=\"a'b\" ></A>");
    EXPECT_EQ(text::applied(tree.bytes(), attributeEdit(tree, a, "Z", "3")),
              "DOCUMENT A\n<A  X=\"1\"\tY = \"2\" Z=\"3\" ></A>");
    EXPECT_EQ(text::applied(tree.bytes(), attributeRemoval(tree, a, "X")),
              "DOCUMENT A\n<A\tY = \"2\" ></A>");
    EXPECT_TRUE(attributeRemoval(tree, a, "Z").empty());
}

// The slow way checks the quick one: a spliced tree is the tree of the edited bytes; the text is as
// asked, and the bytes outside the content are untouched.
TEST(Edit, RandomContentEditsEqualReadingAgain) {
    RandomDocument random(30);
    for (int round = 0; round < 150; ++round) {
        Tree tree = Tree::parse(random.sound());
        for (int step = 0; step < 20; ++step) {
            const auto id = static_cast<NodeId>(random.below(tree.size()));
            if (tree.node(id).kind != NodeKind::content)
                continue;
            const std::string before = tree.unescaped(id).text();
            const std::size_t from = random.below(before.size() + 1);
            const std::size_t to = from + random.below(before.size() - from + 1);
            const std::string text = random.text(4);
            const text::Edits edits = contentEdit(tree, id, {from, to}, text);
            const std::string bytes = tree.bytes();
            const text::Range range = tree.contentRange(id);
            ASSERT_TRUE(text::areOrdered(edits, bytes.size()));
            for (const text::Edit& edit : edits) {
                ASSERT_GE(edit.range.from, range.from);
                ASSERT_LE(edit.range.to, range.to);
            }
            applyEdits(tree, edits);
            ASSERT_TRUE(tree == Tree::parse(text::applied(bytes, edits))) << bytes;
            ASSERT_EQ(tree.unescaped(id).text(), before.substr(0, from) + text + before.substr(to))
                << bytes;
        }
    }
}

TEST(Edit, SeveralRangesAtOnce) {
    RandomDocument random(31);
    for (int round = 0; round < 3000; ++round) {
        const Tree tree = Tree::parse(around(random.spelling(3)));
        const NodeId content = onlyContent(tree);
        const std::string before = tree.unescaped(content).text();
        text::Edits asked;
        for (std::size_t at = 0; at <= before.size() && asked.size() < 4;) {
            const std::size_t from = at + random.below(before.size() - at + 1);
            const std::size_t to = from + random.below(before.size() - from + 1);
            asked.push_back({{from, to}, random.text(3)});
            at = to + random.below(2);
        }
        Tree after = tree;
        applyEdits(after, contentEdits(tree, content, asked));
        ASSERT_FALSE(after.isBroken()) << tree.bytes() << "\n" << after.bytes();
        ASSERT_EQ(after.unescaped(onlyContent(after)).text(), text::applied(before, asked))
            << tree.bytes();
    }
}

} // namespace sgml
