// Numbers and the names of axes, written with a pen into a picture: lines of one width.
//
// Letters stand upright in the picture, at a place of the view; bodies in front hide them.
// LIMIT: digits, x, y, z, point, minus and the exponent's e; other characters are gaps.
#pragma once

#include "drawing/frame.h"
#include "drawing/lines.h"

#include <string>
#include <string_view>

namespace render {

enum class Anchor : std::uint8_t { left, middle, right };

// Pixels, of a text whose digits are that high.
[[nodiscard]] double textWidth(std::string_view text, double height);

// `at` and `aside`: where the text stands, in the view, and how far from there in pixels, to the
// right and up, its digits' half height is.
void addText(Lines& lines, const Frame& frame, const Vector& at, const Eigen::Vector2d& aside,
             std::string_view text, double height, Anchor anchor, const Ink& ink);

// A coordinate that is a multiple of a round step: as few digits as it needs.
[[nodiscard]] std::string coordinateText(double value, double step);

} // namespace render
