#include "picture/creating.h"

#include "editing/number_text.h"
#include "gestures/snapping.h"
#include "gestures/wireframe.h"
#include "picture/scene_display.h"
#include "recipes/recipe_words.h"
#include "scene/shape_of.h"
#include "script/numbers.h"

#include <QKeyEvent>
#include <QPainter>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace views {

namespace {

constexpr double clickReach = 12; // pixels

// A new body falls as all others do, if they do.
void addWeightAsOthersHaveIt(std::vector<editing::NewElement>& made, const scene::Scene& scene) {
    const editing::NewElement& body = made.back();
    const auto& words = body.words;
    if (body.kind != editing::Kind::body || std::ranges::find(words, "-fixed") != words.end())
        return;
    const auto acceleration = commonGravity(scene);
    if (!acceleration)
        return;
    made.push_back({editing::Kind::force,
                    "",
                    {"-body", body.name, "-gravitational", listed(*acceleration, 0)},
                    {}});
}

// Null: it cannot rest on a body.
gestures::ShapePointer restingShape(const std::vector<scene::Part>& ghost) {
    const bool isPlane = std::ranges::any_of(ghost, [](const scene::Part& part) {
        return std::holds_alternative<scene::PlaneShape>(part.shape);
    });
    if (ghost.empty() || isPlane)
        return nullptr;
    scene::ShapeSet set;
    set.parts = ghost;
    const auto made = scene::shapeOf(set);
    const auto* shape = std::get_if<geometry::Shape>(&made);
    return shape ? std::make_shared<const geometry::Shape>(*shape) : nullptr;
}

// Along an axis.
bool isUpright(const Vector& direction) { return direction.cwiseAbs().maxCoeff() > 1 - 1e-9; }

// On a level face: above the middle of the body below where that is near, else at round numbers.
Vector besideMiddle(Vector place, const Vector& up, const Vector& middle, double resolution) {
    const double near = 1.5 * clickReach * resolution;
    const double step = editing::decimalStep(resolution);
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(up[i]) < 0.5)
            place[i] = std::abs(place[i] - middle[i]) < near ? middle[i]
                                                             : step * std::round(place[i] / step);
    return place;
}

} // namespace

Creating::Creating(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display) {
    // A thing that was clicked on may be gone, or another one.
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
    ghost_ = restingShape(recipe_->ghost);
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
    typed_.clear();
    near_.reset();
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
    if (step().wanted == Wanted::point)
        return pointAt(pixels);
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

const gestures::Snapping& Creating::snapping() {
    const Shown& shown = document_.shown();
    const gestures::Sight sight = display_.sight();
    if (!near_ || near_->of.scene != shown.scene || near_->of.motion != shown.motion ||
        near_->time != display_.time() || near_->sight.size != sight.size ||
        near_->sight.camera != sight.camera)
        near_.emplace(
            Near{shown, display_.time(), sight,
                 gestures::Snapping(display_.drawing(), sight, display_.devicePixelRatioF())});
    return near_->snapping;
}

Indicated Creating::pointAt(const Eigen::Vector2d& pixels) {
    const gestures::Sight sight = display_.sight();
    const render::Drawing drawing = display_.drawing();
    Indicated found;
    found.given = true;
    found.point = step().snaps ? sight.across(pixels, depth()) : sight.beside(pixels, depth());
    found.resolution = sight.pixelLength(found.point);
    found.sight = sight.camera.rotation.conjugate() * Vector::UnitZ();
    const bool rests = step().rests && ghost_ && !holdsOff_;
    const auto surface =
        step().surface || rests ? gestures::bodyAt(drawing, sight, pixels) : std::nullopt;
    if (surface && rests)
        return restingOn(*surface, std::move(found));
    if (surface)
        found.point = surface->point;
    if (!step().snaps || holdsOff_)
        return found;
    const gestures::Snapped meant = snapping().at(found.point);
    if (surface && !meant.isExact)
        return found;
    found.point = meant.place;
    found.at = meant.to;
    if (meant.isExact)
        found.resolution *= 0.01; // so that it meets the thing
    return found;
}

// As deep as the place before, or as all bodies are that stand in one plane, or in the middle of
// the picture.
Vector Creating::depth() const {
    if (!shown_.empty() && shown_.back().given)
        return shown_.back().point;
    const gestures::Sight sight = display_.sight();
    const Eigen::Index axis = sight.facing();
    const render::Drawing drawing = display_.drawing();
    Vector depth = sight.camera.center;
    std::optional<double> common;
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i) {
        const double one = centerOf(i).point[axis];
        if (common && std::abs(*common - one) > 1e-6 * (1 + std::abs(one)))
            return depth;
        common = one;
    }
    depth[axis] = common.value_or(0);
    return depth;
}

// It touches the surface there, and is turned as the body below it where that is a slope.
Indicated Creating::restingOn(const gestures::Picked& picked, Indicated found) {
    const render::Drawing drawing = display_.drawing();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), picked.body, drawing.time);
    const Vector up = picked.normal;
    const bool isLevel = isUpright(up);
    if (!isLevel && isUpright(pose.attitude.conjugate() * up))
        found.attitude = pose.attitude;
    Vector place = picked.point;
    const gestures::Snapped meant = snapping().at(place);
    if (meant.isExact && meant.to.starts_with("the middle of a face")) {
        place = meant.place;
        found.at = meant.to;
    } else if (isLevel) {
        place = besideMiddle(place, up, pose.position, found.resolution);
    }
    const geometry::Quaternion level = geometry::Quaternion::FromTwoVectors(up, Vector::UnitY());
    const double below =
        -geometry::bounds(*ghost_, {Vector::Zero(), level * found.attitude}).min().y();
    found.point = place + below * up;
    found.resolution *= 1e-3; // so that it touches
    if (!isLevel) {           // and a little more: a gap of rounding would be a fall
        found.resolution = 1e-9;
        found.point -= found.resolution * up;
    }
    if (found.at.empty())
        found.at = tr("on %1")
                       .arg(QString::fromStdString(drawing.scene->bodies[picked.body].name))
                       .toStdString();
    return found;
}

// Numbers that are not typed are 0. None: it is no place.
std::optional<Indicated> Creating::typed() const {
    const QStringList words =
        typed_.split(QRegularExpression(QStringLiteral("[\\s,;]+")), Qt::SkipEmptyParts);
    if (words.isEmpty() || words.size() > 3)
        return std::nullopt;
    Indicated found;
    found.given = true;
    found.sight = display_.sight().camera.rotation.conjugate() * Vector::UnitZ();
    for (qsizetype i = 0; i < words.size(); ++i) {
        const auto number = script::decimalNumber(words[i].toStdString());
        if (!number)
            return std::nullopt;
        found.point[i] = *number;
    }
    return found;
}

bool Creating::type(const QKeyEvent& event) {
    if (step().wanted != Wanted::point || event.modifiers() & Qt::ControlModifier)
        return false;
    static const QString letters = QStringLiteral("0123456789.-+eE,; ");
    if (event.key() == Qt::Key_Backspace)
        typed_.chop(1);
    else if (event.text().size() == 1 && letters.contains(event.text()) &&
             !(typed_.isEmpty() && event.text() == QLatin1String(" ")))
        typed_ += event.text();
    else
        return false;
    fault_.clear();
    next_ = typed();
    Q_EMIT changed();
    return true;
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
    found.point = sight.across(pixels, first.point);
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

void Creating::hover(const QPointF& position, bool holdsOff) {
    const QString fault = fault_;
    holdsOff_ = holdsOff;
    const bool shows = active() && !recipe_->steps.empty() &&
                       ((step().wanted == Wanted::hold && !shown_.empty()) || step().snaps);
    if (typed_.isEmpty())
        next_ = shows ? indicated(position) : std::nullopt;
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

void Creating::click(const QPointF& position, bool holdsOff) {
    fault_.clear();
    holdsOff_ = holdsOff;
    if (const auto found = indicated(position))
        take(*found);
    Q_EMIT changed();
}

void Creating::take(const Indicated& found) {
    const bool repeats = step().repeats;
    next_.reset();
    typed_.clear();
    shown_.push_back(found);
    if (!repeats && shown_.size() == recipe_->steps.size())
        finish();
}

void Creating::otherwise() {
    fault_.clear();
    if (!typed_.isEmpty()) {
        if (const auto place = typed())
            take(*place);
        else
            fault_ = tr("\"%1\" is no place: numbers for x, y and z are.").arg(typed_);
        Q_EMIT changed();
        return;
    }
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
    auto made = recipe.make(document_.text(), scene, shown_);
    const QString answer = recipe.tells ? recipe.tells(shown_) : QString();
    const bool isOutOfSight = !shown_.empty() && !made.empty() &&
                              made.back().kind == editing::Kind::body &&
                              !isInSight(shown_.front().point);
    cancel();
    if (!answer.isEmpty())
        Q_EMIT told(answer);
    if (made.empty()) {
        if (!recipe.otherwise.isEmpty())
            Q_EMIT refused(recipe.otherwise);
        return;
    }
    const editing::Kind kind = made.back().kind;
    std::size_t count = 0;
    while (editing::sourceOf(scene, {kind, count}))
        ++count;
    addWeightAsOthersHaveIt(made, scene);
    const auto edits = editing::created(document_.text(), scene, made);
    // LIMIT: a new element that is not the last of its kind is not the one that is marked.
    Q_EMIT created({kind, count}, recipe.handles);
    document_.setText(text::applied(document_.text(), edits), recipe.label);
    if (isOutOfSight) // a place that was typed
        connect(&document_, &SceneDocument::sceneChanged, &display_, &SceneDisplay::frameNow,
                Qt::SingleShotConnection);
}

bool Creating::isInSight(const Vector& place) const {
    return display_.rect().contains(display_.fromPixels(display_.sight().pixels(place)).toPoint());
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
    if (type(event))
        return true;
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
    if (!typed_.isEmpty())
        text = tr("%1: x y z = %2_  Return takes it.").arg(recipe_->label, typed_);
    return fault_.isEmpty() ? text : fault_ + " " + text;
}

// The thing as it would be, and a ring where it was drawn to another one.
void Creating::paintGhost(QPainter& painter, const Indicated& next) const {
    const gestures::Sight sight = display_.sight();
    painter.setPen(QPen(QColor(20, 90, 200, 170), 1.5));
    painter.setBrush(Qt::NoBrush);
    for (const auto& line : gestures::wireframeOf(recipe_->ghost)) {
        QPolygonF drawn;
        for (const Vector& point : line)
            drawn.append(display_.fromPixels(sight.pixels(next.point + next.attitude * point)));
        painter.drawPolyline(drawn);
    }
    painter.setPen(QPen(QColor(20, 90, 200), 2));
    const QPointF place = display_.fromPixels(sight.pixels(next.point));
    painter.drawEllipse(place, 2, 2);
    if (!next.at.empty())
        painter.drawEllipse(place, 7, 7);
    painter.setBrush(QColor(255, 255, 255, 200));
}

void Creating::paintWords(QPainter& painter, const QPointF& place, const QString& words) const {
    const QRectF box = painter.boundingRect(QRectF(place + QPointF(12, -22), QSizeF(1, 1)),
                                            Qt::AlignLeft | Qt::TextDontClip, words);
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 200));
    painter.drawRoundedRect(box.adjusted(-3, -1, 3, 1), 3, 3);
    painter.setPen(QColor(20, 90, 200));
    painter.drawText(box, Qt::AlignLeft | Qt::TextDontClip, words);
    painter.setPen(QPen(QColor(20, 90, 200), 2));
}

// "0.5 1 0, a corner of b1; 1.12 from the point before"
QString Creating::wordsOf(const Indicated& next) const {
    const std::string place = listed(next.point, next.resolution);
    QString words = QString::fromStdString(place.substr(1, place.size() - 2));
    if (!next.at.empty())
        words += ", " + QString::fromStdString(next.at);
    if (!shown_.empty() && shown_.back().given)
        words += tr("; %1 from the point before")
                     .arg(QString::fromStdString(
                         editing::numberText((next.point - shown_.back().point).norm(),
                                             editing::decimalStep(next.resolution))));
    return words;
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
    if (next_ && step().wanted == Wanted::point) {
        if (!shown_.empty() && shown_.back().given) {
            painter.setPen(QPen(QColor(20, 90, 200), 2, Qt::DashLine));
            painter.drawLine(at(shown_.back()), at(*next_));
        }
        paintGhost(painter, *next_);
        paintWords(painter, at(*next_), wordsOf(*next_));
    } else if (next_) { // as it would be
        const QPointF place = at(*next_);
        painter.setPen(QPen(QColor(20, 90, 200), 2, Qt::DashLine));
        painter.drawLine(at(shown_.front()), place);
        painter.setPen(QPen(QColor(20, 90, 200), 2));
        painter.drawEllipse(place, 7, 7);
        painter.drawEllipse(place, 2, 2);
        const auto& bodies = document_.shown().scene->bodies;
        const QString other =
            next_->body ? QString::fromStdString(bodies[*next_->body].name) : tr("the ground");
        paintWords(painter, place, other);
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
