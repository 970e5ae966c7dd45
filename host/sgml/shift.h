// The places of a text after an edit.
#pragma once

#include "sgml/edit.h"

#include <vector>

namespace sgml {

inline constexpr std::size_t nowhere = static_cast<std::size_t>(-1); // the byte is gone

class Shift {
public:
    explicit Shift(const text::Edits& edits);

    // Of a byte: moves with it, so behind what is inserted before it.
    [[nodiscard]] std::size_t ofStart(std::size_t offset) const;
    // Of the place behind a byte: stays before what is inserted there.
    [[nodiscard]] std::size_t ofEnd(std::size_t offset) const;
    [[nodiscard]] text::Range of(text::Range range) const {
        return {ofStart(range.from), ofEnd(range.to)};
    }

    // Is an edit inside the range or at one of its ends? Where none is, all places in it move by
    // the same distance.
    [[nodiscard]] bool touches(text::Range range) const;
    [[nodiscard]] std::size_t
    distance(text::Range untouched) const; // modulo 2^64: may be backwards
    // Does an edit replace a byte of the range, or insert between two of them?
    [[nodiscard]] bool changes(text::Range range) const;

private:
    [[nodiscard]] std::size_t endingBefore(std::size_t offset) const;

    const text::Edits& edits_;
    std::vector<std::size_t> distances_; // behind the first i edits
};

} // namespace sgml
