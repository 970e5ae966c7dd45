// The lines of a chart at round times and values, and their numbers.
#pragma once

#include <QRectF>

class QPainter;
class QPalette;

namespace views {

struct ChartAxes {
    QRectF area; // pixels
    double from = 0, to = 1, low = 0, high = 1;

    [[nodiscard]] QPointF place(double time, double value) const {
        return {area.left() + (time - from) / (to - from) * area.width(),
                area.bottom() - (value - low) / (high - low) * area.height()};
    }
};

void paintAxes(QPainter& painter, const ChartAxes& axes, const QPalette& palette);

} // namespace views
