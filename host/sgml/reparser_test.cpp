// A tree that follows edits is the tree that reading the edited bytes gives, and its nodes keep
// their numbers.
#include "sgml/change.h"
#include "sgml/random_document.h"
#include "sgml/work.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>

namespace sgml {

namespace {

// All that is to be known of a node without its place.
struct Known {
    NodeKind kind;
    NodeId parent;
    std::string start; // a tag, a content, a document's class
    std::vector<NodeId> children;
};

std::map<NodeId, Known> nodesOf(const Tree& tree) {
    std::map<NodeId, Known> nodes;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id)) {
        const Node& node = tree.node(id);
        Known known{.kind = node.kind, .parent = node.parent, .start = {}, .children = {}};
        if (node.kind == NodeKind::document)
            known.start = tree.text(node.name);
        else
            known.start = tree.text(tree.isElement(id) ? node.startTag : node.range);
        for (NodeId child = node.firstChild; child != noNode; child = tree.node(child).next)
            known.children.push_back(child);
        if (!known.children.empty()) {
            EXPECT_EQ(known.children.back(), node.lastChild);
        }
        nodes[id] = known;
    }
    return nodes;
}

// Follows a change as its receivers do: what was told is taken over, the rest is as it was.
void expectTold(std::map<NodeId, Known> nodes, const Tree& tree, const Change& change) {
    const std::map<NodeId, Known> now = nodesOf(tree);
    for (const NodeId id : change.gone) {
        EXPECT_EQ(nodes.erase(id), 1u);
        EXPECT_FALSE(tree.holds(id));
        EXPECT_FALSE(now.contains(id)) << "used again at once";
    }
    for (const Change::Children& at : change.children) {
        ASSERT_TRUE(now.contains(at.parent));
        nodes[at.parent].children = now.at(at.parent).children;
        for (const NodeId removed : at.removed)
            EXPECT_FALSE(tree.holds(removed));
        for (const NodeId top : at.added)
            for (NodeId id = top; id != noNode; id = tree.following(id, top)) {
                EXPECT_FALSE(nodes.contains(id));
                nodes[id] = now.at(id);
            }
    }
    for (const std::vector<NodeId>* ids : {&change.texts, &change.tags})
        for (const NodeId id : *ids) {
            ASSERT_TRUE(now.contains(id));
            ASSERT_EQ(nodes[id].kind, now.at(id).kind);
            nodes[id].start = now.at(id).start;
        }
    EXPECT_EQ(nodes.size(), now.size());
    const auto isRead = [&](NodeId id) {
        const std::size_t from = tree.node(id).range.from;
        return std::any_of(change.read.begin(), change.read.end(), [&](text::Range range) {
            return range.from <= from && from <= range.to;
        });
    };
    for (const Change::Children& at : change.children)
        EXPECT_TRUE(std::all_of(at.added.begin(), at.added.end(), isRead));
    for (const auto& [id, node] : now) {
        EXPECT_EQ(nodes[id].kind, node.kind) << "node " << id;
        EXPECT_EQ(nodes[id].parent, node.parent) << "node " << id;
        EXPECT_EQ(nodes[id].start, node.start) << "node " << id;
        EXPECT_EQ(nodes[id].children, node.children) << "node " << id;
    }
}

std::string faultLines(const Tree& tree) {
    std::string lines;
    for (const Fault& fault : tree.faults())
        lines += formatted(fault, "") + "\n";
    return lines;
}

Change expectFollows(Tree& tree, const text::Edits& edits) {
    const std::map<NodeId, Known> before = nodesOf(tree);
    const std::string bytes = text::applied(tree.bytes(), edits), was = tree.bytes();
    const Change change = applyEdits(tree, edits);
    const Tree read = Tree::parse(bytes);
    EXPECT_EQ(faultLines(tree), faultLines(read)) << bytes;
    EXPECT_TRUE(tree == read) << was << "\n--- becomes\n"
                              << bytes << "\n--- as\n"
                              << tree.printed() << "--- instead of\n"
                              << read.printed();
    if (!change.everything)
        expectTold(before, tree, change);
    EXPECT_FALSE(testing::Test::HasFailure()) << was << "\n--- becomes\n" << bytes;
    return change;
}

constexpr std::array<std::string_view, 24> inserted = {
    "a",        " ",
    "\n",       "}</TEXT><TEXT>{",
    "</TEXT>",  "<TEXT>",
    "{",        "}",
    "{x}",      "<TEXT>{y}</TEXT>",
    "<EMPH/>",  "\"",
    " A=\"1\"", "DOCUMENT B",
    "\\",       "\xC3",
    "\xA9",     "<!--",
    "-->",      "<",
    "</",       "<TEXT",
    ">",        "<DOCUMENT>DOCUMENT C <C></C></DOCUMENT>"};

text::Edits randomEdits(RandomDocument& random, const Tree& tree) {
    const std::size_t size = tree.bytes().size();
    text::Edits edits;
    std::size_t at = 0;
    for (std::size_t count = 1 + (random.below(3) == 0 ? random.below(3) : 0);
         count > 0 && at <= size; --count) {
        std::size_t from = at + random.below(size - at + 1), to = from;
        const std::size_t kind = random.below(5);
        const auto id = static_cast<NodeId>(random.below(tree.size()));
        if (kind == 0 && tree.holds(id) && tree.node(id).range.from >= at) {
            from = tree.node(id).range.from; // a whole node, a start tag or an end tag
            to = tree.node(id).range.to;
            if (tree.isElement(id) && random.below(2) == 0)
                to = tree.node(id).startTag.to;
            else if (tree.isElement(id) && random.below(2) == 0)
                from = tree.node(id).endTag.from;
        } else if (kind == 1) {
            to = from + random.below(std::min<std::size_t>(size - from, 12) + 1);
        }
        std::string text;
        if (kind != 1 || random.below(2) == 0)
            text =
                kind == 2 ? random.text(3) : std::string(inserted[random.below(inserted.size())]);
        if (kind == 0 && random.below(2) == 0)
            text.clear();
        edits.push_back({{from, to}, text});
        at = to + random.below(3);
    }
    return edits;
}

} // namespace

// ROUNDS=100000 and SEED=... make it a long one.
TEST(Reparser, RandomEditsEqualReadingAgain) {
    const char *const longer = std::getenv("ROUNDS"), *const seed = std::getenv("SEED");
    const int rounds = longer != nullptr ? std::atoi(longer) : 400;
    RandomDocument random(seed != nullptr ? std::strtoull(seed, nullptr, 10) : 50);
    std::size_t whole = 0, all = 0;
    for (int round = 0; round < rounds; ++round) {
        Tree tree = Tree::parse(round % 2 == 0 ? random.sound() : random.mutated(random.sound()));
        std::vector<text::Edits> back;
        for (int step = 0; step < 20 && !testing::Test::HasFailure(); ++step) {
            const bool mends = !back.empty() && random.below(3) == 0;
            const text::Edits edits = mends ? back.back() : randomEdits(random, tree);
            const text::Edits inverted = text::inverse(tree.bytes(), edits);
            const Change change = expectFollows(tree, edits);
            whole += change.everything ? 1 : 0;
            ++all;
            if (mends)
                back.pop_back();
            else
                back.push_back(inverted);
        }
        ASSERT_FALSE(testing::Test::HasFailure()) << "round " << round;
    }
    EXPECT_LT(whole * 10, all);
}

namespace {

// 4 MB: sections of paragraphs, some 60,000 nodes.
std::string longReport() {
    std::string text = "DOCUMENT REPORT\n<REPORT><BODY>\n";
    const std::string words = "The quick brown fox jumps over the lazy dog and goes home again. ";
    for (int section = 0; section < 600; ++section) {
        text += "<SECTION ID=\"s" + std::to_string(section) + "\"><HEADING>{Section}</HEADING>\n";
        for (int paragraph = 0; paragraph < 49; ++paragraph)
            text += "<PARAGRAPH>{" + words + words + "}</PARAGRAPH>\n";
        text += "</SECTION>\n";
    }
    return text + "</BODY></REPORT>\n";
}

struct Cost {
    std::size_t bytes, nodes;
};

Cost costOf(Tree& tree, const text::Edits& edits) {
    const Work before = work();
    applyEdits(tree, edits);
    const Cost cost{work().bytesRead - before.bytesRead, work().nodesMade - before.nodesMade};
    EXPECT_TRUE(tree == Tree::parse(tree.bytes()));
    return cost;
}

} // namespace

// The edits that an author makes every day, in the middle of a long document.
TEST(Reparser, AnEditIsReadAtTheCostOfItsElement) {
    Tree tree = Tree::parse(longReport());
    ASSERT_GT(tree.bytes().size(), 4'000'000u);
    ASSERT_GT(tree.size(), 50'000u);
    const std::size_t middle = tree.bytes().find("<SECTION ID=\"s300\"");
    const NodeId section = tree.innermostAt(middle);
    const std::size_t letter = tree.bytes().find("fox", middle);
    const std::size_t joint = tree.bytes().find("}</PARAGRAPH>\n<PARAGRAPH>{", letter);
    const std::size_t next = tree.bytes().find("<PARAGRAPH>", letter + 40);
    const std::size_t first = tree.bytes().find("fox"), last = tree.bytes().rfind("fox");
    struct {
        const char* what;
        text::Edits edits;
        std::size_t bytes, nodes;
    } cases[] = {
        {"a letter", {{{letter, letter}, "x"}}, 150, 1},
        {"Enter", {{{letter, letter}, "}</PARAGRAPH>\n<PARAGRAPH>{"}}, 200, 3},
        {"two paragraphs joined", {{{joint, joint + 26}, ""}}, 350, 1},
        {"a section's attribute", {{{middle + 8, middle + 8}, " LANG=\"en\""}}, 50, 1},
        {"an empty paragraph", {{{next, next}, "<PARAGRAPH></PARAGRAPH>"}}, 200, 2},
        {"a letter at both ends", {{{first, first}, "x"}, {{last, last}, "x"}}, 400, 2},
    };
    for (const auto& [what, edits, bytes, nodes] : cases) {
        Tree edited = tree;
        const Cost cost = costOf(edited, edits);
        EXPECT_LE(cost.bytes, bytes) << what;
        EXPECT_LE(cost.nodes, nodes) << what;
        EXPECT_TRUE(edited.faults().empty()) << what;
        EXPECT_TRUE(edited.holds(section)) << what;
    }
}

// While a brace is open everything behind it is read; the brace that closes it mends all.
TEST(Reparser, ABrokenTextIsMended) {
    Tree tree = Tree::parse(longReport());
    const std::size_t at = tree.bytes().find("fox", tree.bytes().size() / 2);
    applyEdits(tree, {{{at, at}, "{"}});
    EXPECT_TRUE(tree.isBroken());
    EXPECT_TRUE(tree == Tree::parse(tree.bytes()));
    const Change change = applyEdits(tree, {{{at, at + 1}, ""}});
    EXPECT_FALSE(change.everything);
    EXPECT_TRUE(tree.faults().empty());
    EXPECT_TRUE(tree == Tree::parse(tree.bytes()));
}

TEST(Reparser, LimitsHold) {
    const Limits few{.nodes = 12, .depth = 4, .faults = 10};
    Tree tree = Tree::parse("DOCUMENT A\n<A><B>{x}</B><B>{x}</B></A>", few);
    for (const std::string text : {"<B>{x}</B>", "<C><C></C></C>", "}{", "<B><B><B>", "</B>"})
        for (int i = 0; i < 8; ++i) {
            const std::size_t at = tree.bytes().find("<B>") + (i % 2 == 0 ? 0 : 3);
            applyEdits(tree, {{{at, at}, text}});
            ASSERT_TRUE(tree == Tree::parse(tree.bytes(), few)) << tree.bytes();
        }
    while (tree.bytes().size() > 40) {
        applyEdits(tree, {{{14, 16}, ""}});
        ASSERT_TRUE(tree == Tree::parse(tree.bytes(), few)) << tree.bytes();
    }
}

// Numbers and attributes of nodes that are gone are used again.
TEST(Reparser, MemoryStaysFlat) {
    Tree tree = Tree::parse("DOCUMENT A\n<A><B>{x}</B></A>");
    for (int i = 0; i < 20'000; ++i)
        applyEdits(tree, i % 2 == 0 ? text::Edits{{{14, 14}, "<C K=\"1\" L=\"2\"><D>{y}</D></C>"}}
                                    : text::Edits{{{14, 44}, ""}});
    EXPECT_LE(tree.size(), 20u);
    EXPECT_TRUE(tree == Tree::parse(tree.bytes()));
}

} // namespace sgml
