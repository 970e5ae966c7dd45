#include "plots/plot_chart.h"

#include "frame/readable.h"

#include "charts/scale.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr double numbers = 64, rightSpace = 16; // left of the axis, and at the end

// With the digits that a thousandth of the range needs.
QString number(double value, double range) {
    constexpr double noise = 1e-9; // of what is worked out
    if (std::abs(value) <= noise * range)
        value = 0;
    return QString::number(value, 'g', charts::digitsFor(value, range / 1000));
}

} // namespace

QPen PlotChart::penOf(std::size_t curve, double width) const {
    constexpr Qt::PenStyle lines[] = {Qt::SolidLine, Qt::DashLine, Qt::DotLine, Qt::DashDotLine};
    const charts::Curve& one = plot_.curves[curve];
    const QColor color =
        QColor::fromRgbF(static_cast<float>(one.color.red), static_cast<float>(one.color.green),
                         static_cast<float>(one.color.blue));
    return {readable(color, palette().color(QPalette::Base)), width,
            lines[static_cast<std::size_t>(one.stroke)]};
}

PlotChart::PlotChart() {
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void PlotChart::setPlot(charts::Plot plot, double start, double finish) {
    plot_ = std::move(plot);
    start_ = start;
    finish_ = finish > start ? finish : start + 1;
    range_ = charts::rangeOf(plot_);
    setAccessibleName(tr("%1 against time").arg(QString::fromStdString(plot_.title)));
    setAccessibleDescription(QString::fromStdString(plot_.values));
    update();
}

double PlotChart::leftSpace() const {
    return numbers + (plot_.values.empty() ? 0 : fontMetrics().height());
}

// Below the numbers of the times stands what they are.
QRectF PlotChart::area() const {
    const double line = fontMetrics().height(), top = 2.2 * line, bottom = 2 * line + 8;
    return {leftSpace(), top, std::max(1.0, width() - leftSpace() - rightSpace),
            std::max(1.0, height() - top - bottom)};
}

ChartAxes PlotChart::axes() const {
    return {area(),
            start_,
            finish_,
            range_.low,
            range_.high,
            QString::fromLatin1(charts::timeAxis),
            QString::fromStdString(plot_.values),
            static_cast<double>(height())};
}

QPointF PlotChart::placeOf(double time, double value) const { return axes().place(time, value); }

std::optional<std::size_t> PlotChart::sampleAt(const QPointF& position) const {
    const QRectF a = area();
    if (position.x() < a.left() || position.x() > a.right())
        return std::nullopt;
    return sampleAt(start_ + (position.x() - a.left()) / a.width() * (finish_ - start_));
}

std::optional<std::size_t> PlotChart::sampleAt(double time) const {
    if (plot_.times.empty())
        return std::nullopt;
    const auto after = std::ranges::lower_bound(plot_.times, time);
    auto at = static_cast<std::size_t>(after - plot_.times.begin());
    if (at == plot_.times.size() || (at > 0 && time - plot_.times[at - 1] < plot_.times[at] - time))
        --at;
    return at;
}

void PlotChart::setNow(double time) {
    if (time == now_)
        return;
    now_ = time;
    update();
}

QString PlotChart::valueOf(std::size_t curve, double value) const {
    return number(value, range_.high - range_.low) + QLatin1Char(' ') +
           QString::fromStdString(plot_.curves[curve].unit);
}

QString PlotChart::legendOf(std::size_t curve) const {
    const QString label = QString::fromStdString(plot_.curves[curve].label);
    const auto at = sampleAt(now_);
    const auto& values = plot_.curves[curve].values;
    return at && *at < values.size() && std::isfinite(values[*at])
               ? tr("%1 = %2").arg(label, valueOf(curve, values[*at])).trimmed()
               : label;
}

QString PlotChart::readingAt(const QPointF& position) const {
    const auto at = sampleAt(position);
    if (!at)
        return {};
    QString words = tr("t = %1 s").arg(number(plot_.times[*at], finish_ - start_));
    for (std::size_t i = 0; i < plot_.curves.size(); ++i)
        words += QStringLiteral("   %1 = %2")
                     .arg(QString::fromStdString(plot_.curves[i].label),
                          valueOf(i, plot_.curves[i].values[*at]).trimmed());
    return words;
}

void PlotChart::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton)
        choose(event->position());
}

void PlotChart::mouseMoveEvent(QMouseEvent* event) {
    pointer_ = event->position();
    if (event->buttons() & Qt::LeftButton)
        choose(event->position());
    update();
}

// The time under the pointer becomes that of the picture.
void PlotChart::choose(const QPointF& position) {
    if (const auto at = sampleAt(position))
        Q_EMIT timeChosen(plot_.times[*at]);
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
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
        const std::vector<double>& values = plot_.curves[i].values;
        QPainterPath path;
        bool joined = false;
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (!std::isfinite(values[k])) {
                joined = false;
                continue;
            }
            const QPointF place = placeOf(plot_.times[k], values[k]);
            if (joined)
                path.lineTo(place);
            else
                path.moveTo(place);
            joined = true;
        }
        painter.setPen(penOf(i, 1.8));
        painter.drawPath(path);
        if (now && std::isfinite(values[*now]))
            painter.drawEllipse(placeOf(plot_.times[*now], values[*now]), 3.5, 3.5);
    }
    painter.setClipping(false);
}

void PlotChart::paintNow(QPainter& painter) const {
    if (now_ < start_ || now_ > finish_)
        return;
    const double x = placeOf(now_, range_.low).x();
    painter.setPen(QPen(palette().color(QPalette::Highlight), 1.2));
    painter.drawLine(QPointF(x, area().top()), QPointF(x, area().bottom()));
}

// The title, and what the curves are; with the pointer over them what they are worth.
void PlotChart::paintTitle(QPainter& painter) const {
    const double line = 4 + fontMetrics().ascent();
    QFont bold = font();
    bold.setBold(true);
    painter.setFont(bold);
    painter.setPen(palette().color(QPalette::WindowText));
    const QString title = QString::fromStdString(plot_.title);
    painter.drawText(QPointF(leftSpace(), line), title);
    const double behind = leftSpace() + QFontMetricsF(bold).horizontalAdvance(title) + 20;
    painter.setFont(font());
    const QString reading = pointer_ ? readingAt(*pointer_) : QString();
    if (!reading.isEmpty()) {
        painter.drawText(QPointF(behind, line), reading);
        return;
    }
    double x = behind;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) {
        painter.setPen(penOf(i, 2.5));
        painter.drawLine(QPointF(x, line - 4), QPointF(x + 22, line - 4));
        painter.setPen(palette().color(QPalette::WindowText));
        const QString label = legendOf(i);
        painter.drawText(QPointF(x + 27, line), label);
        x += 44 + fontMetrics().horizontalAdvance(label);
    }
}

void PlotChart::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.fillRect(rect(), palette().base());
    paintTitle(painter);
    if (!plot_.fault.empty()) {
        painter.drawText(area(), Qt::AlignCenter | Qt::TextWordWrap,
                         QString::fromStdString(plot_.fault));
        return;
    }
    paintAxes(painter);
    paintNow(painter);
    paintCurves(painter);
}

} // namespace views
