#include "gestures/snapping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace gestures {

namespace {

constexpr double reachOfThings = 8, betweenRound = 20; // pixels of the reader
constexpr std::size_t mostBodies = 300, mostCorners = 64;

// One part of a body: its points of interest in its own frame, and its edges by
// two of those.
struct Features {
    std::vector<std::pair<Vector, const char*>> points;
    std::vector<std::pair<Vector, Vector>> edges;
};

Features featuresOf(const scene::BoxShape& box) {
    Features all;
    const Vector half = box.edges / 2;
    const auto corner = [&](int x, int y, int z) -> Vector {
        return Vector(x, y, z).cwiseProduct(half);
    };
    for (int i = 0; i < 8; ++i) {
        const std::array<int, 3> sign{i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1};
        all.points.emplace_back(corner(sign[0], sign[1], sign[2]), "a corner");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            if (sign[axis] > 0)
                continue;
            std::array<int, 3> other = sign, between = sign;
            other[axis] = 1;
            between[axis] = 0;
            all.edges.emplace_back(corner(sign[0], sign[1], sign[2]),
                                   corner(other[0], other[1], other[2]));
            all.points.emplace_back(corner(between[0], between[1], between[2]),
                                    "the middle of an edge");
        }
    }
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            Vector face = Vector::Zero();
            face[axis] = sign * half[axis];
            all.points.emplace_back(face, "the middle of a face");
        }
    return all;
}

Features featuresOf(const scene::HullShape& hull) {
    Features all;
    for (const Vector& point : hull.points)
        if (all.points.size() < mostCorners)
            all.points.emplace_back(point, "a corner");
    return all;
}

Features endsOf(double height, const char* top, const char* bottom) {
    return {{{Vector(0, height / 2, 0), top}, {Vector(0, -height / 2, 0), bottom}}, {}};
}

Features featuresOf(const scene::CylinderShape& one) {
    return endsOf(one.height, "the middle of an end", "the middle of an end");
}
Features featuresOf(const scene::ConeShape& one) {
    return endsOf(one.height, "the tip", "the middle of the base");
}
Features featuresOf(const scene::CapsuleShape& one) {
    return endsOf(one.height, "the middle of an end", "the middle of an end");
}
Features featuresOf(const scene::TubeShape& one) {
    return endsOf(one.height, "the middle of an end", "the middle of an end");
}
Features featuresOf(const scene::BowlShape& one) {
    return {{{Vector::Zero(), "the middle of the rim"},
             {Vector(0, -one.inner, 0), "the bottom inside"},
             {Vector(0, -one.outer, 0), "the bottom"}},
            {}};
}
Features featuresOf(const scene::SphereShape&) { return {}; }
Features featuresOf(const scene::EllipsoidShape&) { return {}; }
Features featuresOf(const scene::PlaneShape&) { return {}; }

// A body that is dragged, and those that a path leads whose point is.
std::vector<std::string> movedBy(const scene::Scene& scene, const render::Handle& held) {
    if (held.kind == render::HandleKind::position)
        return {scene.bodies[held.element].name};
    std::vector<std::string> bodies;
    if (held.kind == render::HandleKind::trajectoryPoint)
        for (const scene::Constraint& one : scene.constraints)
            if (one.trajectory == scene.trajectories[held.element].name)
                bodies.push_back(one.body);
    return bodies;
}

std::string bodyOfJoint(const scene::Joint& joint, std::size_t part) {
    return part == 0 ? joint.body1 : joint.body2.value_or("");
}

std::string bodyOfLink(const scene::Link& link, std::size_t part) {
    const auto* second = std::get_if<scene::BodyEnd>(&link.second);
    return part == 0 ? link.first.body : second ? second->body : "";
}

} // namespace

double roundStep(double length) {
    if (!(length > 0) || !std::isfinite(length))
        return 0;
    const double power = std::pow(10, std::floor(std::log10(length) + 1e-9));
    for (const double times : {1.0, 2.0, 5.0})
        if (times * power >= length * (1 - 1e-9))
            return times * power;
    return 10 * power;
}

Snapping::Snapping(const render::Drawing& drawing, const Sight& sight, double scale,
                   const render::Handle* held, const std::vector<std::size_t>& company)
    : sight_(sight), reach_(reachOfThings * scale), apart_(betweenRound * scale) {
    for (const scene::Body& body : drawing.scene->bodies)
        bodies_.push_back(body.name);
    if (held) {
        held_ = held->place;
        moving_ = movedBy(*drawing.scene, *held);
    }
    for (const std::size_t body : company)
        moving_.push_back(bodies_[body]);
    for (std::size_t i = 0; i < std::min(mostBodies, bodies_.size()); ++i)
        if (!moves(bodies_[i]) && !render::isHidden(drawing.display, drawing.scene->bodies[i]))
            addBody(drawing, i);
    addHandles(drawing);
}

bool Snapping::moves(const std::string& body) const {
    return std::ranges::find(moving_, body) != moving_.end();
}

void Snapping::add(const Vector& place, std::string name) {
    if (place != held_)
        points_.push_back({place, sight_.pixels(place), std::move(name)});
}

// Of a joint or link, on that body.
void Snapping::addEnd(const Vector& place, const std::string& body, const char* name) {
    if (!moves(body))
        add(place, name);
}

void Snapping::addBody(const render::Drawing& drawing, std::size_t index) {
    const scene::Body& body = drawing.scene->bodies[index];
    const scene::ShapeSet* set = scene::findShapeSet(*drawing.scene, body.shape);
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), index, drawing.time);
    add(pose.position, "the origin of " + body.name);
    if (!set)
        return;
    for (const scene::Part& part : set->parts) {
        const geometry::Pose local{part.position, geometry::fromRotationVector(part.rotation)};
        const auto world = [&](const Vector& v) { return pose.toWorld(local.toWorld(v)); };
        const Features all =
            std::visit([](const auto& shape) { return featuresOf(shape); }, part.shape);
        if (part.position != Vector::Zero())
            add(world(Vector::Zero()), "the middle of a part of " + body.name);
        for (const auto& [place, what] : all.points)
            add(world(place), what + (" of " + body.name));
        for (const auto& [from, to] : all.edges)
            edges_.push_back({world(from), world(to), index});
    }
}

void Snapping::addHandles(const render::Drawing& drawing) {
    const scene::Scene& scene = *drawing.scene;
    if (scene.joints.empty() && scene.links.empty() && scene.trajectories.empty())
        return;
    render::Display display;
    display.jointHandles = display.linkHandles = display.trajectories = true;
    render::Handles handles(scene, drawing.motion);
    for (const render::Handle& one : handles.at(drawing.time, display).handles)
        if (one.kind == render::HandleKind::jointPoint)
            addEnd(one.place, bodyOfJoint(scene.joints[one.element], one.part), "a joint");
        else if (one.kind == render::HandleKind::linkEnd)
            addEnd(one.place, bodyOfLink(scene.links[one.element], one.part), "the end of a link");
        else if (one.kind == render::HandleKind::trajectoryPoint && !one.isValue())
            add(one.place, "a point of " + scene.trajectories[one.element].name);
}

double Snapping::step(const Vector& place) const {
    return roundStep(apart_ * sight_.pixelLength(place));
}

bool Snapping::isAsDeep(const Vector& place, const Vector& wanted) const {
    const Line line = lineOfSight(sight_, sight_.pixels(wanted));
    return std::abs((place - wanted).dot(line.direction)) <= reach_ * sight_.pixelLength(wanted);
}

// Of those as deep as the hand the nearest in space: what lies a little in front of it is further
// away. Of the others the nearest in the picture, and of two in one place the one in front.
const Snapping::Point* Snapping::nearest(const Vector& wanted, bool flat) const {
    const Eigen::Vector2d pixels = sight_.pixels(wanted);
    const double length = sight_.pixelLength(wanted), depth = sight_.depth(wanted);
    const Point* found = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Point& point : points_) {
        double away = (point.pixels - pixels).norm();
        if (away > reach_ || (flat && !isAsDeep(point.place, wanted)))
            continue;
        if (flat)
            away = std::hypot(away,
                              (sight_.depth(point.place) - depth) / (length * sight_.camera.scale));
        const bool inFront = found && !flat && away <= least + 0.5 &&
                             sight_.depth(point.place) > sight_.depth(found->place) + 1e-9;
        if (found && away >= least - (flat ? 0 : 0.5) && !inFront)
            continue;
        least = std::min(least, away);
        found = &point;
    }
    return found;
}

std::optional<Snapped> Snapping::onEdge(const Vector& wanted) const {
    const Eigen::Vector2d pixels = sight_.pixels(wanted);
    std::optional<Snapped> found;
    double least = reach_;
    for (const Edge& edge : edges_) {
        const Vector way = edge.to - edge.from;
        const double along =
            std::clamp((wanted - edge.from).dot(way) / way.squaredNorm(), 0.0, 1.0);
        const Vector place = edge.from + along * way;
        const double away = (sight_.pixels(place) - pixels).norm();
        if (!(away <= least) || !isAsDeep(place, wanted))
            continue;
        least = away;
        found = Snapped{place, true, "an edge of " + bodies_[edge.body]};
    }
    return found;
}

// The hand moves in the plane of the screen: coordinates across it stay as they are. The others are
// drawn to round numbers; between these they have few digits, those of a new place in each picture,
// those of one that is moved where one looks along an axis, as at a plan.
Vector Snapping::rounded(const Vector& wanted, const std::optional<Vector>& before) const {
    const double length = sight_.pixelLength(wanted), step = this->step(wanted);
    constexpr double finer = 8;
    const double fine = roundStep(step / finer);
    const bool isPlan = sight_.isPlan();
    Vector place = wanted;
    for (Eigen::Index i = 0; i < 3; ++i) {
        Vector axis = Vector::Zero();
        axis[i] = 1;
        const double round = std::round(wanted[i] / step) * step;
        if ((sight_.camera.rotation * axis).head<2>().norm() < 0.2) {
            place[i] = before ? wanted[i] : round; // of a new place nobody sees how deep it is
            continue;
        }
        const double near = 0.7 * reach_ * length;
        if (before && std::abs(wanted[i] - (*before)[i]) <= near)
            place[i] = (*before)[i];
        else if (std::abs(wanted[i] - round) <= near)
            place[i] = round;
        else if (isPlan || !before)
            place[i] = std::round(wanted[i] / fine) * fine;
    }
    return place;
}

Snapped Snapping::at(const Vector& wanted, const std::optional<Vector>& before) const {
    if (const Point* flat = nearest(wanted, true))
        return {flat->place, true, flat->name};
    if (auto edge = onEdge(wanted))
        return *edge;
    if (const Point* point = nearest(wanted, false))
        return {point->place, true, point->name};
    return {rounded(wanted, before), false, {}};
}

} // namespace gestures
