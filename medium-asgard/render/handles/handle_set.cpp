// Which handles a scene has, and where they stand.
#include "drawing/round_numbers.h"
#include "framing/framing.h"
#include "framing/joint_places.h"
#include "framing/rope_lines.h"
#include "handles/handle_layout.h"
#include "handles/handles.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace render {

namespace {

// The round scale that makes the longest arrow a good part of the picture's shorter half.
double scaleFor(double longest) {
    constexpr double good = 0.65; // view units
    return longest > 0 && std::isfinite(longest) ? roundBelow(good / longest) : roundBelow(good);
}

double scaleFor(double longest, const std::optional<double>& before) {
    constexpr double shortest = 0.06, edge = 0.95; // view units, from the picture's middle
    const bool fits =
        before && (longest == 0 || (longest * *before >= shortest && longest * *before <= edge));
    return fits ? *before : scaleFor(longest);
}

std::string number(double value, const char* unit) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g %s", value, unit);
    return text;
}

// How far a body's shape reaches from its own origin.
double reachOf(const scene::Scene& scene, const scene::Body& body) {
    double reach = 0;
    for (const Ball& ball : outlineOf(scene, body))
        reach = std::max(reach, ball.center.norm() + ball.radius);
    return reach > 0 ? reach : 1;
}

} // namespace

Handles::Handles(const scene::Scene& scene, simulation::MotionPointer motion,
                 const std::optional<ArrowScales>& before)
    : scene_(scene), motion_(std::move(motion)), extent_(extentOf(scene, motion_.get())),
      values_(scene, motion_) {
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
        bodies_.emplace(scene_.bodies[i].name, i);
        reaches_.push_back(reachOf(scene_, scene_.bodies[i]));
    }
    setScales(before);
}

double Handles::massOf(std::size_t body) const {
    if (scene_.bodies[body].mass)
        return *scene_.bodies[body].mass;
    const double mass = motion_ && body < motion_->bodies() ? motion_->mass(body) : 1;
    return std::isfinite(mass) ? mass : 1;
}

std::size_t Handles::indexOf(const std::string& body) const {
    const auto found = bodies_.find(body);
    return found == bodies_.end() ? scene_.bodies.size() : found->second;
}

Vector Handles::pointOn(std::size_t body, const std::optional<Vector>& offset,
                        const geometry::Pose& pose) const {
    const bool known = motion_ && body < motion_->bodies();
    return pose.toWorld(offset.value_or(known ? motion_->centroid(body) : Vector::Zero()));
}

// Arrows that never change are as long as they are; the others are measured at the start only, so
// that playing does not change the scale.
void Handles::setScales(const std::optional<ArrowScales>& before) {
    double velocity = 0, spin = 0, force = 0, torque = 0;
    for (const scene::Body& body : scene_.bodies)
        if (!body.fixed) {
            velocity = std::max(velocity, body.initialVelocity.norm());
            spin = std::max(spin, body.initialAngularVelocity.norm());
        }
    for (const scene::Force& one : scene_.forces) {
        const std::size_t body = indexOf(one.body);
        std::optional<Vector> value;
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&one.kind))
            value = body < scene_.bodies.size()
                        ? std::optional<Vector>(massOf(body) * weight->acceleration)
                        : std::nullopt;
        else if (const auto* components = componentsOf(one))
            value = values_.constant(*components);
        double& longest = one.couple ? torque : force;
        if (value)
            longest = std::max(longest, value->norm());
        if (const auto* path = std::get_if<scene::TrajectoryForce>(&one.kind))
            for (const scene::Trajectory& trajectory : scene_.trajectories)
                if (trajectory.name == path->trajectory)
                    for (const Vector& along : pathOf(trajectory))
                        longest = std::max(longest, along.norm());
    }
    const auto scale = [&](double ArrowScales::*which, double longest) {
        scales_.*which = scaleFor(longest, before ? std::optional((*before).*which) : std::nullopt);
    };
    scale(&ArrowScales::velocity, velocity);
    scale(&ArrowScales::spin, spin);
    scale(&ArrowScales::force, force);
    scale(&ArrowScales::torque, torque);
}

void Handles::addBody(HandleSet& set, std::size_t index, const Display& display) const {
    const scene::Body& body = scene_.bodies[index];
    const Vector reference = body.initialPosition;
    const geometry::Pose start{reference, body.initialAttitude};
    const std::size_t first = set.handles.size();
    if (display.positionHandles)
        set.handles.push_back({HandleKind::position, index, 0, reference, reference});
    if (display.orientationHandles) {
        const double reach = 1.15 * reaches_[index];
        for (std::size_t axis : {0U, 1U})
            set.handles.push_back({HandleKind::orientation, index, axis, reference,
                                   start.toWorld(reach * Vector::Unit(static_cast<int>(axis))),
                                   reach, start});
    }
    const Vector center = pointOn(index, std::nullopt, start);
    const double perVelocity = scales_.velocity * viewUnit_, perSpin = scales_.spin * viewUnit_;
    if (display.velocityHandles && !body.fixed)
        set.handles.push_back({HandleKind::velocity, index, 0, center,
                               center + perVelocity * body.initialVelocity, perVelocity});
    if (display.spinHandles && !body.fixed)
        set.handles.push_back({HandleKind::spin,
                               index,
                               0,
                               center,
                               center + perSpin * body.initialAngularVelocity,
                               perSpin,
                               {},
                               true,
                               number(body.initialAngularVelocity.norm(), "rad/s")});
    for (std::size_t i = first; i < set.handles.size(); ++i)
        set.handles[i].clear = reaches_[index];
}

void Handles::addForces(HandleSet& set, double time, const Display& display) {
    for (std::size_t i = 0; i < scene_.forces.size(); ++i) {
        const scene::Force& force = scene_.forces[i];
        const std::size_t body = indexOf(force.body);
        const auto* path = std::get_if<scene::TrajectoryForce>(&force.kind);
        const bool shown = (force.couple ? display.torqueHandles : display.forceHandles) ||
                           (display.trajectories && path);
        if (!shown || body == scene_.bodies.size() || isHidden(display, scene_.bodies[body]))
            continue;
        const geometry::Pose pose = poseOf(scene_, motion_.get(), body, time);
        const double scale = viewUnit_ * (force.couple ? scales_.torque : scales_.force);
        Handle head{force.couple ? HandleKind::torqueHead : HandleKind::forceHead, i};
        head.perUnit = scale;
        std::optional<Vector> value;
        if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind)) {
            head.perUnit = scale * massOf(body);
            value = weight->acceleration;
        } else if (const auto* components = std::get_if<scene::ComponentForce>(&force.kind)) {
            if (components->frame == scene::Frame::body)
                head.frame.attitude = pose.attitude;
            head.movable = values_.constant(components->components).has_value();
            value = values_.at(components->components, time);
        } else if (path) {
            head.movable = false;
            value = values_.at(valuesOf(path->trajectory), time);
        }
        if (!value)
            continue;
        head.base = pointOn(body, force.offset, pose);
        head.place = head.base + head.perUnit * (head.frame.attitude * *value);
        set.handles.push_back({force.couple ? HandleKind::torqueBase : HandleKind::forceBase, i, 0,
                               head.base, head.base, 1, pose});
        set.handles.push_back(head);
        for (Handle* one : {&set.handles.end()[-2], &set.handles.back()})
            one->clear = reaches_[body] + (head.base - pose.position).norm();
    }
}

namespace {

// A joint or link is hidden when all bodies that it joins are. `second`: "": the world.
bool areHidden(const Display& display, const std::string& first, const std::string& second) {
    return display.hidden && display.hidden->contains(first) &&
           (second.empty() || display.hidden->contains(second));
}

} // namespace

void Handles::addLinks(HandleSet& set, double time, const Display& display) {
    for (std::size_t i = 0; i < scene_.links.size(); ++i) {
        const scene::Link& link = scene_.links[i];
        const auto onBody = [&](const scene::BodyEnd& end, std::size_t part) {
            const std::size_t body = indexOf(end.body);
            const geometry::Pose pose = poseOf(scene_, motion_.get(), body, time);
            Vector place = pointOn(body, end.offset, pose);
            set.handles.push_back({HandleKind::linkEnd, i, part, place, place, 1, pose});
            set.handles.back().clear = reaches_[body] + (place - pose.position).norm();
            return place;
        };
        const auto* other = std::get_if<scene::BodyEnd>(&link.second);
        if (indexOf(link.first.body) == scene_.bodies.size() ||
            areHidden(display, link.first.body, other ? other->body : std::string()))
            continue;
        const Vector first = onBody(link.first, 0);
        std::optional<Vector> second;
        if (other) {
            if (indexOf(other->body) < scene_.bodies.size())
                second = onBody(*other, 1);
        } else if (const auto* point = std::get_if<scene::PointEnd>(&link.second)) {
            second = values_.at(point->coordinates, time);
            if (second)
                set.handles.push_back({HandleKind::linkEnd,
                                       i,
                                       1,
                                       *second,
                                       *second,
                                       1,
                                       {},
                                       values_.constant(point->coordinates).has_value()});
        } else if (const auto* path = std::get_if<scene::TrajectoryEnd>(&link.second)) {
            second = values_.at(valuesOf(path->trajectory), time);
        }
        if (second)
            set.lines.push_back({HandleKind::linkEnd, i, {first, *second}});
    }
}

// Beyond its last point, by what the rope is longer than it measures at the start; a little further
// out, so that nothing there covers it.
void Handles::addRopes(HandleSet& set, double time, const Display& display) const {
    for (std::size_t i = 0; i < scene_.ropes.size(); ++i) {
        const scene::Rope& rope = scene_.ropes[i];
        const bool isHidden =
            display.hidden && std::ranges::all_of(rope.points, [&](const auto& p) {
                return p.body && display.hidden->contains(*p.body);
            });
        const auto end = ropeEndOf(scene_, motion_.get(), i, time);
        if (!end || isHidden)
            continue;
        const std::string& last = rope.points.back().body.value_or(std::string());
        const std::size_t body = last.empty() ? scene_.bodies.size() : indexOf(last);
        const double reach = body < reaches_.size() ? reaches_[body] : 0;
        const geometry::Pose frame{
            end->at + (reach + 0.06 * viewUnit_) * end->direction,
            geometry::Quaternion::FromTwoVectors(Vector::UnitZ(), end->direction)};
        const double slack = std::max(0.0, rope.length.value_or(end->measured) - end->measured);
        const Vector stands = frame.toWorld(Vector(0, 0, slack));
        set.handles.push_back({HandleKind::ropeLength, i, 0, stands, stands, 1, frame});
    }
}

void Handles::addJoints(HandleSet& set, double time, const Display& display) const {
    const JointPlaces places(scene_, motion_.get());
    for (std::size_t i = 0; i < scene_.joints.size(); ++i) {
        const scene::Joint& joint = scene_.joints[i];
        const auto place = places.at(joint, time);
        if (!place || areHidden(display, joint.body1, joint.body2.value_or("")))
            continue;
        const JointEnd &first = place->ends[0], &second = place->ends[1];
        if (scene::traitsOf(joint.type).hasAxis) {
            const double length = joint.axis.norm() > 0 ? joint.axis.norm() : 1;
            const double perUnit = 0.25 * viewUnit_ / length;
            const Vector head =
                first.point + perUnit * length * first.carried(place->axis).normalized();
            set.handles.push_back(
                {HandleKind::jointAxis, i, 0, first.point, head, perUnit, first.pose});
        }
        set.handles.push_back(
            {HandleKind::jointPoint, i, 0, first.point, first.point, 1, first.pose});
        addLimits(set, i, *place);
        if (joint.type == scene::JointType::distance)
            set.handles.push_back(
                {HandleKind::jointPoint, i, 1, second.point, second.point, 1, second.pose});
    }
}

// At the ends of a hinge's arc, at the stops of a slider's rail, where its sign has them.
void Handles::addLimits(HandleSet& set, std::size_t index, const JointPlace& place) const {
    const scene::Joint& joint = scene_.joints[index];
    const bool isHinge = joint.type == scene::JointType::hinge;
    if ((!isHinge && joint.type != scene::JointType::slider) || joint.coordinates.empty())
        return;
    const scene::JointCoordinate& q = joint.coordinates.front();
    const JointEnd& second = place.ends[1];
    const Vector n = second.carried(place.axis), u = second.carried(place.unturned());
    Eigen::Matrix3d axes;
    axes << u, n.cross(u), n;
    const Vector middle =
        isHinge ? place.ends[0].point : Vector(second.point + n * place.axis.dot(place.apart));
    const geometry::Pose frame{middle, geometry::Quaternion(axes)};
    const double reach = 0.085 * viewUnit_; // a little further out than the arc
    const std::array limits{q.lower, q.upper};
    for (std::size_t part = 0; part < limits.size(); ++part) {
        if (!limits[part])
            continue;
        const double at = *limits[part] - q.from;
        const Vector local =
            isHinge ? Vector(reach * std::cos(at), reach * std::sin(at), 0) : Vector(0, 0, at);
        const Vector stands = frame.toWorld(local);
        set.handles.push_back({HandleKind::jointLimit, index, part, stands, stands, 1, frame});
    }
}

void Handles::addLights(HandleSet& set) const {
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
        const scene::LightSource& light = scene_.lights[i];
        const Vector direction = light.direction.value_or(Vector::Zero());
        const double length = direction.norm();
        // Where nothing is said it stands beside the scene, shining on its middle.
        const Vector place = light.position.value_or(
            extent_.box.isEmpty() || !(length > 0)
                ? Vector::Zero()
                : Vector(extent_.box.center() - 0.7 * extent_.size / length * direction));
        set.handles.push_back({HandleKind::lightPlace, i, 0, place, place});
        if (length > 0) {
            const double perUnit = 0.3 * viewUnit_ / length;
            set.handles.push_back(
                {HandleKind::lightDirection, i, 0, place, place + perUnit * direction, perUnit});
        }
    }
}

const scene::Force* Handles::forceAlong(const scene::Trajectory& trajectory) const {
    const auto follows = [&](const scene::Link& link) {
        const auto* end = std::get_if<scene::TrajectoryEnd>(&link.second);
        return end && end->trajectory == trajectory.name;
    };
    if (std::ranges::any_of(scene_.links, follows) ||
        std::ranges::find(scene_.constraints, trajectory.name, &scene::Constraint::trajectory) !=
            scene_.constraints.end())
        return nullptr;
    const auto force = std::ranges::find_if(scene_.forces, [&](const scene::Force& one) {
        const auto* kind = std::get_if<scene::TrajectoryForce>(&one.kind);
        return kind && kind->trajectory == trajectory.name;
    });
    return force == scene_.forces.end() || indexOf(force->body) == scene_.bodies.size() ? nullptr
                                                                                        : &*force;
}

// `like`: what all of its points have in common.
void Handles::addPoints(HandleSet& set, std::size_t index, const Handle& like) const {
    const scene::Trajectory& trajectory = scene_.trajectories[index];
    std::size_t part = 0;
    const auto add = [&](const Vector& value, const std::string& label) {
        Handle point = like;
        point.part = part++;
        point.place = like.placeOf(value);
        point.base = like.clear > 0 ? like.frame.position : point.place;
        point.label = label;
        set.handles.push_back(point);
    };
    for (const auto& [time, value] : trajectory.points)
        add(value, number(time, "s"));
    if (!trajectory.points.empty())
        return;
    for (std::size_t c = 0; c < trajectory.curves.size(); ++c) {
        const scene::BezierCurve& curve = trajectory.curves[c];
        const std::size_t last = curve.control.size() - 1;
        // Where one curve ends as the next begins there is one point.
        const bool continues = c > 0 && trajectory.curves[c - 1].to == curve.from &&
                               trajectory.curves[c - 1].control.size() > 1 && last > 0 &&
                               trajectory.curves[c - 1].control.back() == curve.control[0];
        for (std::size_t j = continues ? 1 : 0; j <= last; ++j)
            add(curve.control[j], j == 0      ? number(curve.from, "s")
                                  : j == last ? number(curve.to, "s")
                                              : "");
    }
}

// The values of a force are arrows from where it acts now, no path in space.
void Handles::addTrajectories(HandleSet& set, double time, const Display& display) const {
    for (std::size_t i = 0; i < scene_.trajectories.size(); ++i) {
        const scene::Trajectory& trajectory = scene_.trajectories[i];
        Handle like{HandleKind::trajectoryPoint, i};
        if (const scene::Force* force = forceAlong(trajectory)) {
            const std::size_t body = indexOf(force->body);
            if (isHidden(display, scene_.bodies[body]))
                continue;
            const geometry::Pose pose = poseOf(scene_, motion_.get(), body, time);
            like.frame.position = pointOn(body, force->offset, pose);
            like.perUnit = viewUnit_ * (force->couple ? scales_.torque : scales_.force);
            like.clear = reaches_[body] + (like.frame.position - pose.position).norm();
        } else {
            set.lines.push_back({HandleKind::trajectoryPoint, i, pathOf(trajectory)});
        }
        addPoints(set, i, like);
    }
}

double Handles::arrowLength(HandleKind kind, const Camera& camera) const {
    return (kind == HandleKind::torqueHead ? scales_.torque : scales_.force) / camera.scale;
}

static thread_local std::size_t computed = 0;

std::size_t Handles::setsComputed() { return computed; }

HandleSet Handles::at(double time, const Display& display) {
    const Size size;
    return at(time, display, fitted(extent_, bestAttitude(extent_), size), size);
}

HandleSet Handles::at(double time, const Display& display, const Camera& camera, Size size) {
    ++computed;
    viewUnit_ = 1 / camera.scale;
    HandleSet set;
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
        if (!isHidden(display, scene_.bodies[i]))
            addBody(set, i, display);
    if (display.forceHandles || display.torqueHandles || display.trajectories)
        addForces(set, time, display);
    if (display.linkHandles)
        addLinks(set, time, display);
    if (display.linkHandles)
        addRopes(set, time, display);
    if (display.jointHandles)
        addJoints(set, time, display);
    if (display.lightHandles)
        addLights(set);
    if (display.trajectories)
        addTrajectories(set, time, display);
    keepInside(set, camera, size);
    spread(set, camera, size, display.opened);
    return set;
}

} // namespace render
