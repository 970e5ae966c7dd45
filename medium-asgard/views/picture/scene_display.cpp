#include "picture/scene_display.h"

#include "framing/extent.h"
#include "framing/framing.h"
#include "surroundings/triad.h"

#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace views {

SceneDisplay::SceneDisplay(SceneDocument& document, std::shared_ptr<PictureThread> pictures,
                           QWidget* parent)
    : QWidget(parent), document_(document),
      picture_(
          *this, std::move(pictures), [this] { return wish(); },
          [this](const Picture& picture) { return isWanted(picture); }),
      editing_(document, *this), creating_(document, *this), pointing_(document, *this),
      selecting_(document, *this), throwing_(document, *this), gizmo_(document, *this),
      faultSigns_(document, *this), meters_(document, *this) {
    display_.studio = display_.triad = true;
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMouseTracking(true);
    setAccessibleName(tr("Scene"));
    setAccessibleDescription(tr("Picture of the scene. Click to select. Drag with the left button "
                                "to turn it, the middle one to move it, the right one to scale or "
                                "roll it."));
    connect(&picture_, &WindowPicture::taken, this, &SceneDisplay::taken);
    connect(&picture_, &WindowPicture::came, this, &SceneDisplay::pictured);
    connect(&document_, &SceneDocument::elementsRenamed, this, &SceneDisplay::rename);
    connect(&document_, &SceneDocument::opened, this, [this] { seen_.isAnother = true; });
    connect(&document_, &SceneDocument::sceneChanged, this, &SceneDisplay::sceneChanged);
    connect(&document_, &SceneDocument::motionChanged, this, &SceneDisplay::motionChanged);
    connect(&document_, &SceneDocument::workChanged, this, [this] { update(); });
    connect(&creating_, &Creating::changed, this, [this] { update(); });
    connect(&creating_, &Creating::refused, &editing_,
            [this](const QString& why) { editing_.say(why); });
    connect(&creating_, &Creating::told, &editing_,
            [this](const QString& answer) { editing_.say(answer, false); });
    connect(&editing_, &PictureEditing::changed, this, [this] {
        Q_EMIT handleDragged();
        update();
    });
    connect(&pointing_, &Pointing::changed, this, [this] { update(); });
    connect(&meters_, &Meters::changed, this, [this] { update(); });
    connect(&throwing_, &Throwing::changed, this, [this] {
        update();
        Q_EMIT handleDragged(); // the line below the picture says what it does
    });
    connect(this, &SceneDisplay::cameraChanged, &pointing_, &Pointing::follow);
    sceneChanged();
}

QPointF SceneDisplay::placeOf(double x, double y, double z) const {
    return fromPixels(sight().pixels({x, y, z}));
}

PictureWish SceneDisplay::wish() const {
    PictureWish wish;
    wish.shown = document_.shown();
    wish.time = time_;
    wish.display = display_;
    wish.display.rotationCenter = press_.turns;
    wish.camera = control_.camera();
    wish.view = seen_.followed.toStdString();
    wish.framing = seen_.framing;
    wish.keepsDirection = seen_.keepsDirection;
    wish.keepsExtent = seen_.isEdited;
    wish.scaling = seen_.scaling;
    wish.from = !seen_.followed.isEmpty()                                ? SeenFrom::view
                : seen_.framesItself && (seen_.isDue || !seen_.isEdited) ? SeenFrom::framed
                : seen_.turned                                           ? SeenFrom::turned
                                                                         : SeenFrom::camera;
    wish.keepsGround = seen_.keepsGround;
    return wish;
}

bool SceneDisplay::isFollowed(const Picture& picture) const {
    const PictureWish& of = picture.of;
    return (of.from == SeenFrom::view && of.view == seen_.followed.toStdString()) ||
           (of.from == SeenFrom::framed && seen_.followed.isEmpty() && seen_.framesItself) ||
           (of.from == SeenFrom::turned && seen_.turned);
}

// Another one is on its way instead, and what is pointed at stays where it is seen.
bool SceneDisplay::isWanted(const Picture& picture) const {
    const SeenFrom from = picture.of.from;
    return (from != SeenFrom::framed && from != SeenFrom::turned) || isFollowed(picture);
}

void SceneDisplay::taken() {
    const Picture& picture = *picture_.last();
    const bool isOfThis = showsScene(), follows = isFollowed(picture);
    if (isOfThis)
        seen_.isPlaced = !picture.of.shown.scene->bodies.empty();
    if (!follows)
        return;
    if (picture_.isOfLastWish())
        seen_.turned = seen_.isDue = false;
    if (isOfThis && std::exchange(seen_.isToStay, false))
        stayHere();
    control_.set(picture.camera);
    seen_.framed = {picture.camera, picture.of.size};
    Q_EMIT cameraChanged();
}

// Another picture is wanted instead of one that frames the scene and is on its way.
void SceneDisplay::stayHere() {
    seen_.framesItself = seen_.turned = false;
    if (!showsNewest())
        redraw(false);
}

void SceneDisplay::setTime(double time, bool moving) {
    if (time == time_)
        return;
    time_ = time;
    pointing_.follow(); // a force's arrow moves
    redraw(moving);
}

void SceneDisplay::setDisplay(const render::Display& display) {
    auto hidden = display_.hidden;
    const auto opened = display_.opened;
    display_ = display;
    display_.hidden = std::move(hidden);
    display_.opened = opened;
    redraw(false);
}

void SceneDisplay::openCrowd(const std::optional<render::HandleName>& largest) {
    if (largest == display_.opened)
        return;
    display_.opened = largest;
    redraw(false);
}

void SceneDisplay::setHidden(std::set<std::string> names) {
    if (names == hidden())
        return;
    display_.hidden = std::make_shared<const std::set<std::string>>(std::move(names));
    redraw(false);
    Q_EMIT hiddenChanged();
}

const std::set<std::string>& SceneDisplay::hidden() const {
    static const std::set<std::string> none;
    return display_.hidden ? *display_.hidden : none;
}

void SceneDisplay::hide(const std::vector<editing::Element>& elements) {
    std::set<std::string> names = hidden();
    for (const editing::Element& element : elements)
        if (element.kind == editing::Kind::body)
            names.insert(editing::nameOf(*document_.shown().scene, element));
    setHidden(std::move(names));
    // What nobody sees is not what the next Delete means.
    std::vector<editing::Element> selected = document_.selected();
    std::erase_if(selected, [&](const editing::Element& one) {
        return one.kind == editing::Kind::body &&
               std::ranges::find(elements, one) != elements.end();
    });
    document_.select(std::move(selected));
}

void SceneDisplay::rename(const std::vector<editing::Renamed>& renamed) {
    std::set<std::string> names = hidden();
    for (const editing::Renamed& one : renamed)
        if (one.element.kind == editing::Kind::body && names.erase(one.before) > 0)
            names.insert(one.now);
    setHidden(std::move(names));
}

void SceneDisplay::sceneChanged() {
    const auto& views = document_.shown().scene->views;
    const bool known = std::any_of(views.begin(), views.end(), [&](const auto& v) {
        return QString::fromStdString(v.name) == seen_.followed;
    });
    // A scene with views opens in its first one.
    if (seen_.framesItself && !known && !views.empty())
        followView(QString::fromStdString(views.front().name));
    else if (!seen_.followed.isEmpty() && !known)
        followView({});
    const bool isAnother = std::exchange(seen_.isAnother, false);
    if (isAnother) {
        seen_.isPlaced = false;
        ++seen_.scaling;
    }
    seen_.isEdited = seen_.isPlaced;
    seen_.keepsGround = seen_.isEdited || (!isAnother && !seen_.framesItself);
    if (seen_.framed) // it is edited as it is seen now
        keepFrame();
    if (seen_.isEdited && seen_.framesItself)
        keepInSight();
    else if (seen_.isEdited && seen_.followed.isEmpty() && !editing_.dragging())
        stepBack();
    motionChanged();
}

namespace {

// The outline of the body, at its place at that time.
std::vector<render::Ball> ballsOf(const scene::Scene& scene, const simulation::Motion* motion,
                                  std::size_t body, double time) {
    const geometry::Pose pose = render::poseOf(scene, motion, body, time);
    std::vector<render::Ball> balls = render::outlineOf(scene, scene.bodies[body]);
    for (render::Ball& ball : balls)
        ball.center = pose.toWorld(ball.center);
    return balls;
}

} // namespace

void SceneDisplay::stepBack() {
    if (!picture_.last())
        return;
    const scene::Scene &before = *picture_.last()->of.shown.scene, &now = *document_.shown().scene;
    const auto reachOf = [](const scene::Scene& scene, const scene::Body& body) {
        double reach = 0;
        for (const render::Ball& ball : render::outlineOf(scene, body))
            reach = std::max(reach, ball.center.norm() + ball.radius);
        return reach;
    };
    const auto ballsIn = [&](const scene::Scene& scene, std::size_t body) {
        return ballsOf(scene, document_.shown().motion.get(), body, time_);
    };
    const gestures::Sight sight = SceneDisplay::sight();
    const auto isSeen = [&](const render::Ball& ball) {
        return render::isWithin(sight.camera, sight.size, ball);
    };
    std::vector<render::Ball> grown;
    for (std::size_t i = 0; i < std::min(before.bodies.size(), now.bodies.size()); ++i)
        if (before.bodies[i].name == now.bodies[i].name &&
            reachOf(now, now.bodies[i]) > 1.01 * reachOf(before, before.bodies[i]) &&
            std::ranges::all_of(ballsIn(before, i), isSeen))
            std::ranges::copy(ballsIn(now, i), std::back_inserter(grown));
    stepBackTo(render::steppedBack(sight.camera, sight.size, grown));
}

void SceneDisplay::stepBackTo(const render::Camera& camera) {
    if (camera == control_.camera())
        return;
    control_.set(camera);
    if (seen_.framed)
        keepFrame();
    Q_EMIT cameraChanged();
    redraw(true);
}

void SceneDisplay::showWhole(const std::vector<editing::Element>& elements) {
    const bool isFramedAnyway = seen_.framesItself && (seen_.isDue || !seen_.isEdited);
    if (!isFramedAnyway && seen_.followed.isEmpty())
        stepBackFor(elements);
}

void SceneDisplay::bringIn(const std::vector<editing::Element>& elements) {
    bringUpToDate();
    keepCamera();
    followView({});
    stepBackFor(elements);
}

void SceneDisplay::stepBackFor(const std::vector<editing::Element>& elements) {
    const Shown& shown = document_.shown();
    std::vector<render::Ball> balls;
    for (const editing::Element& one : elements)
        if (one.kind == editing::Kind::body && one.index < shown.scene->bodies.size())
            std::ranges::copy(ballsOf(*shown.scene, shown.motion.get(), one.index, time_),
                              std::back_inserter(balls));
    const gestures::Sight sight = SceneDisplay::sight();
    if (std::ranges::all_of(balls, [&](const render::Ball& ball) {
            return render::isWithin(sight.camera, sight.size, ball);
        }))
        return;
    constexpr double margin = 12; // pixels: they do not touch the edge then
    for (render::Ball& ball : balls)
        ball.radius += margin * sight.pixelLength(ball.center);
    const render::Camera back = render::steppedBack(sight.camera, sight.size, balls);
    constexpr double far = 0.5; // of the scale: the others would become too small
    if (back.scale < far * sight.camera.scale)
        frameNow();
    else
        stepBackTo(back);
}

void SceneDisplay::keepInSight() {
    const render::Extent extent = render::extentOf(*document_.shown().scene, nullptr);
    const gestures::Sight now = SceneDisplay::sight();
    if (std::ranges::all_of(extent.balls, [&](const render::Ball& ball) {
            return render::isWithin(now.camera, now.size, ball);
        }))
        return;
    const render::Camera& camera = control_.camera();
    control_.set(render::fitted(extent, camera.rotation, now.size, camera.orthographic));
    keepFrame();
    Q_EMIT cameraChanged();
}

// While a handle is dragged pictures are many: each is coarse, and the last one fine.
void SceneDisplay::motionChanged() { redraw(picture_.isMoving() || editing_.dragging()); }

void SceneDisplay::movedByUser() {
    seen_.framesItself = seen_.turned = seen_.isWhole = seen_.isToStay = false;
    seen_.framed.reset();
    if (!seen_.followed.isEmpty())
        followView({});
    Q_EMIT cameraChanged();
    redraw(true);
}

void SceneDisplay::keepFrame() { seen_.framed = {control_.camera(), pixelSize()}; }

// A pane that opens beside the picture hides nothing that was framed.
void SceneDisplay::resizeEvent(QResizeEvent*) {
    const bool isFramedAnew = seen_.framesItself && (seen_.isDue || !seen_.isEdited);
    if (!seen_.framed || isFramedAnew || seen_.turned || !seen_.followed.isEmpty())
        return;
    const auto& [camera, size] = *seen_.framed;
    // OPTIMIZATION: a crowd counts where it starts: its motion takes longer than one wants to wait.
    constexpr std::size_t crowd = 100;
    const Shown& shown = document_.shown();
    const bool isCrowd = shown.scene->bodies.size() > crowd;
    const render::Extent extent =
        render::extentOf(*shown.scene, isCrowd ? nullptr : shown.motion.get());
    const render::Camera kept = render::keeping(camera, size, pixelSize(), extent.balls);
    if (kept == control_.camera())
        return;
    control_.set(kept);
    Q_EMIT cameraChanged();
    redraw(false);
}

void SceneDisplay::setCamera(const render::Camera& camera) {
    control_.set(camera);
    movedByUser();
}

void SceneDisplay::frameOpened() {
    frameAll();
    seen_.keepsDirection = false;
}

void SceneDisplay::frameAll() {
    followView({});
    seen_.keepsDirection = seen_.isPlaced || !seen_.framesItself;
    ++seen_.scaling;
    seen_.framesItself = seen_.isDue = true;
    seen_.isToStay = false;
    seen_.framing = display_; // switching handles on later moves nothing
    redraw(false);
}

void SceneDisplay::setOrthographic(bool orthographic) {
    bringUpToDate();
    render::Camera camera = control_.camera();
    camera.orthographic = orthographic;
    control_.set(camera); // what it frames by itself it frames anew
    if (seen_.framed)
        keepFrame();
    Q_EMIT cameraChanged();
    redraw(false);
}

void SceneDisplay::frame(const render::Extent& extent) {
    ++seen_.scaling;
    const render::Camera& camera = control_.camera();
    setCamera(render::fitted(extent, camera.rotation, pixelSize(), camera.orthographic));
    keepFrame();
    redraw(false);
}

void SceneDisplay::frameNow() {
    bringUpToDate();
    const Shown& shown = document_.shown();
    frame(render::extentAt(*shown.scene, shown.motion.get(), time_));
}

void SceneDisplay::frameSelected() {
    bringUpToDate();
    const Shown& shown = document_.shown();
    std::vector<std::size_t> bodies;
    for (const editing::Element& element : document_.selected())
        if (element.kind == editing::Kind::body)
            bodies.push_back(element.index);
    frame(render::extentAt(*shown.scene, shown.motion.get(), time_, bodies));
}

void SceneDisplay::frameMotion() {
    bringUpToDate();
    const Shown& shown = document_.shown();
    frame(render::extentOfAll(*shown.scene, shown.motion.get()));
}

QString SceneDisplay::triadEndAt(const QPointF& position) const {
    if (!display_.triad)
        return {};
    const auto end = render::triadDirectionAt(control_.camera(), pixelSize(), inPixels(position));
    if (!end)
        return {};
    Eigen::Index axis = 0;
    end->cwiseAbs().maxCoeff(&axis);
    const QChar name = QLatin1Char("xyz"[axis]);
    return (*end)[axis] > 0 ? QString(name) : tr("against %1").arg(name);
}

void SceneDisplay::lookAlong(const geometry::Vector& toward) {
    bringUpToDate();
    const geometry::Vector up = render::upOf(*document_.shown().scene);
    // Down on the ground, or up at it: what was in front is at the bottom.
    const double along = toward.dot(up);
    geometry::Vector upright = up;
    if (std::abs(along) > 0.99)
        upright =
            std::abs(up.z()) < 0.5 ? geometry::Vector(0, 0, -along) : geometry::Vector(0, along, 0);
    render::Camera camera = control_.camera();
    camera.rotation = render::facing(toward, upright);
    // Of a scene that is empty there is nothing to frame, and the first body stays as it was put.
    const bool isEmpty = document_.sceneIsCurrent() && document_.shown().scene->bodies.empty();
    turnTo(camera, !isEmpty);
}

void SceneDisplay::turnTo(const render::Camera& camera, bool mayFrame) {
    const bool isFramed = mayFrame && (seen_.framesItself || seen_.isWhole);
    setCamera(camera);
    seen_.turned = seen_.isWhole = isFramed;
    redraw(false);
}

void SceneDisplay::levelHorizon() {
    bringUpToDate();
    render::Camera camera = control_.camera();
    const geometry::Vector up = render::upOf(*document_.shown().scene);
    const geometry::Vector toward = camera.rotation.conjugate() * geometry::Vector::UnitZ();
    if (std::abs(toward.dot(up)) > 0.999)
        return editing_.say(tr("Straight from above, or from below, no horizon is seen."));
    const geometry::Quaternion level = render::facing(toward, up);
    camera.position = level * (camera.rotation.conjugate() * camera.position);
    camera.rotation = level;
    turnTo(camera, true);
}

void SceneDisplay::followView(const QString& name) {
    if (name != seen_.followed) {
        seen_.followed = name;
        seen_.last = name.isEmpty() ? seen_.last : name;
        Q_EMIT viewFollowed();
    }
    redraw(false);
}

render::Drawing SceneDisplay::drawing() const {
    return {document_.shown().scene.get(), document_.shown().motion, time_, control_.camera(),
            display_};
}

render::Drawing SceneDisplay::drawn() const {
    render::Drawing drawn = drawing();
    if (showsScene()) {
        drawn.time = picture_.last()->of.time;
        drawn.motion = picture_.last()->of.shown.motion;
    }
    return drawn;
}

std::optional<render::GroundPlane> SceneDisplay::ground() const {
    return display_.grid && showsScene() ? picture_.last()->ground : std::nullopt;
}

const render::HandleSet& SceneDisplay::handles() {
    if (render::showsHandles(display_))
        bringUpToDate();
    return knownHandles();
}

const render::HandleSet& SceneDisplay::knownHandles() const {
    static const render::HandleSet none;
    return render::showsHandles(display_) && showsScene() ? picture_.last()->handles : none;
}

const render::HandleSet& SceneDisplay::drawnHandles() const {
    static const render::HandleSet none;
    return picture_.last() ? picture_.last()->handles : none;
}

double SceneDisplay::arrowLength(bool couple) {
    bringUpToDate();
    if (!picture_.last())
        return 1;
    return couple ? picture_.last()->torqueArrow : picture_.last()->forceArrow;
}

void SceneDisplay::keepCamera() {
    seen_.isWhole = false;
    if (!seen_.framesItself && !seen_.turned)
        return;
    seen_.isToStay = !picture_.last() || (!seen_.isEdited && !showsScene());
    if (seen_.isToStay) // nothing is seen yet, or what is seen is of a scene before
        return;
    stayHere();
}

std::vector<geometry::Vector> SceneDisplay::verticesAndHandles() {
    const Shown& shown = document_.shown();
    std::vector<geometry::Vector> points;
    for (std::size_t i = 0; i < shown.scene->bodies.size(); ++i) {
        const geometry::Pose pose = render::poseOf(*shown.scene, shown.motion.get(), i, time_);
        for (const render::Ball& ball : render::outlineOf(*shown.scene, shown.scene->bodies[i]))
            points.push_back(pose.toWorld(ball.center));
    }
    for (const render::Handle& handle : handles().handles)
        points.push_back(handle.place);
    return points;
}

void SceneDisplay::centerAt(const QPointF& position) {
    const render::Camera& camera = control_.camera();
    const Eigen::Vector2d pixels = inPixels(position);
    double nearest = 8 * devicePixelRatioF();
    double front = -std::numeric_limits<double>::infinity(), back = -front;
    std::optional<geometry::Vector> taken;
    for (const geometry::Vector& point : verticesAndHandles()) {
        const double z =
            (camera.rotation * (point - camera.center)).z() * camera.scale + camera.position.z();
        front = std::max(front, z);
        back = std::min(back, z);
        const double distance = (render::toPixels(camera, pixelSize(), point) - pixels).norm();
        if (distance < nearest) {
            nearest = distance;
            taken = point;
        }
    }
    const double middle = front >= back ? (front + back) / 2 : 0;
    setCamera(render::turningAbout(
        camera, taken ? *taken : render::toWorld(camera, pixelSize(), pixels, middle)));
}

double SceneDisplay::massOf(std::size_t body) const {
    const Shown& shown = document_.shown();
    if (body < shown.scene->bodies.size() && shown.scene->bodies[body].mass)
        return *shown.scene->bodies[body].mass;
    const bool known = shown.motion && body < shown.motion->bodies();
    const double mass = known ? shown.motion->mass(body) : 1;
    return std::isfinite(mass) && mass > 0 ? mass : 1;
}

geometry::Vector SceneDisplay::centroidOf(std::size_t body) const {
    return centroids_.of(document_.shown(), body);
}

geometry::Vector SceneDisplay::centerOf(std::size_t body) const {
    const render::Drawing drawn = this->drawn();
    return render::poseOf(*drawn.scene, drawn.motion.get(), body, drawn.time)
        .toWorld(centroidOf(body));
}

void SceneDisplay::paintEvent(QPaintEvent*) {
    bringUpToDate();
    QPainter painter(this);
    if (!picture_.paint(painter))
        return;
    pointing_.paint(painter);
    meters_.paint(painter);
    gizmo_.paint(painter);
    editing_.paint(painter);
    faultSigns_.paint(painter);
    throwing_.paint(painter);
    creating_.paint(painter);
    selecting_.paint(painter);
}

} // namespace views
