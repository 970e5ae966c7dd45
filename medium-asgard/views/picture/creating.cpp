#include "picture/creating.h"

#include "editing/number_text.h"
#include "gestures/snapping.h"
#include "gestures/standing.h"
#include "gestures/wireframe.h"
#include "picture/scene_display.h"
#include "recipes/recipe_words.h"

#include <algorithm>
#include <cmath>

namespace views {

namespace {

bool isBody(const editing::NewElement& one) { return one.kind == editing::Kind::body; }

// New bodies fall as all others do, if they do.
void addWeightAsOthersHaveIt(std::vector<editing::NewElement>& made, const scene::Scene& scene) {
    const auto acceleration = commonGravity(scene);
    if (!acceleration)
        return;
    std::vector<editing::NewElement> weights;
    for (const editing::NewElement& one : made)
        if (isBody(one) && std::ranges::find(one.words, "-fixed") == one.words.end())
            weights.push_back({editing::Kind::force,
                               "",
                               {"-body", one.name, "-gravitational", listed(*acceleration, 0)},
                               {}});
    made.insert(made.end(), weights.begin(), weights.end());
}

// The element that is marked then: of several new ones the first body, and a body that the recipe
// changes before forces on it.
editing::Element markedOf(const scene::Scene& scene, const std::vector<editing::NewElement>& made,
                          const std::vector<editing::Wish>& changed) {
    const bool isBodyMade = std::ranges::any_of(made, isBody);
    if (!isBodyMade && !changed.empty())
        return changed.front().element;
    editing::Element element{isBodyMade ? editing::Kind::body : made.back().kind, 0};
    while (editing::sourceOf(scene, element))
        ++element.index;
    return element;
}

// Along an axis.
bool isUpright(const Vector& direction) { return direction.cwiseAbs().maxCoeff() > 1 - 1e-9; }

// Along the axes of the world that lie in a face, all of a level one: above the middle of the body
// below where that is near, else at round numbers.
Vector besideMiddle(Vector place, const Vector& up, const Vector& middle, double reach,
                    double step) {
    const double near = std::min(reach, step / 2);
    for (Eigen::Index i = 0; i < 3; ++i)
        if (std::abs(up[i]) < 1e-9)
            place[i] = std::abs(place[i] - middle[i]) < near ? middle[i]
                                                             : step * std::round(place[i] / step);
    return place;
}

} // namespace

Creating::Creating(SceneDocument& document, SceneDisplay& display)
    : document_(document), display_(display), later_(document) {
    // A thing that was clicked on may be gone, or another one.
    connect(&document_, &SceneDocument::textChanged, this, [this] {
        forgetMeasured();
        if (!active())
            return;
        cancel();
        Q_EMIT refused(tr("The text was changed meanwhile."));
    });
    connect(&display_, &SceneDisplay::pictured, this, &Creating::stopWaiting);
    connect(&display_, &SceneDisplay::pictured, this, &Creating::clickSeen);
}

const Step& Creating::step() const {
    return recipe_->steps[std::min(shown_.size(), recipe_->steps.size() - 1)];
}

void Creating::start(Recipe recipe) {
    start([recipe = std::move(recipe)] { return recipe; });
}

void Creating::start(std::function<Recipe()> recipe, std::optional<Aim> aim) {
    cancel();
    forgetMeasured();
    display_.editing().say({}); // it was about what was done before
    waiting_.emplace(Waiting{std::move(recipe), std::move(aim), {}});
    later_.take(this, [this] { stopWaiting(); });
    if (!waiting_)
        return;
    display_.setFocus();
    Q_EMIT changed();
}

// Keys act on what is seen.
void Creating::stopWaiting() {
    if (!waiting_ || document_.isAwaited())
        return;
    if (!document_.sceneIsCurrent()) {
        cancel();
        Q_EMIT refused(document_.whyNotCurrent());
        return;
    }
    if (!waiting_->keys.empty()) {
        display_.bringUpToDate();
        if (!display_.showsScene())
            return;
    }
    const Waiting waited = *std::exchange(waiting_, std::nullopt);
    begin(waited.recipe());
    if (waited.aim && recipe_)
        takeAim(*waited.aim);
    for (const std::unique_ptr<QKeyEvent>& typed : waited.keys)
        if (!key(*typed))
            handBack(*typed);
}

void Creating::clickSeen() {
    while (recipe_ && !clicks_.empty() && display_.showsScene()) {
        const Click first = clicks_.front();
        clicks_.erase(clicks_.begin());
        fault_.clear();
        holdsOff_ = first.holdsOff;
        if (const auto found = indicated(first.position))
            take(*found);
        Q_EMIT changed();
    }
}

Creating::Aim Creating::aimAt(const editing::Element& body, const QPointF& position) const {
    const render::Drawing drawing = display_.drawing();
    Aim aim{following(document_, {body}), std::nullopt};
    const auto picked = gestures::bodyAt(drawing, display_.sight(), display_.inPixels(position));
    if (picked && picked->body == body.index)
        aim.place = render::poseOf(*drawing.scene, drawing.motion.get(), body.index, drawing.time)
                        .toLocal(picked->point);
    return aim;
}

void Creating::takeAim(const Aim& aim) {
    const auto body = aim.body();
    if (!body) {
        cancel();
        Q_EMIT refused(tr("The body is gone."));
        return;
    }
    const std::size_t index = body->front().index;
    const render::Drawing drawing = display_.drawing();
    take(aim.place ? indicatedOn(index, render::poseOf(*drawing.scene, drawing.motion.get(), index,
                                                       drawing.time)
                                            .toWorld(*aim.place))
                   : centerOf(index));
    Q_EMIT changed();
}

void Creating::begin(Recipe recipe) {
    fault_.clear();
    recipe_ = std::move(recipe);
    times_ = 1;
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
    waiting_.reset();
    recipe_.reset();
    shown_.clear();
    next_.reset();
    fault_.clear();
    cross_.reset();
    clicks_.clear();
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
    return indicatedOn(picked->body, picked->point);
}

// A body that is shown by a place of its surface.
Indicated Creating::indicatedOn(std::size_t body, const Vector& surface) const {
    const gestures::Sight sight = display_.sight();
    const Eigen::Vector2d pixels = sight.pixels(surface);
    Indicated center = centerOf(body);
    if (step().whole || (sight.pixels(center.point) - pixels).norm() <=
                            0.7 * clickReach * display_.devicePixelRatioF())
        return center;
    return onBody(body, step().deep ? sight.beside(pixels, center.point) : surface);
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
    if (rests)
        if (const auto on = onGrid(pixels, found))
            return *on;
    fit(surface ? surface->point : found.point);
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

// It stands on the grid that is seen there, at round numbers, or where a thing on it draws it.
std::optional<Indicated> Creating::onGrid(const Eigen::Vector2d& pixels, Indicated found) {
    const auto ground = display_.ground();
    const gestures::Sight sight = display_.sight();
    const auto place =
        ground ? gestures::onGround(sight, pixels, ground->up, ground->height) : std::nullopt;
    if (!place)
        return std::nullopt;
    fit(*place);
    found.resolution = sight.pixelLength(*place);
    const gestures::Snapped meant = snapping().at(*place);
    found.point = meant.isExact ? meant.place : *place;
    if (!meant.isExact) {
        const double step = snapping().step(*place);
        for (const int axis : ground->across)
            found.point[axis] = step * std::round(found.point[axis] / step);
    }
    found.point += (ground->height - found.point.dot(ground->up)) * ground->up;
    found.at = meant.isExact ? meant.to : tr("on the grid").toStdString();
    found.point += heightOf(ground->up, found.attitude) * ground->up;
    const auto free =
        gestures::standingFree(display_.drawing(), *ghost_, {found.point, found.attitude}, *ground,
                               snapping().step(*place));
    if (free && *free != found.point)
        found.at = tr("on the grid, where there is room").toStdString();
    found.point = free.value_or(found.point);
    found.resolution *= 1e-3; // so that it touches
    return found;
}

// The way from its lowest point to its origin, upwards, where it is turned so.
double Creating::heightOf(const Vector& up, const geometry::Quaternion& attitude) const {
    const geometry::Quaternion level = geometry::Quaternion::FromTwoVectors(up, Vector::UnitY());
    return -geometry::bounds(*ghost_, {Vector::Zero(), level * attitude}).min().y();
}

// It touches the surface there, and is turned as the body below it where that is a slope.
Indicated Creating::restingOn(const gestures::Picked& picked, Indicated found) {
    const render::Drawing drawing = display_.drawing();
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), picked.body, drawing.time);
    fit(picked.point);
    const Vector up = picked.normal;
    const bool isLevel = isUpright(up);
    if (!isLevel && isUpright(pose.attitude.conjugate() * up))
        found.attitude = pose.attitude;
    Vector place = picked.point;
    const gestures::Snapped meant = snapping().at(place);
    if (meant.isExact && meant.to.starts_with("the middle of a face")) {
        place = meant.place;
        found.at = meant.to;
    } else {
        place = besideMiddle(place, up, pose.position, 1.5 * clickReach * found.resolution,
                             snapping().step(place));
    }
    found.point = place + heightOf(up, found.attitude) * up;
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

void Creating::hover(const QPointF& position, bool holdsOff) {
    const QString fault = fault_;
    holdsOff_ = holdsOff;
    const bool shows =
        recipe_ && !recipe_->steps.empty() &&
        ((step().wanted == Wanted::hold && !shown_.empty()) || step().snaps || step().judge);
    if (shows)
        display_.bringUpToDate();
    if (typed_.isEmpty())
        next_ = shows && display_.showsScene() ? indicated(position) : std::nullopt;
    fault_ = fault;
    if (active())
        Q_EMIT changed();
}

std::optional<Judged> Creating::judge(const Indicated& next) const {
    return step().judge && (next.body || step().wanted == Wanted::point)
               ? std::optional(step().judge(*document_.shown().scene, shown_, next))
               : std::nullopt;
}

Indicated Creating::centerOf(std::size_t body) const {
    const render::Drawing drawing = display_.drawing();
    Indicated center;
    center.given = center.atCenter = true;
    center.body = body;
    center.attitude =
        render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time).attitude;
    center.sight = display_.sight().camera.rotation.conjugate() * Vector::UnitZ();
    center.onBody = display_.centroidOf(body);
    center.point = render::poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time)
                       .toWorld(center.onBody);
    center.resolution = display_.sight().pixelLength(center.point);
    return center;
}

void Creating::click(const QPointF& position, bool holdsOff) {
    display_.bringUpToDate();
    if (waiting_) { // what will stand there is not seen yet
        fault_ = tr("The click came before the scene.");
        Q_EMIT changed();
        return;
    }
    clicks_.push_back({position, holdsOff});
    clickSeen();
}

void Creating::take(const Indicated& found) {
    if (const auto judged = judge(found); judged && !judged->isTaken) {
        fault_ = judged->words;
        return;
    }
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
        if (const auto place = typed()) {
            fit(place->point);
            take(*place);
        } else {
            fault_ = tr("\"%1\" is no place: numbers for x, y and z are.").arg(typed_);
        }
        Q_EMIT changed();
        return;
    }
    if (step().repeats)
        return finish();
    if (step().offered) {
        take(centerOf(*step().offered));
    } else if (!step().otherwise.isEmpty()) {
        fit(Vector::Zero());
        take({});
    } else {
        fault_ = tr("Click, or go there with the arrow keys.");
    }
    Q_EMIT changed();
}

void Creating::finish() {
    const Recipe recipe = *recipe_;
    const scene::Scene& scene = *document_.shown().scene;
    auto made = recipe.make(document_.text(), scene, shown_);
    const auto moved = recipe.moves ? recipe.moves(scene, shown_) : std::vector<editing::Wish>();
    const QString answer = recipe.tells ? recipe.tells(shown_) : QString();
    if (!answer.isEmpty())
        measured_ = {shown_.front().point, shown_.back().point, answer};
    const bool isOutOfSight =
        !shown_.empty() && std::ranges::any_of(made, isBody) && !isInSight(recipe);
    cancel();
    if (!answer.isEmpty())
        Q_EMIT told(answer);
    const editing::Answer changes = answerTo(moved);
    if (!changes.possible()) {
        Q_EMIT refused(QString::fromStdString(changes.reason));
        return;
    }
    if (made.empty() && changes.edits.empty()) {
        if (!recipe.otherwise.isEmpty())
            Q_EMIT refused(recipe.otherwise);
        return;
    }
    const editing::Element marked = markedOf(scene, made, moved);
    addWeightAsOthersHaveIt(made, scene);
    text::Edits edits = editing::created(document_.text(), scene, made);
    edits.insert(edits.end(), changes.edits.begin(), changes.edits.end());
    text::putInOrder(edits);
    // LIMIT: a new element that is not the last of its kind is not the one that is marked.
    Q_EMIT created(marked, recipe.handles);
    document_.setText(text::applied(document_.text(), edits), recipe.label);
    if (isOutOfSight) // a place that was typed
        connect(&document_, &SceneDocument::sceneChanged, &display_, &SceneDisplay::frameNow,
                Qt::SingleShotConnection);
}

// The edit of the text that changes bodies which are there already.
editing::Answer Creating::answerTo(const std::vector<editing::Wish>& wishes) const {
    return wishes.empty()
               ? editing::Answer()
               : editing::Mapper(document_.text(), document_.shown().scene).answer(wishes);
}

bool Creating::forgetMeasured() {
    const bool was = measured_.has_value();
    measured_.reset();
    if (was)
        Q_EMIT changed();
    return was;
}

// A place that was clicked on is what one sees; of one that was typed, all that is made there.
bool Creating::isInSight(const Recipe& recipe) const {
    const Indicated& shown = shown_.front();
    const gestures::Sight sight = display_.sight();
    const auto isSeen = [&](const Vector& point) {
        return display_.rect().contains(display_.fromPixels(sight.pixels(point)).toPoint());
    };
    return isSeen(shown.point) &&
           (!shown.isTyped ||
            std::ranges::all_of(gestures::wireframeOf(recipe.ghost), [&](const auto& line) {
                return std::ranges::all_of(line, [&](const Vector& point) {
                    return isSeen(shown.point + shown.attitude * point);
                });
            }));
}

QString Creating::prompt() const {
    if (waiting_)
        return fault_ + (fault_.isEmpty() ? "" : " ") +
               tr("A moment: the text is being read. Keys that are typed now count then.");
    if (!recipe_ || recipe_->steps.empty())
        return {};
    QString text = tr("%1: %2").arg(recipe_->label, step().prompt);
    if (!step().otherwise.isEmpty())
        text += " " + step().otherwise;
    if (!typed_.isEmpty())
        text = tr("%1: x y z = %2_  Return takes it.").arg(recipe_->label, typed_);
    return fault_.isEmpty() ? text : fault_ + " " + text;
}

} // namespace views
