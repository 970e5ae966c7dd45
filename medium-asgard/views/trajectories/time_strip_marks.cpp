// How a trajectory's times are drawn.
#include "charts/scale.h"
#include "frame/readable.h"
#include "handles/handles.h"
#include "trajectories/time_strip.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

QString shortNumber(double value) { return QString::number(value, 'g', 6); }

QColor markColour() {
    const scene::Color c = render::colorOf(render::HandleKind::trajectoryPoint);
    return QColor::fromRgbF(static_cast<float>(c.red), static_cast<float>(c.green),
                            static_cast<float>(c.blue));
}

} // namespace

void TimeStrip::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintScale(painter);
    paintMarks(painter);
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
        painter.drawRoundedRect(area().adjusted(-2.5, -2.5, 2.5, 2.5), 4, 4);
    }
}

void TimeStrip::paintScale(QPainter& painter) const {
    const QRectF a = area();
    QColor line = palette().color(QPalette::WindowText), faint = line;
    line.setAlpha(70);
    faint.setAlpha(170);
    painter.setPen(QPen(line, 1));
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(a.adjusted(-0.5, -0.5, 0.5, 0.5), 3, 3);
    // Where the trajectory is; between its curves there may be gaps.
    QColor along = markColour();
    along.setAlpha(60);
    for (const scene::BezierCurve& curve : curves()) {
        const double left = std::clamp(position(curve.from), a.left(), a.right());
        const double right = std::clamp(position(curve.to), a.left(), a.right());
        painter.fillRect(QRectF(left, a.top() + 3, right - left, a.height() - 6), along);
    }
    const double step = charts::roundStep(scale_.length() * 64 / a.width());
    painter.setPen(faint);
    for (const double time : charts::multiplesOf(step, scale_.from(), scale_.to())) {
        const double x = position(time);
        painter.drawLine(QPointF(x, a.bottom() + 1), QPointF(x, a.bottom() + 4));
        const QString label = shortNumber(time);
        const double wide = fontMetrics().horizontalAdvance(label);
        painter.drawText(QPointF(std::clamp(x - wide / 2, 0.0, std::max(0.0, width() - wide)),
                                 a.bottom() + 4 + fontMetrics().ascent()),
                         label);
    }
    if (scale_.shows(now_)) {
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
        painter.drawLine(QPointF(position(now_), a.top()), QPointF(position(now_), a.bottom()));
    }
}

void TimeStrip::paintMarks(QPainter& painter) const {
    const QRectF a = area();
    if (!trajectory_) {
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(QPointF(a.left(), fontMetrics().ascent()),
                         tr("The times of the trajectory that is selected"));
        return;
    }
    const Points all = points();
    const auto markInk = [&] {
        return readable(markColour().darker(130), palette().color(QPalette::Window));
    };
    double labelled = -1e9; // to where times stand already
    int before = 0, after = 0;
    const auto label = [&](std::size_t i) {
        const QString text = shortNumber(all[i].time);
        const double wide = fontMetrics().horizontalAdvance(text);
        const double left =
            std::clamp(position(all[i].time) - wide / 2, 0.0, std::max(0.0, width() - wide));
        if (left < labelled + 6)
            return;
        labelled = left + wide;
        painter.setPen(markInk());
        painter.drawText(QPointF(left, fontMetrics().ascent()), text);
    };
    if (chosen_ && *chosen_ < all.size()) { // its time has room before the others'
        label(*chosen_);
        labelled = -1e9;
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i].onCurve)
            continue;
        const double x = position(all[i].time);
        before += x < a.left() - 0.5 ? 1 : 0;
        after += x > a.right() + 0.5 ? 1 : 0;
        if (x < a.left() - 0.5 || x > a.right() + 0.5)
            continue;
        const bool isChosen = chosen_ == i;
        painter.setPen(
            QPen(isChosen ? palette().color(QPalette::Highlight) : markColour().darker(140),
                 isChosen ? 2.5 : 1.2));
        painter.setBrush(markColour());
        painter.drawEllipse(QPointF(x, a.center().y()), isChosen ? 6 : 5, isChosen ? 6 : 5);
        const double chosenAt =
            chosen_ && *chosen_ < all.size() ? position(all[*chosen_].time) : -1e9;
        if (!isChosen && std::abs(chosenAt - x) > 48)
            label(i);
    }
    painter.setPen(markInk());
    if (before > 0)
        painter.drawText(QPointF(2, fontMetrics().ascent()), tr("◂ %1").arg(before));
    if (after > 0) {
        const QString text = tr("%1 ▸").arg(after);
        painter.drawText(
            QPointF(width() - fontMetrics().horizontalAdvance(text) - 2.0, fontMetrics().ascent()),
            text);
    }
}

} // namespace views
