// Marks of bytes as marks of the letters of lines.
#pragma once

#include "source/marks.h"

#include <string_view>

namespace source {

struct LineMark {
    int from = 0, length = 0; // letters of the line
    Kind kind = Kind::tag;
    bool operator==(const LineMark&) const = default;
};
using LineMarks = std::vector<LineMark>;

// The marks of each of the lines from a line's start on, as many as are wanted.
[[nodiscard]] std::vector<LineMarks> lineMarksOf(std::string_view bytes, std::size_t start,
                                                 int lines, const std::vector<Mark>& marks);

// Behind the line that begins there, its line end included.
[[nodiscard]] std::size_t lineAfter(std::string_view bytes, std::size_t start);

} // namespace source
