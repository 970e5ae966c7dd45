// Which blocks of a new model are those of an old one?
#pragma once

#include "model/model.h"

namespace model {

// Equal in all that is shown and all that it stands for, cells and footnotes included.
[[nodiscard]] bool isEqual(const Block& a, const Block& b);

// Blocks of an old model and those that took their place.
struct Replaced {
    const Blocks& old;
    std::size_t from = 0, to = 0; // in old
    Blocks& now;
    std::size_t first = 0, end = 0; // in now
};
// Every new block that is equal to an old one becomes that one, in the cells and footnotes of a new
// block, too. Gives how many do not.
std::size_t keepOld(const Replaced& replaced);

} // namespace model
