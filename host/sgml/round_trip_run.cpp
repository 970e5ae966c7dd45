// round_trip COUNT SEED: generates COUNT documents, half of them mutated, reads and edits each, and
// fails at the first that does not keep its bytes. The same checks as the tests, at any size.
#include "sgml/change.h"
#include "sgml/random_document.h"

#include <cstdio>
#include <cstdlib>

namespace {

using namespace sgml;

// A content edit and its inverse give the bytes back; the quick tree equals the one read anew.
bool survivesEdit(const Tree& tree, RandomDocument& random) {
    const auto id = static_cast<NodeId>(random.below(tree.size()));
    if (tree.node(id).kind != NodeKind::content)
        return true;
    const std::size_t size = tree.unescaped(id).text().size();
    const std::size_t from = random.below(size + 1);
    const text::Edits edits =
        contentEdit(tree, id, {from, from + random.below(size - from + 1)}, random.text(3));
    Tree after = tree;
    applyEdits(after, edits);
    return after == Tree::parse(text::applied(tree.bytes(), edits)) &&
           text::applied(after.bytes(), text::inverse(tree.bytes(), edits)) == tree.bytes();
}

bool survives(const std::string& bytes, bool sound, RandomDocument& random) {
    const Tree tree = Tree::parse(bytes);
    return tree.bytes() == bytes && (!sound || tree.faults().empty()) && survivesEdit(tree, random);
}

} // namespace

int main(int count, char** arguments) {
    if (count != 3) {
        std::fprintf(stderr, "usage: round_trip COUNT SEED\n");
        return 2;
    }
    const unsigned long long documents = std::strtoull(arguments[1], nullptr, 10);
    const unsigned long long seed = std::strtoull(arguments[2], nullptr, 10);
    std::size_t bytes = 0;
    for (unsigned long long i = 0; i < documents; ++i) {
        RandomDocument random(seed + i);
        std::string document = random.sound();
        const bool mutated = i % 2 == 1;
        if (mutated)
            document = random.mutated(document);
        bytes += document.size();
        if (!survives(document, !mutated, random)) {
            std::printf("seed %llu fails:\n%s\n", seed + i, document.c_str());
            return 1;
        }
    }
    std::printf("%llu documents, %zu bytes, seed %llu: all keep their bytes\n", documents, bytes,
                seed);
    return 0;
}
