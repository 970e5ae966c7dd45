#include "expression/parts.h"

#include "expression/visited.h"

#include <algorithm>

namespace expression {

std::vector<PartOf> partsOf(const Graph& graph, std::span<const std::vector<Node>> formulas,
                            const std::function<bool(Node)>& isLeftOut) {
    // By node, of one walk after the other: those that a walk sees are set when they are seen.
    thread_local std::vector<std::uint64_t> bits;
    if (bits.size() < graph.size())
        bits.resize(graph.size() + graph.size() / 2);
    Visited seen;
    std::vector<Node> found;
    const auto see = [&](Node n) {
        if ((isLeftOut && isLeftOut(n)) || !seen.insert(n))
            return;
        found.push_back(n);
        bits[n.index] = 0;
    };
    for (std::size_t f = 0; f < formulas.size(); ++f)
        for (const Node root : formulas[f]) {
            see(root);
            bits[root.index] |= std::uint64_t{1} << f;
        }
    for (std::size_t next = 0; next < found.size(); ++next) // `found` grows
        std::ranges::for_each(graph.arguments(found[next]), see);
    putInOrder(found);
    std::vector<PartOf> parts;
    parts.reserve(found.size());
    for (auto n = found.rbegin(); n != found.rend(); ++n) { // what reads a node has a larger index
        const std::uint64_t own = bits[n->index];
        for (const Node argument : graph.arguments(*n))
            bits[argument.index] |= own;
        parts.push_back({*n, own});
    }
    return parts;
}

} // namespace expression
