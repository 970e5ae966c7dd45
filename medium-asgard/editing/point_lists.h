// The stretches of a text that are long lists of points: language viewers show each as a mark
// (dissertation 4.2.1).
//
// They are the values of -points and -bezier, one after another the faces of a hull, and variables
// that are set to nothing but points.
#pragma once

#include "script/structure.h"

#include <string_view>
#include <vector>

namespace editing {

enum class Listed { points, curves, faces };

struct PointList {
    scene::Range range; // of one word, or from the first -face to the end of the last
    Listed what = Listed::points;
    std::size_t count = 0;
};

// Those that are longer than this many bytes, in order, none within another.
[[nodiscard]] std::vector<PointList>
pointListsOf(std::string_view text, const script::Structure& structure, std::size_t longerThan);

} // namespace editing
