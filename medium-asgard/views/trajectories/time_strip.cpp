#include "trajectories/time_strip.h"

#include "editing/number_text.h"
#include "plain/plain.h"
#include "script/numbers.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

namespace {

constexpr double markReach = 8; // pixels within which a mark is taken

QString number(double value) { return QString::number(value, 'g', 6); }

double roundedTime(double value, double step) {
    return editing::roundedTo(value, editing::decimalStep(step));
}

// The path that the element is, or that the force follows; none: it has none.
std::optional<std::size_t> pathOf(const scene::Scene& scene, const editing::Element& element) {
    std::size_t index = element.index;
    if (element.kind == editing::Kind::force && index < scene.forces.size()) {
        const auto* follows = std::get_if<scene::TrajectoryForce>(&scene.forces[index].kind);
        if (!follows)
            return std::nullopt;
        const auto path =
            std::ranges::find(scene.trajectories, follows->trajectory, &scene::Trajectory::name);
        index = static_cast<std::size_t>(path - scene.trajectories.begin());
    } else if (element.kind != editing::Kind::trajectory) {
        return std::nullopt;
    }
    const bool isPath =
        index < scene.trajectories.size() && !scene.trajectories[index].curves.empty();
    return isPath ? std::optional(index) : std::nullopt;
}

// A number of the knots, from 1, as the picture and the text count them.
int knotOf(const std::vector<editing::ControlPoint>& points, std::size_t point) {
    return static_cast<int>(
        std::count_if(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(point) + 1,
                      [](const editing::ControlPoint& one) { return one.onCurve; }));
}

} // namespace

TimeStrip::TimeStrip(SceneDocument& document) : document_(document), controls_(new QWidget) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setAccessibleName(tr("Times of the trajectory's points"));
    setAccessibleDescription(tr("Drag a mark to retime its point. Page Up and Page Down choose a "
                                "mark, the arrow keys retime it, Return asks for its time."));
    buildControls();
    connect(&document_, &SceneDocument::sceneChanged, this, &TimeStrip::follow);
    connect(&document_, &SceneDocument::selectionChanged, this, &TimeStrip::follow);
    setVisible(false);
    controls_->setVisible(false);
    follow();
}

void TimeStrip::buildControls() {
    auto* row = new QHBoxLayout(controls_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    const auto add = [&](const QString& text, const QString& tip, auto action) {
        auto* button = new QToolButton;
        button->setText(plain::ours(text));
        button->setAutoRaise(true);
        button->setToolTip(plain::tip(tip));
        button->setAccessibleName(tip.section(QStringLiteral(" ("), 0, 0));
        button->setFocusPolicy(Qt::TabFocus);
        connect(button, &QToolButton::clicked, this, action);
        row->addWidget(button);
    };
    add(QStringLiteral("+"), tr("A shorter time, larger (+)"),
        [this] { zoom(0.5, scale_.middle()); });
    add(QString(QChar(0x2212)), tr("A longer time (-)"), [this] { zoom(2, scale_.middle()); });
    add(QString(QChar(0x2194)), tr("The whole motion and all points (0)"), [this] { showAll(); });
}

QSize TimeStrip::sizeHint() const { return {200, 2 * fontMetrics().height() + 18}; }

// --- what is shown -----------------------------------------------------------------------------

void TimeStrip::follow() {
    const auto& scene = *document_.shown().scene;
    std::optional<std::size_t> selected;
    for (const editing::Element& one : document_.selected())
        if ((selected = pathOf(scene, one)))
            break;
    if (selected != trajectory_) {
        // A mark that is held is none of what is shown now; what it did has the old one's name.
        if (press_.grip == Grip::mark)
            press_.grip = Grip::none;
        finish();
        trajectory_ = selected;
        chosen_.reset();
        delete field_;
    }
    if (chosen_ && *chosen_ >= points().size()) {
        press_.grip = press_.grip == Grip::mark ? Grip::none : press_.grip;
        finish();
        chosen_.reset();
    }
    setToolTip(plain::tip(
        trajectory_
            ? tr("When the points of %1 are passed: drag a mark to retime its point; the wheel "
                 "zooms")
                  .arg(name())
            : QString()));
    updateVisibility();
    update();
}

void TimeStrip::setTrajectoriesShown(bool shown) {
    trajectoriesShown_ = shown;
    updateVisibility();
}

void TimeStrip::updateVisibility() {
    const bool wanted =
        trajectory_ || (trajectoriesShown_ && !document_.shown().scene->trajectories.empty());
    if (wanted != isHidden() || !parentWidget()) // not yet in a window
        return;
    if (held_ && held_())
        return QTimer::singleShot(100, this, &TimeStrip::updateVisibility);
    setVisible(wanted);
    controls_->setVisible(wanted);
}

QString TimeStrip::name() const {
    const auto& all = document_.shown().scene->trajectories;
    return trajectory_ && *trajectory_ < all.size() ? QString::fromStdString(all[*trajectory_].name)
                                                    : QString();
}

const std::vector<scene::BezierCurve>& TimeStrip::curves() const {
    static const std::vector<scene::BezierCurve> none;
    if (gesture_ && gesture_->moves()) // the scene may be on its way
        return gesture_->curves();
    return trajectory_ ? document_.shown().scene->trajectories[*trajectory_].curves : none;
}

TimeStrip::Points TimeStrip::points() const { return editing::controlPointsOf(curves()); }

void TimeStrip::setChosen(std::optional<std::size_t> point) {
    if (point == chosen_ || gesture_)
        return;
    chosen_ = point;
    update();
}

void TimeStrip::setRange(double start, double finish) {
    const double from = scale_.from(), to = scale_.to();
    scale_.setRange(start, finish);
    scaled(from != scale_.from() || to != scale_.to());
}

void TimeStrip::setTime(double time) {
    now_ = time;
    update();
}

void TimeStrip::scaled(bool isOther) {
    if (isOther)
        delete field_;
    update();
}

void TimeStrip::zoom(double factor, double about) { scaled(scale_.zoom(factor, about)); }

void TimeStrip::showAll() {
    double first = scale_.start(), last = scale_.finish();
    for (const editing::ControlPoint& point : points()) {
        first = std::min(first, point.time);
        last = std::max(last, point.time);
    }
    scaled(scale_.showAll(first, last));
}

// --- where things are --------------------------------------------------------------------------

// As wide as the scrollbar's trough, so that the same times lie above each other.
QRectF TimeStrip::area() const {
    return {4, fontMetrics().height() + 2.0, std::max(1.0, width() - 8.0), 12};
}

double TimeStrip::position(double time) const {
    return area().left() + scale_.along(time) * area().width();
}

double TimeStrip::timeAt(double x) const {
    return scale_.timeAt((x - area().left()) / area().width());
}

std::optional<std::size_t> TimeStrip::markAt(const QPointF& at) const {
    const Points all = points();
    std::optional<std::size_t> nearest;
    double best = markReach;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const double distance = std::abs(position(all[i].time) - at.x()) - (chosen_ == i ? 0.5 : 0);
        if (all[i].onCurve && distance < best) {
            best = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<QPoint> TimeStrip::placeOfChosen() const {
    const Points all = points();
    if (!chosen_ || *chosen_ >= all.size())
        return std::nullopt;
    return QPointF(position(all[*chosen_].time), area().center().y()).toPoint();
}

// --- gestures ----------------------------------------------------------------------------------

void TimeStrip::choose(std::size_t point) {
    chosen_ = point;
    Q_EMIT markChosen(*trajectory_, point);
    update();
}

void TimeStrip::chooseNext(int step) {
    const Points all = points();
    const int count = static_cast<int>(all.size());
    int at = chosen_ ? static_cast<int>(*chosen_) + step : step > 0 ? 0 : count - 1;
    while (at >= 0 && at < count && !all[static_cast<std::size_t>(at)].onCurve)
        at += step;
    if (at < 0 || at >= count)
        return;
    choose(static_cast<std::size_t>(at));
    const double time = all[static_cast<std::size_t>(at)].time;
    if (!scale_.shows(time)) // it is brought into sight
        scaled(scale_.pan(time - scale_.middle()));
}

bool TimeStrip::begin() {
    if (gesture_)
        return true;
    if (!trajectory_ || !chosen_)
        return false;
    if (const QString fault = document_.whyNotCurrent(); !fault.isEmpty()) {
        Q_EMIT says(fault, true);
        return false;
    }
    gesture_ = std::make_unique<TrajectoryDrag>(document_, *trajectory_);
    return true;
}

void TimeStrip::retime(double time) {
    if (!begin() || !chosen_)
        return;
    const editing::ControlPoint point = gesture_->edits().points()[*chosen_];
    gesture_->move(*chosen_, time, point.place, false);
    const Points now = editing::controlPointsOf(gesture_->curves());
    const bool refused = !gesture_->reason().isEmpty();
    Q_EMIT says(refused ? gesture_->reason()
                        : tr("%1: point %2 at %3 s")
                              .arg(name())
                              .arg(knotOf(now, *chosen_))
                              .arg(number(now[*chosen_].time)),
                refused);
    update();
}

void TimeStrip::nudge(double steps) {
    if (!begin())
        return;
    const double step = editing::decimalStep(5 * timeStep());
    const Points now = points();
    retime(roundedTime(now[*chosen_].time + steps * step, step));
}

void TimeStrip::finish() {
    if (!gesture_)
        return;
    const std::unique_ptr<TrajectoryDrag> gesture = std::move(gesture_);
    const QString refusal = gesture->reason();
    gesture->finish(tr("Retime point %1 of %2")
                        .arg(chosen_ ? knotOf(gesture->edits().points(), *chosen_) : 0)
                        .arg(name()));
    Q_EMIT says(refusal, true);
    update();
}

void TimeStrip::cancel() {
    if (!gesture_)
        return;
    gesture_->cancel();
    gesture_.reset();
    press_.grip = Grip::none;
    Q_EMIT says({}, false);
    update();
}

void TimeStrip::removeChosen() {
    finish(); // what keys have retimed stays so
    if (!begin())
        return;
    const std::unique_ptr<TrajectoryDrag> gesture = std::move(gesture_);
    if (gesture->remove(*chosen_))
        chosen_.reset();
    Q_EMIT says(gesture->reason(), true);
    update();
}

void TimeStrip::askForTime() {
    const auto at = placeOfChosen();
    if (!at)
        return;
    delete field_;
    field_ = new QLineEdit(this);
    field_->setAccessibleName(tr("Time of the point, in seconds"));
    field_->setText(QString::fromStdString(script::numberText(points()[*chosen_].time, true)));
    field_->selectAll();
    field_->setFixedWidth(fontMetrics().horizontalAdvance(QStringLiteral("0000000000000")));
    field_->move(std::clamp(at->x() - field_->width() / 2, 0, width() - field_->width()), 0);
    field_->installEventFilter(this);
    field_->show();
    field_->setFocus();
}

void TimeStrip::takeTime() {
    const auto time = script::decimalNumber(field_->text().trimmed().toStdString());
    if (!time) {
        Q_EMIT says(tr("A time is a decimal number, in seconds."), true);
        return;
    }
    leaveField();
    retime(*time);
    if (!gesture_ || !chosen_)
        return; // it was said why
    const bool refused = !gesture_->reason().isEmpty();
    const double is = points()[*chosen_].time;
    finish();
    if (!refused && std::abs(is - *time) > 1e-9 * std::max(1.0, std::abs(*time)))
        Q_EMIT says(
            tr("A point stays between its neighbours: %1 s is as near as it gets.").arg(number(is)),
            true);
}

// Deleted later, since it is the one that sends the event.
void TimeStrip::leaveField() {
    field_->hide();
    field_->deleteLater();
    field_ = nullptr;
    setFocus();
}

// What is typed into the field is no shortcut, and no key of the strip.
bool TimeStrip::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        event->accept();
        return true;
    }
    if (event->type() != QEvent::KeyPress || watched != field_)
        return QWidget::eventFilter(watched, event);
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape)
        leaveField();
    else if (key == Qt::Key_Return || key == Qt::Key_Enter)
        takeTime();
    else
        return false;
    return true;
}

} // namespace views
