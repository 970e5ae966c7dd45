#include "sgml/shift.h"

#include <algorithm>

namespace sgml {

Shift::Shift(const text::Edits& edits) : edits_(edits), distances_{0} {
    for (const text::Edit& edit : edits)
        distances_.push_back(distances_.back() + edit.text.size() - edit.range.size());
}

// How many edits end before `offset`.
std::size_t Shift::endingBefore(std::size_t offset) const {
    std::size_t low = 0, high = edits_.size();
    while (low < high) {
        const std::size_t middle = (low + high) / 2;
        if (edits_[middle].range.to < offset)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::size_t Shift::ofStart(std::size_t offset) const {
    std::size_t before = endingBefore(offset);
    while (before < edits_.size() && edits_[before].range.to == offset)
        ++before;
    const bool replaced = before < edits_.size() && edits_[before].range.from <= offset;
    return replaced ? nowhere : offset + distances_[before];
}

std::size_t Shift::ofEnd(std::size_t offset) const {
    std::size_t before = endingBefore(offset);
    if (before < edits_.size() && edits_[before].range.to == offset &&
        edits_[before].range.from < offset)
        ++before;
    const bool replaced = before < edits_.size() && edits_[before].range.from < offset;
    return replaced ? nowhere : offset + distances_[before];
}

bool Shift::touches(text::Range range) const {
    const std::size_t next = endingBefore(range.from);
    return next < edits_.size() && edits_[next].range.from <= range.to;
}

std::size_t Shift::distance(text::Range untouched) const {
    return distances_[endingBefore(untouched.from)];
}

bool Shift::changes(text::Range range) const {
    std::size_t next = endingBefore(range.from);
    while (next < edits_.size() && edits_[next].range.to == range.from)
        ++next;
    return next < edits_.size() && edits_[next].range.from < range.to;
}

} // namespace sgml
