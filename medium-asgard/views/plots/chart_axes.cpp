#include "plots/chart_axes.h"

#include "charts/scale.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

// As much of it as there is room for: rather the unit, which comes last, than all of the words.
QString fitting(const QString& name, double room, const QFontMetricsF& metrics) {
    const qsizetype comma = name.lastIndexOf(QStringLiteral(", "));
    if (metrics.horizontalAdvance(name) <= room || comma < 0)
        return name;
    const QString unit = name.mid(comma);
    const QString words = metrics.elidedText(name.left(comma), Qt::ElideRight,
                                             room - metrics.horizontalAdvance(unit));
    constexpr qsizetype fewest = 4; // signs that say anything
    return words.size() < fewest ? name.mid(comma + 2) : words + unit;
}

void paintNames(QPainter& painter, const ChartAxes& axes, const QPalette& palette) {
    const QRectF& a = axes.area;
    const QFontMetricsF metrics(painter.font());
    QColor ink = palette.color(QPalette::WindowText);
    ink.setAlpha(170);
    painter.setPen(ink);
    const QString across = fitting(axes.across, a.width(), metrics);
    painter.drawText(QPointF(a.center().x() - metrics.horizontalAdvance(across) / 2,
                             a.bottom() + 4 + 2 * metrics.ascent() + 2),
                     across);
    const AxisName up = nameOfValues(axes, metrics);
    painter.save();
    painter.translate(2 + metrics.ascent(), up.middle);
    painter.rotate(-90);
    painter.drawText(QPointF(-metrics.horizontalAdvance(up.words) / 2, 0), up.words);
    painter.restore();
}

} // namespace

// Beside the numbers nothing else stands, from the chart's upper edge to the lower one.
AxisName nameOfValues(const ChartAxes& axes, const QFontMetricsF& metrics) {
    constexpr double margin = 2;
    const double whole = std::max(axes.height, axes.area.bottom());
    AxisName name{fitting(axes.up, whole - 2 * margin, metrics), axes.area.center().y()};
    const double half = metrics.horizontalAdvance(name.words) / 2 + margin;
    name.middle =
        std::clamp(name.middle, std::min(half, whole / 2), std::max(whole - half, whole / 2));
    return name;
}

double stepOfValues(const ChartAxes& axes, double lineHeight) {
    const double height = axes.high - axes.low, wide = 30;
    const double step = charts::roundStep(height * wide / axes.area.height());
    constexpr std::size_t fewest = 3; // that tell how large a value is
    return charts::multiplesOf(step, axes.low, axes.high).size() >= fewest
               ? step
               : charts::roundStep(height * std::min(wide, lineHeight) / axes.area.height());
}

void paintAxes(QPainter& painter, const ChartAxes& axes, const QPalette& palette) {
    const QRectF& a = axes.area;
    const QFontMetricsF metrics(painter.font());
    const auto setLine = [&](bool isStrong) {
        QColor line = palette.color(QPalette::WindowText);
        line.setAlpha(isStrong ? 90 : 28);
        painter.setPen(line);
    };
    const auto write = [&](const QPointF& at, const QString& label) {
        QColor text = palette.color(QPalette::WindowText);
        text.setAlpha(170);
        painter.setPen(text);
        painter.drawText(at, label);
    };
    const double span = axes.to - axes.from, height = axes.high - axes.low;
    for (const double time :
         charts::multiplesOf(charts::roundStep(span * 70 / a.width()), axes.from, axes.to)) {
        const double x = axes.place(time, axes.low).x();
        setLine(false);
        painter.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
        const QString label = QString::number(time, 'g', 6);
        write({x - metrics.horizontalAdvance(label) / 2, a.bottom() + 4 + metrics.ascent()}, label);
    }
    const double step = stepOfValues(axes, metrics.height());
    // Values that differ in their last digits only are written by what they are above a round one.
    constexpr int widest = 8; // digits
    const double size = std::max(std::abs(axes.low), std::abs(axes.high));
    const double round = 10 * charts::roundStep(height);
    const double base =
        charts::digitsFor(size, step) > widest ? std::floor(axes.low / round) * round : 0;
    if (base != 0)
        write({axes.up.isEmpty() ? 2 : 4 + metrics.height(), a.top() - 4},
              QString::number(base, 'g', charts::digitsFor(base, round)) + " +");
    for (const double value : charts::multiplesOf(step, axes.low, axes.high)) {
        const double y = axes.place(axes.from, value).y();
        setLine(value == 0);
        painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
        const double above = std::abs(value - base) < step / 2 ? 0 : value - base;
        const QString label =
            QString::number(above, 'g', base != 0 ? 4 : charts::digitsFor(value, step));
        write({a.left() - 6 - metrics.horizontalAdvance(label), y + metrics.ascent() / 2 - 1},
              label);
    }
    paintNames(painter, axes, palette);
}

} // namespace views
