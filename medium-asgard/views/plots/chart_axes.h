// The lines of a chart at round times and values, their numbers, and the names of both axes.
#pragma once

#include <QRectF>
#include <QString>

class QFontMetricsF;
class QPainter;
class QPalette;

namespace views {

struct ChartAxes {
    QRectF area; // pixels
    double from = 0, to = 1, low = 0, high = 1;
    QString across = {}, up = {}; // what they say: "time, s", "x of b1, m"; "": nothing
    double height = 0;            // of the chart: the name of the axis of values may use all of it

    [[nodiscard]] QPointF place(double time, double value) const {
        return {area.left() + (time - from) / (to - from) * area.width(),
                area.bottom() - (value - low) / (high - low) * area.height()};
    }
};

// From one number beside the axis of values to the next: three of them at least, where lines of
// letters that high leave the room.
[[nodiscard]] double stepOfValues(const ChartAxes& axes, double lineHeight);

// The name of the axis of values as far as there is room for it, the middle of the axis as its own
// where it can be: "x of b1, m", "x o…, m", "m".
struct AxisName {
    QString words;
    double middle = 0; // down from the chart's upper edge
};
[[nodiscard]] AxisName nameOfValues(const ChartAxes& axes, const QFontMetricsF& metrics);

void paintAxes(QPainter& painter, const ChartAxes& axes, const QPalette& palette);

} // namespace views
