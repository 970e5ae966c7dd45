#include "panels/time_bar.h"

#include "charts/scale.h"
#include "plain/plain.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

constexpr int whole = 1'000'000; // slider values from start to finish

} // namespace

TimeBar::TimeBar(QWidget* parent) : QAbstractSlider(parent) {
    QAbstractSlider::setRange(0, whole);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setOrientation(Qt::Horizontal);
    setAccessibleName(tr("Time"));
    setToolTip(tr("The line is now; the outline beside it is one second long"));
}

QSize TimeBar::sizeHint() const { return {200, fontMetrics().height() + 24}; }

QRectF TimeBar::trough() const { return {4, 3, width() - 8.0, 16}; }

double TimeBar::position(double time) const {
    const double share = finish_ > start_ ? (time - start_) / (finish_ - start_) : 0;
    return trough().left() + share * trough().width();
}

double TimeBar::timeAt(double position) const {
    return start_ + (position - trough().left()) / trough().width() * (finish_ - start_);
}

QRectF TimeBar::slider() const {
    const double left = position(time_);
    // Never too thin to be taken, never over the end.
    const double second = (position(start_ + 1) - position(start_));
    const double right = std::min(left + std::max(second, 7.0), trough().right() + 4);
    return {left, trough().top() - 1, std::max(right - left, 4.0), trough().height() + 2};
}

void TimeBar::setRange(double start, double finish, double computed) {
    start_ = start;
    finish_ = finish;
    computed_ = computed;
    const double second = finish > start ? whole / (finish - start) : whole;
    setPageStep(static_cast<int>(std::clamp(second, 1.0, whole / 2.0)));
    setSingleStep(std::max(1, pageStep() / 25));
    setTime(time_);
    update();
}

void TimeBar::setMarks(std::optional<double> predictableUntil, std::vector<double> impacts) {
    predictableUntil_ = predictableUntil;
    impacts_ = std::move(impacts);
    update();
}

void TimeBar::setFaults(std::vector<Fault> faults) {
    faults_ = std::move(faults);
    update();
}

QString TimeBar::faultsAt(double position) const {
    constexpr double near = 6; // pixels
    QStringList words;
    for (const Fault& fault : faults_)
        if (std::abs(this->position(fault.time) - position) <= near)
            words << fault.words;
    return words.join('\n');
}

QString TimeBar::wordsAt(double position) const {
    constexpr double near = 3; // pixels
    QString words = faultsAt(position);
    double first = 0;
    qsizetype count = 0;
    for (const double impact : impacts_)
        if (std::abs(this->position(impact) - position) <= near && count++ == 0)
            first = impact;
    if (count == 0)
        return words;
    words += words.isEmpty() ? "" : "\n";
    return words + (count == 1
                        ? tr("A collision at %1 s").arg(first, 0, 'g', 4)
                        : tr("%1 collisions, the first at %2 s").arg(count).arg(first, 0, 'g', 4));
}

bool TimeBar::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const QString words = wordsAt(help->pos().x());
        if (words.isEmpty())
            QToolTip::hideText();
        else
            QToolTip::showText(help->globalPos(), plain::tip(words), this);
        return true;
    }
    return QAbstractSlider::event(event);
}

void TimeBar::setStale(bool stale) {
    if (std::exchange(isStale_, stale) != stale)
        update();
}

void TimeBar::setTime(double time) {
    time_ = time;
    setting_ = true;
    const double share = finish_ > start_ ? (time - start_) / (finish_ - start_) : 0;
    setValue(static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * whole)));
    setting_ = false;
    update();
}

void TimeBar::sliderChange(SliderChange change) {
    QAbstractSlider::sliderChange(change);
    if (change == SliderValueChange && !setting_)
        Q_EMIT timeChosen(start_ + (finish_ - start_) * value() / whole);
    update();
}

void TimeBar::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    const double x = event->position().x();
    const QRectF grip = slider();
    grip_ = grip.contains(QPointF(x, grip.center().y())) ? x - grip.left() : 0;
    pressed_ = x;
    setSliderDown(true);
    Q_EMIT timeChosen(std::clamp(timeAt(x - grip_), start_, finish_));
}

void TimeBar::mouseMoveEvent(QMouseEvent* event) {
    const double x = event->position().x();
    constexpr double still = 3; // pixels: fine drags are meant, too
    if (pressed_ && std::abs(x - *pressed_) < still)
        return;
    pressed_.reset();
    if (isSliderDown())
        Q_EMIT timeChosen(std::clamp(timeAt(x - grip_), start_, finish_));
}

// A click means the time at which it is, also within the slider, which may be as long as the bar.
void TimeBar::mouseReleaseEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton)
        return;
    if (const auto clicked = std::exchange(pressed_, std::nullopt); clicked && isSliderDown())
        Q_EMIT timeChosen(std::clamp(timeAt(*clicked), start_, finish_));
    setSliderDown(false);
}

QColor TimeBar::faint(int alpha) const {
    QColor color = palette().color(QPalette::WindowText);
    color.setAlpha(alpha);
    return color;
}

void TimeBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintTrough(painter);
    paintScale(painter);
    paintSlider(painter);
    paintFaults(painter);
}

void TimeBar::paintTrough(QPainter& painter) const {
    const QPalette& p = palette();
    const QRectF area = trough();
    painter.setPen(QPen(faint(70), 1));
    painter.setBrush(p.color(QPalette::Base));
    painter.drawRoundedRect(area.adjusted(-0.5, -0.5, 0.5, 0.5), 3, 3);
    // What is computed, and of that what is not to be relied on.
    painter.setPen(Qt::NoPen);
    QColor known = isStale_ ? p.color(QPalette::WindowText) : p.color(QPalette::Highlight);
    known.setAlpha(isStale_ ? 25 : 55);
    painter.fillRect(
        QRectF(area.left(), area.top() + 1, position(computed_) - area.left(), area.height() - 2),
        known);
    if (predictableUntil_ && *predictableUntil_ < computed_) {
        const QRectF unsure(position(*predictableUntil_), area.top() + 1,
                            position(computed_) - position(*predictableUntil_), area.height() - 2);
        painter.fillRect(unsure, p.color(QPalette::Base));
        painter.fillRect(unsure, QBrush(faint(70), Qt::BDiagPattern));
    }
    painter.setPen(QPen(QColor(0xD0, 0x6A, 0x10), 1));
    double lastMark = -10;
    for (double impact : impacts_)
        if (const double x = position(impact); x > lastMark + 1.5) {
            painter.drawLine(QPointF(x, area.top() + 2), QPointF(x, area.top() + 6));
            lastMark = x;
        }
}

// Triangles that point down at their times.
void TimeBar::paintFaults(QPainter& painter) const {
    const double top = trough().top();
    painter.setPen(QPen(palette().color(QPalette::Window), 1));
    for (const Fault& fault : faults_) {
        const double x = position(fault.time);
        painter.setBrush(fault.isError ? QColor(0xC8, 0x28, 0x1E) : QColor(0xE0, 0x9A, 0x10));
        painter.drawPolygon(
            QPolygonF({QPointF(x - 5, top - 1), QPointF(x + 5, top - 1), QPointF(x, top + 8)}));
    }
}

// Seconds, or what is round, below.
void TimeBar::paintScale(QPainter& painter) const {
    const QRectF area = trough();
    const double length = std::max(finish_ - start_, 1e-12);
    const double step = charts::roundStep(length * 64 / std::max(area.width(), 64.0));
    painter.setPen(faint(170));
    const double first = std::ceil(start_ / step - 1e-9);
    for (int i = 0; (first + i) * step <= finish_ + 1e-9 * length; ++i) {
        const double t = (first + i) * step, x = position(t);
        painter.drawLine(QPointF(x, area.bottom() + 1), QPointF(x, area.bottom() + 4));
        const QString label = QString::number(t, 'g', 6);
        const double half = fontMetrics().horizontalAdvance(label) / 2.0;
        const double left = std::clamp(x - half, 0.0, width() - 2 * half);
        painter.drawText(QPointF(left, area.bottom() + 5 + fontMetrics().ascent()), label);
    }
}

// A line with a head is now; the second that it is long is a bare outline: what is filled is
// computed.
void TimeBar::paintSlider(QPainter& painter) const {
    const QPalette& p = palette();
    const QRectF area = trough();
    const QRectF grip = slider();
    painter.setPen(QPen(faint(isSliderDown() ? 160 : 90), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(grip.adjusted(0.5, 0.5, -0.5, -0.5), 2.5, 2.5);
    const QColor ink = isSliderDown() ? p.color(QPalette::Highlight) : faint(255);
    painter.setPen(QPen(ink, 2, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(grip.left(), grip.top()), QPointF(grip.left(), grip.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(ink);
    const double top = grip.top() - 1;
    painter.drawPolygon(QPolygonF({QPointF(grip.left() - 5, top), QPointF(grip.left() + 5, top),
                                   QPointF(grip.left() + 5, top + 3), QPointF(grip.left(), top + 8),
                                   QPointF(grip.left() - 5, top + 3)}));
    if (hasFocus()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(p.color(QPalette::Highlight), 1));
        painter.drawRoundedRect(area.adjusted(-2.5, -2.5, 2.5, 2.5), 4, 4);
    }
}

} // namespace views
