// How many elements are equal from both ends, of two vectors of which a middle has changed.
#pragma once

#include <algorithm>
#include <cstddef>

namespace model {

struct Ends {
    std::size_t front = 0, back = 0;
};
// `equal` gets an element of each, and whether they are counted from the back.
template <class Vector, class Equal> Ends equalEnds(const Vector& a, const Vector& b, Equal equal) {
    const std::size_t least = std::min(a.size(), b.size());
    Ends ends;
    while (ends.front < least && equal(a[ends.front], b[ends.front], false))
        ++ends.front;
    while (ends.front + ends.back < least &&
           equal(a[a.size() - 1 - ends.back], b[b.size() - 1 - ends.back], true))
        ++ends.back;
    return ends;
}

} // namespace model
