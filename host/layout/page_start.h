// The beginning of a page: its content follows from this and from the blocks behind it.
#pragma once

#include "layout/notes.h"
#include "strips/groups.h"

namespace layout {

struct PageStart {
    // The next step for the group that was read last.
    enum class Next {
        read,       // there is none
        afterBreak, // it asked for a page, which has begun
        afterFull,  // there was no room for it on the page before
        place,      // from `strip` on it stands here
        // The page begins within a tall row, a figure that is too large to be moved, a divided
        // note, or after the text: then it begins with the page before. LIMIT: so an edit in the
        // text beside a row of many pages fills these again.
        within,
    };
    Next next = Next::read;
    GroupStart group; // the one that was read last
    std::size_t strip = 0;
    std::vector<GroupStart> floats{}; // that wait for room
    std::vector<Notes::Waiting> notes{};
    std::size_t first = 0;   // the first block of the groups
    std::size_t reached = 0; // blocks before this were read
    bool operator==(const PageStart&) const = default;

    void shift(std::size_t by); // the numbers of all blocks; they wrap
};

} // namespace layout
