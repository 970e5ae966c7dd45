// Sixteen series that stay apart: each has a colour and a shape of its own.
#pragma once

#include "charts/canvas.h"

namespace charts {

[[nodiscard]] Color colorOf(std::size_t series);

enum class Fill { full, hollow };
void drawMark(Canvas& canvas, double x, double y, std::size_t series, double size, Fill fill);

} // namespace charts
