#include "picture/creating.h"

#include "picture/scene_display.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace views {

namespace {

constexpr double clickReach = 12; // pixels

} // namespace

Creating::Creating(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    // What was clicked on may be gone, or another one.
    connect(&document_, &SceneDocument::textChanged, this, [this] {
        if (!recipe_)
            return;
        cancel();
        Q_EMIT refused(tr("The text was changed meanwhile."));
    });
}

const Step& Creating::step() const {
    return recipe_->steps[std::min(shown_.size(), recipe_->steps.size() - 1)];
}

void Creating::start(Recipe recipe) {
    cancel();
    if (!document_.sceneIsCurrent()) {
        Q_EMIT refused(document_.whyNotCurrent());
        return;
    }
    recipe_ = std::move(recipe);
    if (recipe_->steps.empty())
        return finish();
    offerBody();
    display_.keepCamera(); // what is clicked is where it stands
    display_.setFocus();
    for (const Step& one : recipe_->steps)
        if (one.wanted == Wanted::trajectory)
            Q_EMIT needs(&render::Display::trajectories);
    Q_EMIT changed();
}

// Return takes the body that is selected, or the only one.
void Creating::offerBody() {
    Step& first = recipe_->steps.front();
    if (first.wanted != Wanted::body || !first.otherwise.isEmpty())
        return;
    const auto& bodies = document_.shown().scene->bodies;
    std::vector<std::size_t> candidates;
    for (const editing::Element& element : document_.selected())
        if (element.kind == editing::Kind::body)
            candidates.push_back(element.index);
    if (candidates.empty() && bodies.size() == 1)
        candidates = {0};
    if (candidates.size() != 1)
        return;
    first.offered = candidates.front();
    first.otherwise =
        tr("Return: %1.").arg(QString::fromStdString(bodies[candidates.front()].name));
}

void Creating::cancel() {
    recipe_.reset();
    shown_.clear();
    next_.reset();
    fault_.clear();
    cross_.reset();
    Q_EMIT changed();
}

std::optional<Indicated> Creating::indicated(const QPointF& position) {
    const gestures::Sight sight = display_.sight();
    const Eigen::Vector2d pixels = display_.inPixels(position);
    const render::Drawing drawing = display_.drawing();
    Indicated found;
    found.given = true;
    if (step().wanted == Wanted::trajectory) {
        found.trajectory = gestures::trajectoryAt(*drawing.scene, sight, pixels,
                                                  clickReach * display_.devicePixelRatioF());
        if (!found.trajectory)
            fault_ = tr("There is no trajectory.");
        return found.trajectory ? std::optional(found) : std::nullopt;
    }
    if (step().wanted == Wanted::hold)
        return held(pixels);
    if (step().wanted == Wanted::point) {
        const Vector depth =
            shown_.empty() || !shown_.back().given ? sight.camera.center : shown_.back().point;
        found.point = sight.beside(pixels, depth);
        found.resolution = sight.pixelLength(found.point);
        found.sight = sight.camera.rotation.conjugate() * Vector::UnitZ();
        return found;
    }
    const auto picked = gestures::bodyAt(drawing, sight, pixels);
    if (!picked) {
        fault_ = tr("There is no body.");
        return std::nullopt;
    }
    const Indicated center = centerOf(picked->body);
    if (step().whole || (sight.pixels(center.point) - pixels).norm() <=
                            0.7 * clickReach * display_.devicePixelRatioF())
        return center;
    return onBody(picked->body, step().deep ? sight.beside(pixels, center.point) : picked->point);
}

// A point of the world on a body; one that is meant to be deep lies on the body's axes if near.
Indicated Creating::onBody(std::size_t body, const Vector& point) const {
    const render::Drawing drawing = display_.drawing();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time);
    Indicated found = centerOf(body);
    found.atCenter = false;
    found.resolution = display_.sight().pixelLength(point);
    found.onBody = pose.toLocal(point);
    if (step().deep)
        found.onBody = onAxes(body, found.onBody, found.resolution);
    found.point = pose.toWorld(found.onBody);
    return found;
}

// A hand's unsteadiness beside an axis of the body through its centre is none.
Vector Creating::onAxes(std::size_t body, const Vector& onBody, double near) const {
    const render::Drawing drawing = display_.drawing();
    const bool known = drawing.motion && body < drawing.motion->bodies();
    Vector from = onBody - (known ? drawing.motion->centroid(body) : Vector::Zero());
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(from[i]) < 0.6 * clickReach * display_.devicePixelRatioF() * near)
            from[i] = 0;
    return from + (known ? drawing.motion->centroid(body) : Vector::Zero());
}

// Where something holds the first body: in the plane of the screen through what was shown of it.
Indicated Creating::held(const Eigen::Vector2d& pixels) const {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    const Indicated& first = shown_.front();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), *first.body, drawing.time);
    Indicated found;
    found.given = true;
    found.point = sight.beside(pixels, first.point);
    found.resolution = sight.pixelLength(found.point);
    const auto other = gestures::bodyAt(drawing, sight, pixels, first.body);
    if (other) {
        const Indicated center = centerOf(other->body);
        found.body = other->body;
        found.atCenter = (sight.pixels(center.point) - pixels).norm() <=
                         0.7 * clickReach * display_.devicePixelRatioF();
        const geometry::Pose its =
            render::poseOf(*drawing.scene, drawing.motion.get(), other->body, drawing.time);
        found.onBody = found.atCenter
                           ? center.onBody
                           : onAxes(other->body, its.toLocal(found.point), found.resolution);
        found.point = its.toWorld(found.onBody);
    }
    found.onFirst = onAxes(*first.body, pose.toLocal(found.point), found.resolution);
    if (!other && first.atCenter)
        found.point = pose.toWorld(found.onFirst);
    return found;
}

void Creating::hover(const QPointF& position) {
    const QString fault = fault_;
    next_ = active() && !shown_.empty() && step().wanted == Wanted::hold ? indicated(position)
                                                                         : std::nullopt;
    fault_ = fault;
    if (active())
        Q_EMIT changed();
}

Indicated Creating::centerOf(std::size_t body) const {
    const render::Drawing drawing = display_.drawing();
    const bool known = drawing.motion && body < drawing.motion->bodies();
    Indicated center;
    center.given = center.atCenter = true;
    center.body = body;
    center.attitude =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time).attitude;
    center.sight = display_.sight().camera.rotation.conjugate() * Vector::UnitZ();
    center.onBody = known ? drawing.motion->centroid(body) : Vector::Zero();
    center.point = render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time)
                       .toWorld(center.onBody);
    center.resolution = display_.sight().pixelLength(center.point);
    return center;
}

void Creating::click(const QPointF& position) {
    fault_.clear();
    if (const auto found = indicated(position))
        take(*found);
    Q_EMIT changed();
}

void Creating::take(const Indicated& found) {
    const bool repeats = step().repeats;
    next_.reset();
    shown_.push_back(found);
    if (!repeats && shown_.size() == recipe_->steps.size())
        finish();
}

void Creating::otherwise() {
    fault_.clear();
    if (step().repeats)
        return finish();
    if (step().offered)
        take(centerOf(*step().offered));
    else if (!step().otherwise.isEmpty())
        take({});
    else
        fault_ = tr("Click, or go there with the arrow keys.");
    Q_EMIT changed();
}

void Creating::finish() {
    const Recipe recipe = *recipe_;
    const scene::Scene& scene = *document_.shown().scene;
    const auto made = recipe.make(document_.text(), scene, shown_);
    cancel();
    if (made.empty()) {
        if (!recipe.otherwise.isEmpty())
            Q_EMIT refused(recipe.otherwise);
        return;
    }
    const editing::Kind kind = made.back().kind;
    std::size_t count = 0;
    while (editing::sourceOf(scene, {kind, count}))
        ++count;
    const auto edits = editing::created(document_.text(), scene, made);
    // LIMIT: a new element that is not the last of its kind is not the one that is marked.
    Q_EMIT created({kind, count}, recipe.handles);
    document_.setText(text::applied(document_.text(), edits), recipe.label);
}

bool Creating::key(const QKeyEvent& event) {
    if (!recipe_)
        return false;
    const double stride = event.modifiers() & Qt::ControlModifier ? 2 : 12;
    const auto cross = [&](double x, double y) {
        const QPointF now = cross_.value_or(QRectF(display_.rect()).center());
        cross_ = QPointF(std::clamp(now.x() + x, 0.0, display_.width() - 1.0),
                         std::clamp(now.y() + y, 0.0, display_.height() - 1.0));
        Q_EMIT changed();
    };
    switch (event.key()) {
    case Qt::Key_Escape:
        cancel();
        return true;
    case Qt::Key_Left:
        cross(-stride, 0);
        return true;
    case Qt::Key_Right:
        cross(stride, 0);
        return true;
    case Qt::Key_Up:
        cross(0, -stride);
        return true;
    case Qt::Key_Down:
        cross(0, stride);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (cross_)
            click(*std::exchange(cross_, std::nullopt));
        else
            otherwise();
        return true;
    case Qt::Key_Delete: // what is selected is not meant now
    case Qt::Key_Backspace:
    case Qt::Key_Insert:
        return true;
    default:
        return false;
    }
}

QString Creating::prompt() const {
    if (!recipe_ || recipe_->steps.empty())
        return {};
    QString text = tr("%1: %2").arg(recipe_->label, step().prompt);
    if (!step().otherwise.isEmpty())
        text += " " + step().otherwise;
    return fault_.isEmpty() ? text : fault_ + " " + text;
}

void Creating::paint(QPainter& painter) const {
    if (!recipe_)
        return;
    const gestures::Sight sight = display_.sight();
    const auto at = [&](const Indicated& one) {
        return display_.fromPixels(sight.pixels(one.point));
    };
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    painter.setBrush(QColor(255, 255, 255, 200));
    for (std::size_t i = 0; i < shown_.size(); ++i) {
        if (!shown_[i].given || shown_[i].trajectory)
            continue;
        if (i > 0 && shown_[i - 1].given)
            painter.drawLine(at(shown_[i - 1]), at(shown_[i]));
        painter.drawEllipse(at(shown_[i]), 4, 4);
    }
    if (next_) { // as it would be
        const QPointF place = at(*next_);
        painter.setPen(QPen(QColor(20, 90, 200), 2, Qt::DashLine));
        painter.drawLine(at(shown_.front()), place);
        painter.setPen(QPen(QColor(20, 90, 200), 2));
        painter.drawEllipse(place, 7, 7);
        painter.drawEllipse(place, 2, 2);
        const auto& bodies = document_.shown().scene->bodies;
        const QString other =
            next_->body ? QString::fromStdString(bodies[*next_->body].name) : tr("the ground");
        const QRectF words = painter.boundingRect(QRectF(place + QPointF(12, -22), QSizeF(1, 1)),
                                                  Qt::AlignLeft | Qt::TextDontClip, other);
        painter.setPen(Qt::NoPen);
        painter.drawRoundedRect(words.adjusted(-3, -1, 3, 1), 3, 3);
        painter.setPen(QColor(20, 90, 200));
        painter.drawText(words, Qt::AlignLeft | Qt::TextDontClip, other);
        painter.setPen(QPen(QColor(20, 90, 200), 2));
    }
    if (cross_) {
        painter.drawLine(*cross_ - QPointF(9, 0), *cross_ + QPointF(9, 0));
        painter.drawLine(*cross_ - QPointF(0, 9), *cross_ + QPointF(0, 9));
    }
    const QRect space = display_.rect().adjusted(12, 10, -12, -10);
    const QString text = prompt();
    const QRect needed = painter.boundingRect(space, Qt::AlignLeft | Qt::TextWordWrap, text);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(20, 90, 200, 230));
    painter.drawRoundedRect(needed.adjusted(-6, -4, 6, 4), 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(space, Qt::AlignLeft | Qt::TextWordWrap, text);
}

} // namespace views
