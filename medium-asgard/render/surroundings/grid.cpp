#include "surroundings/grid.h"

#include "drawing/round_numbers.h"
#include "drawing/stroke_text.h"
#include "surroundings/triad.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

constexpr double aimed = 90; // pixels of a step, at least

double smooth(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

// The point of the ground in the line of sight through the middle of the picture, or through a
// place nearer to its edge.
std::optional<Vector> groundInSight(const GroundPlane& ground, const Frame& frame) {
    const Camera& camera = frame.camera();
    const Size size = frame.size();
    constexpr double level = 0.05; // radians: nearly along the ground
    const Vector upInView = frame.directionInView(ground.up);
    const double height =
        toWorld(camera, size, {0.5 * size.width, 0.5 * size.height}, camera.position.z())
            .dot(ground.up) -
        ground.height;
    Eigen::Vector2d towards(-upInView.x(), upInView.y()); // pixels, origin top left
    if (towards.norm() > 1e-9)
        towards *= (height > 0 ? 1.0 : -1.0) / towards.norm();
    for (const double share : {0.0, 0.45, 0.9}) {
        const Eigen::Vector2d pixels = Eigen::Vector2d(0.5 * size.width, 0.5 * size.height) +
                                       share * std::min(size.width, size.height) / 2 * towards;
        const Vector from = toWorld(camera, size, pixels, camera.position.z());
        const Vector way = (toWorld(camera, size, pixels, camera.position.z() - 1) - from);
        const double falls = -way.dot(ground.up) / way.norm();
        if (falls * (from.dot(ground.up) - ground.height) > 0 && std::abs(falls) > level)
            return from + way * ((from.dot(ground.up) - ground.height) / -way.dot(ground.up));
    }
    return std::nullopt;
}

Eigen::Vector3f inkBeside(const Display& display) {
    if (isDark(display.background))
        return {0.62F, 0.66F, 0.72F};
    return display.studio ? Eigen::Vector3f(0.46F, 0.50F, 0.56F)
                          : Eigen::Vector3f(0.58F, 0.61F, 0.66F);
}

Eigen::Vector3f inkOf(const Display& display, const GridLook& look) {
    if (!look.floor)
        return inkBeside(display);
    const Eigen::Vector3f &floor = *look.floor, darker = 0.2F * floor;
    const Eigen::Vector3f lighter = darker + Eigen::Vector3f::Constant(0.8F);
    if (!look.isBesideFloor)
        return isDark({floor.x(), floor.y(), floor.z()}) ? lighter : darker;
    // The one that is seen best where it is seen least, on the floor or beside it.
    const scene::Color& background = display.background;
    const Eigen::Vector3f around(static_cast<float>(background.red),
                                 static_cast<float>(background.green),
                                 static_cast<float>(background.blue));
    const auto leastContrast = [&](const Eigen::Vector3f& ink) {
        return std::min(std::abs(ink.mean() - floor.mean()), std::abs(ink.mean() - around.mean()));
    };
    return std::max({darker, lighter, inkBeside(display)},
                    [&](const Eigen::Vector3f& a, const Eigen::Vector3f& b) {
                        return leastContrast(a) < leastContrast(b);
                    });
}

// One grid on its way into the picture.
class Sheet {
public:
    Sheet(Lines& lines, const GroundPlane& ground, const Extent& extent, const Frame& frame,
          const Display& display, double strength, const Eigen::Vector3f& ink, TakenRoom& taken);

    void draw();

private:
    struct Look {
        Eigen::Vector3f color;
        double alpha = 1;
        double width = 0.9;
    };

    void lineUp(int direction, double step, std::int64_t index, const Look& look);
    void ruled(double step, double radius, int skipped, const Look& look);
    void axes();
    void numbers(double step);
    void row(int direction, double step, double beside);
    // It is there for this text, and for no other one then.
    [[nodiscard]] bool takeRoom(const Eigen::Vector2d& pixels, const Eigen::Vector2d& aside,
                                double width, double height);
    [[nodiscard]] Vector at(int direction, double along, double beside) const {
        return frame_.toView(direction == 0 ? ground_.place(along, beside)
                                            : ground_.place(beside, along));
    }
    // How much of a line is seen at a point of it; `step`: the distance of its neighbours.
    [[nodiscard]] double seen(int direction, double along, double beside, double step) const;
    [[nodiscard]] double focus(int direction) const {
        return focus_[ground_.across[static_cast<std::size_t>(direction)]];
    }
    [[nodiscard]] Eigen::Vector2d pixels(int direction, double along, double beside) const {
        return toPixels(frame_.camera(), frame_.size(),
                        direction == 0 ? ground_.place(along, beside)
                                       : ground_.place(beside, along));
    }

    Lines& lines_;
    const GroundPlane& ground_;
    const Frame& frame_;
    const Display& display_;
    Vector focus_;  // world: what lies in the middle of the grid
    Vector middle_; // world: what lies in the middle of the picture
    double radius_; // world: where it has faded
    double pixelsPerLength_;
    double strength_;
    Eigen::Vector3f ink_;
    TakenRoom& taken_;
};

Sheet::Sheet(Lines& lines, const GroundPlane& ground, const Extent& extent, const Frame& frame,
             const Display& display, double strength, const Eigen::Vector3f& ink, TakenRoom& taken)
    : lines_(lines), ground_(ground), frame_(frame), display_(display), strength_(strength),
      ink_(ink), taken_(taken) {
    const Camera& camera = frame.camera();
    const double depth = camera.position.z();
    pixelsPerLength_ = frame.pixels(camera.scale, depth);
    if (display.studio) {
        const Size size = frame.size();
        const double diagonal = std::hypot(size.width, size.height) / 2;
        const auto above = [&] { return std::abs(focus_.dot(ground.up) - ground.height); };
        focus_ = toWorld(camera, size, {0.5 * size.width, 0.5 * size.height}, depth);
        // The ground may be far from what one looks at: then it is seen where it is.
        const double away = smooth(0.5, 1.5, above() * pixelsPerLength_ / diagonal);
        if (const auto seen = away > 0 ? groundInSight(ground, frame) : std::nullopt) {
            focus_ += away * (*seen - focus_);
            pixelsPerLength_ = frame.pixels(camera.scale, frame.toView(focus_).z());
        }
        radius_ = 4.5 * diagonal / pixelsPerLength_ + 1.5 * above();
        middle_ = focus_;
    } else {
        const Size size = frame.size();
        middle_ =
            groundInSight(ground, frame)
                .value_or(toWorld(camera, size, {0.5 * size.width, 0.5 * size.height}, depth));
        focus_ = extent.box.center();
        const double across =
            std::max(extent.box.sizes()[ground.across[0]], extent.box.sizes()[ground.across[1]]);
        radius_ =
            std::clamp(0.85 * across + 0.6 * extent.size, 0.8 * extent.size, 2.8 * extent.size);
    }
}

double Sheet::seen(int direction, double along, double beside, double step) const {
    const double from = std::hypot(along - focus(direction), beside - focus(1 - direction));
    const double near = std::max(0.0, 1 - (from * from) / (radius_ * radius_));
    const double apart =
        (pixels(direction, along, beside + step) - pixels(direction, along, beside)).norm() /
        frame_.stroke(1);
    return near * near * smooth(2.5, 11, apart);
}

// Parallel to a direction, in pieces that are shorter near the focus.
void Sheet::lineUp(int direction, double step, std::int64_t index, const Look& look) {
    constexpr std::array pieces{-1.0, -0.72, -0.5, -0.34, -0.2, -0.1, 0.0,
                                0.1,  0.2,   0.34, 0.5,   0.72, 1.0};
    const double beside = step * static_cast<double>(index), away = beside - focus(1 - direction);
    if (std::abs(away) >= radius_)
        return;
    const double half = std::sqrt(radius_ * radius_ - away * away);
    Ink ink{look.color, 0, frame_.stroke(look.width)};
    double last = focus(direction) - half, lastAlpha = 0;
    for (const double piece : pieces) {
        const double along = focus(direction) + piece * half;
        const double alpha = look.alpha * strength_ * seen(direction, along, beside, step);
        if (alpha > 0.004 || lastAlpha > 0.004) {
            ink.alpha = static_cast<float>(lastAlpha);
            lines_.add(at(direction, last, beside), at(direction, along, beside), ink,
                       static_cast<float>(alpha));
        }
        last = along;
        lastAlpha = alpha;
    }
}

// All lines of that step within the radius but each `skipped`th, which a coarser grid has.
void Sheet::ruled(double step, double radius, int skipped, const Look& look) {
    for (int direction = 0; direction < 2; ++direction) {
        const auto across = ground_.across[static_cast<std::size_t>(1 - direction)];
        const GridRows rows = gridRows(step, focus_[across], radius, middle_[across]);
        for (std::int64_t index = rows.first; index <= rows.last; ++index)
            if ((skipped == 0 || index % skipped != 0) && (index != 0 || !display_.studio))
                lineUp(direction, step, index, look);
    }
}

void Sheet::axes() {
    const double step = roundAbove(aimed * frame_.stroke(1) / pixelsPerLength_);
    for (int direction = 0; direction < 2; ++direction)
        lineUp(direction, step, 0,
               {axisColor(ground_.across[static_cast<std::size_t>(direction)]), 0.8, 1.3});
}

bool Sheet::takeRoom(const Eigen::Vector2d& pixels, const Eigen::Vector2d& aside, double width,
                     double height) {
    const Eigen::Vector2d middle = pixels + Eigen::Vector2d(aside.x() - 0.5 * width, -aside.y());
    const Eigen::Vector2d half(0.5 * width + 0.35 * height, 0.7 * height);
    const Eigen::AlignedBox2d room(middle - half, middle + half);
    return render::takeRoom(taken_, room, frame_.size());
}

// Numbers along one axis, on the other or, where that is out of sight, on a line near the middle.
void Sheet::row(int direction, double step, double beside) {
    const double height = frame_.stroke(8);
    const std::int64_t middle = std::llround(focus(direction) / step);
    const int reach = static_cast<int>(std::min(24.0, 0.7 * radius_ / step));
    for (int k = 0; k <= 2 * reach; ++k) { // from the middle outwards, either way
        const std::int64_t index = middle + (k % 2 == 0 ? k / 2 : -(k + 1) / 2);
        if (index == 0 && direction == 1 && beside == 0)
            continue; // the other row has it
        const double value = static_cast<double>(index) * step;
        const std::string text = coordinateText(value, step);
        const double apart =
            (pixels(direction, value + step, beside) - pixels(direction, value, beside)).norm();
        const double needed = textWidth(text, height) + height;
        const double alpha = 0.95 * strength_ *
                             std::min(1.0, 2 * seen(direction, value, beside, step)) *
                             smooth(0.6 * needed, needed, apart);
        if (alpha < 0.05)
            continue;
        const Eigen::Vector2d aside(-0.4 * height, -1.05 * height);
        if (!takeRoom(pixels(direction, value, beside), aside, textWidth(text, height), height))
            continue;
        const double bottom = aside.y() - 0.7 * height;
        const std::array corners{Eigen::Vector2d(aside.x(), bottom),
                                 Eigen::Vector2d(aside.x() - textWidth(text, height), bottom)};
        addText(lines_, frame_,
                beforeGround(ground_, frame_, at(direction, value, beside), corners), aside, text,
                height, Anchor::right, {ink_, static_cast<float>(alpha), frame_.stroke(1)});
    }
}

void Sheet::numbers(double step) {
    for (int direction = 0; direction < 2; ++direction) {
        const double away = focus(1 - direction);
        const double beside = std::abs(away) < 0.25 * radius_ ? 0 : step * std::round(away / step);
        row(direction, step, beside);
    }
}

void Sheet::draw() {
    const std::vector<GridStep> steps = gridSteps(pixelsPerLength_, frame_.stroke(1));
    const GridStep* main = &steps.front();
    for (const GridStep& one : steps) {
        const int parts = std::lround(one.step / powerBelow(one.step)) == 2 ? 4 : 5;
        const double fine = one.step / parts;
        ruled(fine, std::min(radius_, 70 * fine), parts, {ink_, 0.30 * one.weight, 0.8});
        ruled(one.step, radius_, 0, {ink_, 0.62 * one.weight, 0.95});
        if (one.weight > main->weight)
            main = &one;
    }
    if (!display_.studio)
        return;
    axes();
    numbers(main->step);
}

} // namespace

bool takeRoom(TakenRoom& taken, const Eigen::AlignedBox2d& room, Size picture) {
    const Eigen::AlignedBox2d all(Eigen::Vector2d(0, 0),
                                  Eigen::Vector2d(picture.width, picture.height));
    if (!all.contains(room) ||
        std::ranges::any_of(taken, [&](const auto& one) { return one.intersects(room); }))
        return false;
    taken.push_back(room);
    return true;
}

Vector beforeGround(const GroundPlane& ground, const Frame& frame, const Vector& place,
                    std::span<const Eigen::Vector2d> corners) {
    const Camera& camera = frame.camera();
    const Size size = frame.size();
    const Vector up = frame.directionInView(ground.up), eye = frame.eye();
    const Vector fromEye = place - eye;
    const Eigen::Vector2d pixels = toPixels(
        camera, size, frame.linear().inverse() * (place - camera.position) + camera.center);
    double share = 1; // of the way from the eye
    for (const Eigen::Vector2d& corner : corners) {
        const Eigen::Vector2d there = pixels + Eigen::Vector2d(corner.x(), -corner.y());
        const Vector way = frame.toView(toWorld(camera, size, there)) - eye;
        const double along = up.dot(fromEye) / up.dot(way); // to the ground
        if (along > 0 && std::isfinite(along))
            share = std::min(share, along * way.z() / fromEye.z());
    }
    constexpr double clearly = 1e-3, nearest = 0.1; // view units; of the way
    return share < 1 ? Vector(eye + std::max(nearest, share - clearly / fromEye.norm()) * fromEye)
                     : place;
}

GroundPlane groundPlane(const Vector& up, double height) {
    Eigen::Index axis = 0;
    up.cwiseAbs().maxCoeff(&axis);
    GroundPlane ground{up, height, {0, 2}};
    ground.across = axis == 0 ? std::array{1, 2} : axis == 1 ? std::array{0, 2} : std::array{0, 1};
    return ground;
}

std::vector<GridStep> gridSteps(double pixelsPerLength, double stroke) {
    const double wanted = aimed * stroke / pixelsPerLength;
    const double step = roundAbove(wanted);
    const double old = smooth(1.0, 1.15, step / wanted); // of the step that is about to go
    std::vector<GridStep> steps{{step, old}};
    if (old < 1)
        steps.push_back({roundAbove(1.01 * step), 1 - old});
    return steps;
}

GridRows gridRows(double step, double focus, double radius, double middle) {
    constexpr double most = 400;       // to either side
    constexpr double countable = 1e15; // beyond it neighbours are the same number
    const double first = std::ceil(std::max((focus - radius) / step, middle / step - most));
    const double last = std::floor(std::min((focus + radius) / step, middle / step + most));
    if (!(first <= last) || !(std::max(std::abs(first), std::abs(last)) < countable))
        return {};
    return {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
}

void addGrid(Lines& lines, const GroundPlane& ground, const Extent& extent, const Frame& frame,
             const Display& display, const GridLook& look, TakenRoom& taken) {
    // Seen edge-on it is a line: it fades before that.
    constexpr double fromBelow = 0.4;
    const Vector up = frame.directionInView(ground.up);
    const double offset = frame.toView(ground.place(0, 0)).dot(up);
    const double rise =
        frame.camera().orthographic ? up.z() : (eyeDistance * up.z() - offset) / eyeDistance;
    const double slant = smooth(0.01, 0.12, std::abs(rise));
    const double strength = look.strength * (look.floor ? 0.7 : 1) * (rise < 0 ? fromBelow : 1);
    if (slant * strength > 0)
        Sheet(lines, ground, extent, frame, display, strength * slant, inkOf(display, look), taken)
            .draw();
}

std::optional<double> commonDepth(const scene::Scene& scene, Eigen::Index axis) {
    std::optional<double> common;
    for (const scene::Body& body : scene.bodies) {
        const double one = body.initialPosition[axis];
        if (common && std::abs(*common - one) > 1e-6 * (1 + std::abs(one)))
            return std::nullopt;
        common = one;
    }
    return common.value_or(0);
}

std::optional<FacingPlane> facingPlane(const Drawing& drawing, const Vector& up) {
    constexpr double along = 0.01, aside = 0.05; // radians off the axis
    const Vector toViewer = drawing.camera.rotation.conjugate() * Vector::UnitZ();
    Eigen::Index axis = 0;
    toViewer.cwiseAbs().maxCoeff(&axis);
    const double sine = toViewer.cross(Vector::Unit(axis)).norm();
    const double weight = 1 - smooth(along, aside, sine);
    if (weight <= 0 || std::abs(up[axis]) > 0.5)
        return std::nullopt;
    const double sign = toViewer[axis] > 0 ? 1 : -1;
    const double depth = commonDepth(*drawing.scene, axis).value_or(drawing.camera.center[axis]);
    return FacingPlane{groundPlane(sign * Vector::Unit(axis), sign * depth), weight};
}

} // namespace render
