#include "strips/stock.h"

#include <algorithm>

namespace layout {

using paragraphs::Sizes;

bool Columns::isOf(Sizes& sizesNow) const {
    return std::ranges::all_of(
        sizes, [&](const auto& one) { return sizesNow.subdocument(one.first) == one.second; });
}

} // namespace layout
