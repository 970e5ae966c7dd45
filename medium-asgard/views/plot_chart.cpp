#include "views/plot_chart.h"

#include "charts/marks.h"
#include "views/scale.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr double leftSpace = 64, rightSpace = 16, bottomSpace = 24;

// With the digits that a thousandth of the range needs.
QString number(double value, double range) {
    return QString::number(value, 'g', digitsFor(value, range / 1000));
}

} // namespace

QColor PlotChart::usualColor(std::size_t curve) {
    const charts::Color color = charts::colorOf(curve);
    return QColor::fromRgbF(static_cast<float>(color.red), static_cast<float>(color.green),
                            static_cast<float>(color.blue));
}

QPen PlotChart::penOf(std::size_t curve, double width) const {
    const PlotCurve& one = samples_.curves[curve];
    return {one.color.isValid() ? one.color : usualColor(curve), width, one.line};
}

PlotChart::PlotChart() {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlotChart::setSamples(PlotSamples samples, double start, double finish) {
    samples_ = std::move(samples);
    start_ = start;
    finish_ = finish > start ? finish : start + 1;
    low_ = std::numeric_limits<double>::infinity();
    high_ = -low_;
    for (const PlotCurve& curve : samples_.curves)
        for (const double value : curve.values)
            if (std::isfinite(value)) {
                low_ = std::min(low_, value);
                high_ = std::max(high_, value);
            }
    if (!(low_ <= high_))
        low_ = high_ = 0;
    // What does not change, but for rounding, is a line in the middle.
    const double size = std::max(std::abs(low_), std::abs(high_));
    const double least = size > 0 ? 1e-9 * size : 1;
    const double room = 0.08 * (high_ - low_) + std::max(0.0, least - (high_ - low_)) / 2;
    low_ -= room;
    high_ += room;
    setAccessibleName(tr("%1 against time").arg(samples_.title));
    update();
}

QRectF PlotChart::area() const {
    const double top = 2.2 * fontMetrics().height();
    return {leftSpace, top, std::max(1.0, width() - leftSpace - rightSpace),
            std::max(1.0, height() - top - bottomSpace)};
}

ChartAxes PlotChart::axes() const { return {area(), start_, finish_, low_, high_}; }

QPointF PlotChart::placeOf(double time, double value) const { return axes().place(time, value); }

std::optional<std::size_t> PlotChart::sampleAt(const QPointF& position) const {
    const QRectF a = area();
    if (samples_.times.empty() || position.x() < a.left() || position.x() > a.right())
        return std::nullopt;
    const double time = start_ + (position.x() - a.left()) / a.width() * (finish_ - start_);
    const auto after = std::ranges::lower_bound(samples_.times, time);
    auto at = static_cast<std::size_t>(after - samples_.times.begin());
    if (at == samples_.times.size() ||
        (at > 0 && time - samples_.times[at - 1] < samples_.times[at] - time))
        --at;
    return at;
}

QString PlotChart::readingAt(const QPointF& position) const {
    const auto at = sampleAt(position);
    if (!at)
        return {};
    QString words = tr("t = %1 s").arg(number(samples_.times[*at], finish_ - start_));
    for (const PlotCurve& curve : samples_.curves)
        words +=
            QStringLiteral("   %1 = %2").arg(curve.label, number(curve.values[*at], high_ - low_));
    return words;
}

void PlotChart::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    update();
}

void PlotChart::leaveEvent(QEvent*) {
    pointer_.reset();
    update();
}

void PlotChart::paintAxes(QPainter& painter) const { views::paintAxes(painter, axes(), palette()); }

void PlotChart::paintCurves(QPainter& painter) const {
    painter.setClipRect(area().adjusted(-1, -1, 1, 1));
    painter.setBrush(Qt::NoBrush);
    const auto now = pointer_ ? sampleAt(*pointer_) : std::nullopt;
    for (std::size_t i = 0; i < samples_.curves.size(); ++i) {
        const std::vector<double>& values = samples_.curves[i].values;
        QPainterPath path;
        bool joined = false;
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (!std::isfinite(values[k])) {
                joined = false;
                continue;
            }
            const QPointF place = placeOf(samples_.times[k], values[k]);
            if (joined)
                path.lineTo(place);
            else
                path.moveTo(place);
            joined = true;
        }
        painter.setPen(penOf(i, 1.8));
        painter.drawPath(path);
        if (now && std::isfinite(values[*now]))
            painter.drawEllipse(placeOf(samples_.times[*now], values[*now]), 3.5, 3.5);
    }
    painter.setClipping(false);
}

// The title, and what the curves are; with the pointer over them what they are worth.
void PlotChart::paintTitle(QPainter& painter) const {
    const double line = 4 + fontMetrics().ascent();
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    painter.drawText(QPointF(leftSpace, line), samples_.title);
    const double behind = leftSpace + QFontMetricsF(bold).horizontalAdvance(samples_.title) + 20;
    painter.setFont(font());
    const QString reading = pointer_ ? readingAt(*pointer_) : QString();
    if (!reading.isEmpty()) {
        painter.drawText(QPointF(behind, line), reading);
        return;
    }
    double x = behind;
    for (std::size_t i = 0; i < samples_.curves.size(); ++i) {
        painter.setPen(penOf(i, 2.5));
        painter.drawLine(QPointF(x, line - 4), QPointF(x + 22, line - 4));
        painter.setPen(palette().color(QPalette::WindowText));
        painter.drawText(QPointF(x + 27, line), samples_.curves[i].label);
        x += 44 + fontMetrics().horizontalAdvance(samples_.curves[i].label);
    }
}

void PlotChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paintTitle(painter);
    if (!samples_.fault.isEmpty()) {
        painter.drawText(area(), Qt::AlignCenter | Qt::TextWordWrap, samples_.fault);
        return;
    }
    paintAxes(painter);
    paintCurves(painter);
}

} // namespace views
