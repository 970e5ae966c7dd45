// The characters and words of a text as a reader counts them, in bytes of UTF-8.
#pragma once

#include "manuscript/places.h"

#include <cstddef>
#include <string_view>
#include <vector>

#include <QString>

namespace manuscript {

// A character is a grapheme cluster (QTextBoundaryFinder); in flowing text blanks with a line end
// among them are one, since they are shown as one. Bytes that are no UTF-8 are one character each.
class TextUnits {
public:
    TextUnits(std::string_view text, bool isFlowing);

    // The boundary beside `at`, which stays at the ends of the text. Of a word: its end going
    // forward, its start going backward.
    [[nodiscard]] std::size_t beside(std::size_t at, Direction direction, Unit unit) const;
    // `at`, or the boundary of a character beside it.
    [[nodiscard]] std::size_t snapped(std::size_t at, Direction direction) const;

private:
    [[nodiscard]] std::size_t characterBeside(std::size_t at, Direction direction) const;
    [[nodiscard]] std::size_t wordBeside(std::size_t at, Direction direction) const;
    [[nodiscard]] std::size_t besideBlanks(std::size_t at, Direction direction) const;
    [[nodiscard]] qsizetype index(std::size_t at) const; // in string_

    std::string_view text_;
    bool isFlowing_;
    QString string_;
    std::vector<std::size_t> offsets_; // in the text, of each code unit and of the end
};

} // namespace manuscript
