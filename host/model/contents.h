// Tables of contents, and lists of figures and tables: what stands in them.
//
// The walk leaves a block without entries; what these are is known when all of the document is. An
// entry leads to an anchor that the walk gives to each heading and caption (anchorOf).
#pragma once

#include "model/model.h"

namespace model {

// Of a heading or a caption; no ID begins so, since "#@" would be no reference to it.
[[nodiscard]] inline std::string anchorOf(sgml::NodeId element) {
    return "@" + std::to_string(element);
}
[[nodiscard]] inline bool isGeneratedAnchor(const std::string& anchor) {
    return anchor.starts_with('@');
}

// Gives the blocks of contents their entries. A block of `old` that is the same stands in the new
// model again. How many others there are. Linear in the blocks of a model that has such a block.
std::size_t fillContents(Model& model, const Blocks& old);

} // namespace model
