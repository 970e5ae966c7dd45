// The effect of an edit of a document's bytes on its tree. A model, faults or subdocuments,
// which keep something of each node, follow a change by it instead of reading the whole tree again.
//
// A node that stays keeps its NodeId, however far its bytes moved. The number of a node that is
// gone is not given to another node in the same change; a later change may do so.
#pragma once

#include "sgml/edit.h"

#include <vector>

namespace sgml {

struct Change {
    // The nodes below `parent`, which stays, that went and came: the topmost ones, in their order.
    // Nodes below them went and came with them.
    struct Children {
        NodeId parent = noNode;
        std::vector<NodeId> removed{}, added{};
    };

    text::Edits edits{}; // of the bytes, in offsets of the text before
    // All was read again: only the root kept its number, the lists below are empty, and the numbers
    // of nodes that are gone may be in use again.
    bool everything = false;
    // The bytes of the text after that were read again, in their order. Nodes that came lie in
    // them; so do the new tags and ends of nodes that stay, and what became of the bytes of nodes
    // that went.
    std::vector<text::Range> read{};
    std::vector<NodeId> texts{}; // contents that stay and whose bytes changed
    std::vector<NodeId> tags{};  // elements that stay and whose start tag (attributes) changed,
                                 // and documents whose class changed
    std::vector<Children> children{}; // in no order of place
    std::vector<NodeId> gone{};       // every node that went, those below `removed` included
};

// Edits the tree's bytes. The tree is then equal to Tree::parse() of them, and no more was read
// again than the edits can have changed (reparser.h). The edits must be ordered.
Change applyEdits(Tree& tree, const text::Edits& edits);

} // namespace sgml
