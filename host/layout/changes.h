// Which blocks of a model are those of another one?
#pragma once

#include "layout/frames.h"

#include <unordered_set>

namespace layout {

// Blocks [oldFrom, oldTo) were replaced by [newFrom, newTo). Between two of these the blocks are
// the same ones: the pointers are equal, and the frames around them.
struct Hunk {
    std::size_t oldFrom = 0, oldTo = 0, newFrom = 0, newTo = 0;
    bool operator==(const Hunk&) const = default;
};

// In order of place. The text before a display that came or went counts as changed: it stays with
// it. `changed`: blocks that count as changed though they are the same.
// LIMIT: of blocks that were moved past others either these or those count as changed.
[[nodiscard]] std::vector<Hunk> differences(const model::Model& before, const Frames& framesBefore,
                                            const model::Model& now, const Frames& framesNow,
                                            const std::unordered_set<const model::Block*>& changed);

} // namespace layout
