// A model with some of its blocks left out.
#pragma once

#include "model/model.h"

namespace model {

// With these in the place of its own blocks, as many as it has; null: the block is left out. What
// has none left is left out, too. The footnotes are those of the whole.
[[nodiscard]] std::shared_ptr<const Model> withBlocks(const Model& whole, const Blocks& shown);

} // namespace model
