#include "gestures/handle_meaning.h"

#include "editing/number_text.h"
#include "framing/rope_lines.h"
#include "point_edits/trajectory_edit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace gestures {

using editing::Kind;
using editing::Wish;
using geometry::Vector;
using render::Handle;
using render::HandleKind;

namespace {

std::vector<double> listed(const Vector& v) { return {v.x(), v.y(), v.z()}; }

Wish one(const Handle& handle, const char* option, const Vector& value, const Vector& now,
         double resolution) {
    Wish wish;
    wish.element = elementOf(handle);
    wish.option = option;
    wish.values = listed(value);
    wish.resolution = editing::decimalStep(resolution);
    wish.absent = wish.now = listed(now);
    return wish;
}

std::vector<Wish> components(const Handle& handle, const Vector& value, const Vector& now,
                             double resolution) {
    std::vector<Wish> wishes;
    constexpr const char* options[] = {"-x", "-y", "-z"};
    for (int i = 0; i < 3; ++i) {
        Wish wish = one(handle, options[i], value, now, resolution);
        wish.values = {value[i]};
        wish.absent = wish.now = {now[i]};
        wishes.push_back(std::move(wish));
    }
    return wishes;
}

Wish attitude(const scene::Scene& scene, const Handle& handle, const Vector& place, double length,
              bool quaternion) {
    const geometry::Quaternion turn =
        geometry::Quaternion::FromTwoVectors(handle.place - handle.base, place - handle.base);
    return turnWish(scene, handle, turn, length / std::max(handle.perUnit, 1e-300), quaternion);
}

// By the trajectory's value: of a force's its arrow, else the place.
Wish ofPoint(const scene::Scene& scene, const Handle& handle, const Vector& at, double pixel) {
    const Vector place = handle.valueAt(at), now = handle.valueAt(handle.place);
    const double length = pixel / handle.perUnit;
    const scene::Trajectory& trajectory = scene.trajectories[handle.element];
    if (trajectory.points.empty()) {
        const auto points = editing::controlPointsOf(trajectory.curves);
        Wish wish = one(handle, "-bezier", place, now, length);
        if (points.empty()) // a trajectory without any: its option as a whole
            return wish;
        const editing::ControlPoint& point = points[std::min(handle.part, points.size() - 1)];
        // LIMIT: curves that are not written in the order of time have other places in the text;
        // who has the text asks editing::TrajectoryEdits.
        wish.path = {point.curve, 2 + point.index};
        return wish;
    }
    Wish wish = one(handle, "-points", place, now, length);
    wish.path = {handle.part};
    const double time = trajectory.points[handle.part].first;
    wish.values.insert(wish.values.begin(), time);
    wish.now.insert(wish.now.begin(), time);
    return wish;
}

// The coordinate at the start lies within both limits, and the lower one is under the upper one.
bool allows(const scene::JointCoordinate& q, bool isLower, double limit) {
    if (isLower)
        return limit <= q.from && limit < q.upper.value_or(HUGE_VAL);
    return limit >= q.from && limit > q.lower.value_or(-HUGE_VAL);
}

// The whole number of steps next to `value` that is allowed as it will be written.
double allowedLimit(const scene::JointCoordinate& q, bool isLower, double value, double step,
                    double written) {
    const double outwards = isLower ? -1 : 1;
    value = isLower ? std::min(value, q.from) : std::max(value, q.from);
    const auto at = [&](double steps) { return editing::roundedTo(steps * step, written); };
    double steps = std::round(value / step);
    for (int tries = 0; tries < 3 && !allows(q, isLower, at(steps)); ++tries)
        steps += outwards;
    return at(steps);
}

// A hinge's by whole degrees, drawn to each 15, from where it is on.
Wish limit(const scene::Scene& scene, const Handle& handle, const Vector& place, double pixel) {
    const scene::Joint& joint = scene.joints[handle.element];
    const scene::JointCoordinate& q = joint.coordinates.front();
    const bool isLower = handle.part == 0;
    const double now = (isLower ? q.lower : q.upper).value_or(0);
    Wish wish;
    wish.element = elementOf(handle);
    wish.option = "-limits";
    wish.path = {handle.part};
    wish.now = wish.values = {now};
    wish.resolution = editing::decimalStep(pixel);
    const bool isHinge = joint.type == scene::JointType::hinge;
    if (isHinge)
        wish.resolution = 1e-6;
    if (place == handle.place || wish.resolution <= 0)
        return wish;
    const Vector local = handle.frame.toLocal(place);
    double value = q.from + local.z(), step = wish.resolution;
    if (isHinge) {
        constexpr double degree = M_PI / 180, round = 15 * degree, near = 2.5 * degree;
        value = now + std::remainder(q.from + std::atan2(local.y(), local.x()) - now, 2 * M_PI);
        const double drawn = round * std::round(value / round);
        value = std::abs(value - drawn) < near ? drawn : value;
        step = degree;
    }
    wish.values = {allowedLimit(q, isLower, value, step, wish.resolution)};
    return wish;
}

// No shorter than the rope measures at the start, as it will be written.
Wish lengthOfRope(const scene::Scene& scene, const Handle& handle, const Vector& place,
                  double pixel) {
    const auto end = render::ropeEndOf(scene, nullptr, handle.element, scene.simulator.start);
    const double measured = end ? end->measured : 0;
    Wish wish;
    wish.element = elementOf(handle);
    wish.option = "-length";
    wish.absent = {measured};
    wish.now = wish.values = {scene.ropes[handle.element].length.value_or(measured)};
    wish.resolution = editing::decimalStep(pixel);
    if (place == handle.place || wish.resolution <= 0)
        return wish;
    double steps = std::round((measured + handle.frame.toLocal(place).z()) / wish.resolution);
    steps = std::max(steps, std::ceil(measured / wish.resolution - 1e-9));
    wish.values = {editing::roundedTo(steps * wish.resolution, wish.resolution)};
    return wish;
}

// In any locale with a point.
std::string fixed(double value, int digits) {
    std::array<char, 400> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value,
                                   std::chars_format::fixed, digits)
                         .ptr;
    return {text.data(), end};
}

const scene::Force* forceOf(const scene::Scene& scene, const Handle& handle) {
    return elementOf(handle).kind == Kind::force ? &scene.forces[handle.element] : nullptr;
}

} // namespace

Wish turnWish(const scene::Scene& scene, const Handle& handle, const geometry::Quaternion& turn,
              double resolution, bool quaternion) {
    const geometry::Quaternion now = scene.bodies[handle.element].initialAttitude;
    const geometry::Quaternion turned = (turn * now).normalized();
    Wish wish =
        one(handle, "-init_rot", geometry::toRotationVector(turned), Vector::Zero(), resolution);
    wish.now.clear(); // one attitude has many rotation vectors
    if (quaternion)
        wish.values = {turned.w(), turned.x(), turned.y(), turned.z()};
    return wish;
}

bool isPlacedAlone(const editing::Mapper& mapper, std::size_t body) {
    const Vector now = mapper.scene().bodies[body].initialPosition;
    Wish wish;
    wish.element = {Kind::body, body};
    wish.option = "-init_pos";
    wish.values = listed(now + Vector::Ones());
    wish.absent = {0, 0, 0};
    wish.now = listed(now);
    wish.offers = false;
    const editing::Answer answer = mapper.answer(wish);
    const scene::Range own = mapper.scene().bodies[body].source.command;
    return answer.possible() && std::ranges::all_of(answer.edits, [&](const text::Edit& edit) {
               return own.from <= edit.range.from && edit.range.to <= own.to;
           });
}

editing::Element elementOf(const Handle& handle) {
    switch (handle.kind) {
    case HandleKind::position:
    case HandleKind::orientation:
    case HandleKind::velocity:
    case HandleKind::spin:
        return {Kind::body, handle.element};
    case HandleKind::forceBase:
    case HandleKind::forceHead:
    case HandleKind::torqueBase:
    case HandleKind::torqueHead:
        return {Kind::force, handle.element};
    case HandleKind::linkEnd:
        return {Kind::link, handle.element};
    case HandleKind::jointAxis:
    case HandleKind::jointPoint:
    case HandleKind::jointLimit:
        return {Kind::joint, handle.element};
    case HandleKind::ropeLength:
        return {Kind::rope, handle.element};
    case HandleKind::lightPlace:
    case HandleKind::lightDirection:
        return {Kind::light, handle.element};
    case HandleKind::trajectoryPoint:
        break;
    }
    return {Kind::trajectory, handle.element};
}

std::vector<Wish> wishesFor(const scene::Scene& scene, const Handle& handle, const Vector& place,
                            double length, bool quaternion) {
    const auto arrow = [&](const Vector& head) -> Vector {
        return handle.frame.attitude.conjugate() * ((head - handle.base) / handle.perUnit);
    };
    const Vector value = arrow(place), now = arrow(handle.place);
    const Vector local = handle.frame.toLocal(place), localNow = handle.frame.toLocal(handle.place);
    const double resolution = length / handle.perUnit;
    switch (handle.kind) {
    case HandleKind::position:
        return {one(handle, "-init_pos", place, handle.place, length)};
    case HandleKind::orientation:
        return {attitude(scene, handle, place, length, quaternion)};
    case HandleKind::velocity:
        return {one(handle, "-init_dpos", value, now, resolution)};
    case HandleKind::spin:
        return {one(handle, "-init_drot", value, now, resolution)};
    case HandleKind::forceBase:
    case HandleKind::torqueBase:
        return {one(handle, "-offset", local, localNow, length)};
    case HandleKind::forceHead:
    case HandleKind::torqueHead:
        if (std::holds_alternative<scene::GravitationalForce>(scene.forces[handle.element].kind))
            return {one(handle, "-gravitational", value, now, resolution)};
        return components(handle, value, now, resolution);
    case HandleKind::linkEnd:
        if (handle.part == 1 &&
            std::holds_alternative<scene::PointEnd>(scene.links[handle.element].second))
            return components(handle, place, handle.place, length);
        return {one(handle, handle.part == 0 ? "-offset1" : "-offset2", local, localNow, length)};
    case HandleKind::jointAxis:
        return {one(handle, "-axis", value, now, resolution)};
    case HandleKind::jointPoint:
        return {one(handle, handle.part == 0 ? "-offset1" : "-offset2", local, localNow, length)};
    case HandleKind::jointLimit:
        return {limit(scene, handle, place, length)};
    case HandleKind::ropeLength:
        return {lengthOfRope(scene, handle, place, length)};
    case HandleKind::lightPlace:
        return {one(handle, "-pos", place, handle.place, length)};
    case HandleKind::lightDirection:
        return {one(handle, "-direction", value, now, resolution)};
    case HandleKind::trajectoryPoint:
        break;
    }
    return {ofPoint(scene, handle, place, length)};
}

std::vector<Wish> withValues(std::vector<Wish> wishes, const std::vector<double>& values) {
    std::size_t at = 0;
    for (Wish& wish : wishes) {
        for (double& value : wish.values)
            value = at < values.size() ? values[at++] : value;
        wish.resolution = 0;
    }
    return wishes;
}

std::vector<Wish> withFollowing(const scene::Scene& scene, std::vector<Wish> wishes) {
    const Wish wish = wishes.front();
    if (wish.element.kind != Kind::joint || wish.option != "-offset1" || wish.now.size() != 3)
        return wishes;
    const scene::Joint& joint = scene.joints[wish.element.index];
    const scene::Body* first = scene::findBody(scene, joint.body1);
    const scene::Body* second = joint.body2 ? scene::findBody(scene, *joint.body2) : nullptr;
    if (joint.type == scene::JointType::distance || !joint.offset2 || !first)
        return wishes;
    Vector moved = first->initialAttitude * (Vector(wish.values.data()) - Vector(wish.now.data()));
    if (second)
        moved = second->initialAttitude.conjugate() * moved;
    Wish other = wish;
    other.option = "-offset2";
    other.values = listed(*joint.offset2 + moved);
    other.absent = other.now = listed(*joint.offset2);
    wishes.push_back(std::move(other));
    return wishes;
}

std::string subjectOf(const scene::Scene& scene, const Handle& handle) {
    const editing::Element element = elementOf(handle);
    if (const scene::Force* force = forceOf(scene, handle))
        return (force->couple ? "torque on " : "force on ") + force->body;
    if (element.kind == Kind::link)
        return (scene.links[element.index].spring ? "spring of " : "link of ") +
               scene.links[element.index].first.body;
    const std::string name = editing::nameOf(scene, element);
    return name.empty() ? editing::describe(scene, element) : name;
}

std::string quantityOf(const scene::Scene& scene, const Handle& handle) {
    switch (handle.kind) {
    case HandleKind::position:
        return "position";
    case HandleKind::orientation:
        return "rotation";
    case HandleKind::velocity:
        return "velocity";
    case HandleKind::spin:
        return "angular velocity";
    case HandleKind::forceBase:
    case HandleKind::torqueBase:
        return "offset";
    case HandleKind::forceHead:
    case HandleKind::torqueHead:
        return std::holds_alternative<scene::GravitationalForce>(scene.forces[handle.element].kind)
                   ? "acceleration"
                   : "components";
    case HandleKind::linkEnd:
        return handle.part == 0 ? "first end" : "second end";
    case HandleKind::jointAxis:
        return "axis";
    case HandleKind::jointPoint:
        return handle.part == 0 ? "point" : "second point";
    case HandleKind::jointLimit:
        return handle.part == 0 ? "lower limit" : "upper limit";
    case HandleKind::ropeLength:
        return "length";
    case HandleKind::lightPlace:
        return "place";
    case HandleKind::lightDirection:
        return "direction";
    case HandleKind::trajectoryPoint:
        break;
    }
    return "point " + std::to_string(handle.part + 1);
}

std::string nameOf(const scene::Scene& scene, const Handle& handle) {
    const std::string subject = subjectOf(scene, handle);
    if (handle.kind == HandleKind::forceHead || handle.kind == HandleKind::torqueHead)
        return "the " + subject;
    const bool named = editing::nameOf(scene, elementOf(handle)) == subject;
    return "the " + quantityOf(scene, handle) + " of " + (named ? "" : "the ") + subject;
}

std::string labelOf(const scene::Scene& scene, const Handle& handle) {
    const std::string subject = subjectOf(scene, handle);
    if (handle.kind == HandleKind::position || handle.kind == HandleKind::lightPlace)
        return "Move " + subject;
    if (handle.kind == HandleKind::orientation)
        return "Turn " + subject;
    return "Change the " + quantityOf(scene, handle) + " of " + subject;
}

std::string valuesOf(const std::vector<Wish>& wishes) {
    std::string text;
    for (const Wish& wish : wishes) {
        const int digits =
            wish.resolution > 0
                ? std::clamp(static_cast<int>(std::lround(-std::log10(wish.resolution))), 0, 9)
                : 6;
        for (const double value : wish.values) {
            const double shown = std::abs(value) < 0.5 * std::pow(10, -digits) ? 0 : value;
            text += (text.empty() ? "" : " ") + fixed(shown, digits);
        }
    }
    return text;
}

} // namespace gestures
