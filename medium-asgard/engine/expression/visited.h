// The nodes that a walk through a graph has seen.
//
//     Visited seen;
//     if (seen.insert(n)) ... // it is new
//
// A walk costs the nodes that it sees: a table of the thread notes in which walk each node was seen
// last, and serves one walk after the other. A walk to a node beyond the table makes it larger
// first, up to that node. Walks within walks have tables of their own, one for each depth.
#pragma once

#include "expression/graph.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

namespace expression {

class Visited {
public:
    Visited();
    ~Visited();
    Visited(const Visited&) = delete;
    Visited& operator=(const Visited&) = delete;

    // False: it was seen before.
    bool insert(Node n) {
        std::vector<std::uint32_t>& last = table_->last;
        if (n.index >= last.size())
            last.resize(std::max<std::size_t>(n.index + 1, 2 * last.size()));
        if (last[n.index] == table_->walk)
            return false;
        last[n.index] = table_->walk;
        return true;
    }

private:
    struct Table {
        std::uint32_t walk = 0;
        std::vector<std::uint32_t> last; // by node, the walk that saw it last
    };
    static std::vector<std::unique_ptr<Table>>& freeTables(); // of this thread
    std::unique_ptr<Table> table_;
};

// By index. Of many nodes a bit for each gives their order sooner than comparing them.
void putInOrder(std::vector<Node>& nodes);

} // namespace expression
