#include "gestures/unsupported.h"

#include "framing/body_places.h"
#include "framing/extent.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace gestures {

namespace {

using geometry::Vector;
using Box = Eigen::AlignedBox3d;

bool hasWeight(const scene::Scene& scene, const std::string& body) {
    return std::ranges::any_of(scene.forces, [&](const scene::Force& force) {
        const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind);
        return force.body == body && weight && !weight->acceleration.isZero();
    });
}

bool isLed(const scene::Scene& scene, const std::string& body) {
    return std::ranges::find(scene.constraints, body, &scene::Constraint::body) !=
           scene.constraints.end();
}

// By a joint, a rope, a link or a spring.
bool isHeld(const scene::Scene& scene, const std::string& body) {
    const auto joins = [&](const scene::Joint& joint) {
        return joint.body1 == body || joint.body2 == body;
    };
    const auto ties = [&](const scene::Rope& rope) {
        return std::ranges::find(rope.points, body, &scene::Rope::Point::body) != rope.points.end();
    };
    const auto pulls = [&](const scene::Link& link) {
        const auto* second = std::get_if<scene::BodyEnd>(&link.second);
        return link.first.body == body || (second && second->body == body);
    };
    return std::ranges::any_of(scene.joints, joins) || std::ranges::any_of(scene.ropes, ties) ||
           std::ranges::any_of(scene.links, pulls);
}

// Its box at the start; empty: it has no end, or no shape.
Box boxOf(const scene::Scene& scene, const scene::Body& body) {
    Box box;
    const geometry::Pose pose{body.initialPosition, body.initialAttitude};
    for (const render::Ball& ball : render::outlineOf(scene, body)) {
        const Vector at = pose.toWorld(ball.center);
        box.extend(Box(at.array() - ball.radius, at.array() + ball.radius));
    }
    return box;
}

bool isEndless(const scene::Scene& scene, const scene::Body& body) {
    const scene::ShapeSet* set = scene::findShapeSet(scene, body.shape);
    return set && std::ranges::any_of(set->parts, [](const scene::Part& part) {
               return std::holds_alternative<scene::PlaneShape>(part.shape);
           });
}

double lowestOf(const Box& box, const Vector& up) {
    return box.center().dot(up) - box.sizes().dot(up.cwiseAbs()) / 2;
}

double sizeOf(const Box& box) { return box.sizes().maxCoeff(); }

bool isOnGrid(const Box& box, const Vector& up) {
    constexpr double touch = 1e-3; // of its size
    return std::abs(lowestOf(box, up)) <= touch * sizeOf(box);
}

// They may hold what is above them.
bool areBelow(const std::vector<Box>& others, const Box& box, const Vector& up) {
    Box column = box; // down without end
    column.extend(box.center() - 1e9 * up);
    return std::ranges::any_of(others, [&](const Box& one) { return column.intersects(one); });
}

// The body fell from the grid, or from above it to far below all that stands.
bool hasFallen(const std::vector<Box>& standing, const Box& start, const simulation::BodyState& end,
               const Vector& up) {
    constexpr double slow = 1e-3; // of its size, in the unit of time
    if (end.velocity.dot(up) > -slow * sizeOf(start))
        return false;
    const double height = end.position.dot(up);
    if (isOnGrid(start, up))
        return height < -sizeOf(start);
    if (standing.empty() || lowestOf(start, up) < 0)
        return false;
    Box room = start;
    for (const Box& one : standing)
        room.extend(one);
    constexpr double far = 2; // times as far as the bodies are apart
    return height < std::min(lowestOf(room, up), 0.0) - far * sizeOf(room);
}

bool rests(const scene::Body& body) {
    return body.fixed || (body.initialVelocity.isZero() && body.initialAngularVelocity.isZero());
}

bool noForceActs(const scene::Scene& scene) {
    const auto isDriven = [](const scene::Joint& joint) {
        return std::ranges::any_of(joint.coordinates, [](const scene::JointCoordinate& one) {
            return one.motor || one.speed || one.position || one.stiffness != 0;
        });
    };
    return scene.forces.empty() && scene.links.empty() && scene.constraints.empty() &&
           std::ranges::none_of(scene.joints, isDriven);
}

// A fixed body is just below it.
bool isCarried(const scene::Scene& scene, const Box& box, const Vector& up) {
    constexpr double near = 0.25; // of its size: a puck floats above its table
    const double most = near * sizeOf(box);
    return std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
        if (!body.fixed)
            return false;
        if (isEndless(scene, body)) {
            const Vector normal = body.initialAttitude * Vector::UnitY();
            return lowestOf(box, normal) - body.initialPosition.dot(normal) <= most;
        }
        const Box below = boxOf(scene, body);
        return !below.isEmpty() && areBelow({below}, box, up) &&
               lowestOf(box, up) + lowestOf(below, -up) <= most;
    });
}

// It rises, sinks or hangs in the air; a ball that rolls level on a table needs no weight.
bool wouldFall(const scene::Scene& scene, const scene::Body& body) {
    const Vector up = render::upOf(scene);
    const Box box = boxOf(scene, body);
    return !box.isEmpty() && (body.initialVelocity.dot(up) != 0 || !isCarried(scene, box, up));
}

} // namespace

std::vector<std::size_t> unsupported(const scene::Scene& scene, const simulation::Motion* motion) {
    const auto up = render::againstGravity(scene); // along an axis
    if (!up)
        return {};
    std::vector<Box> standing; // fixed, led, or held
    for (const scene::Body& body : scene.bodies) {
        const bool isFixed = body.fixed || isLed(scene, body.name);
        if (isFixed && isEndless(scene, body))
            return {};
        if (isFixed || isHeld(scene, body.name))
            standing.push_back(boxOf(scene, body));
    }
    const bool isKnown = motion && motion->computed() > motion->start();
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const scene::Body& body = scene.bodies[i];
        const Box box = boxOf(scene, body);
        if (body.fixed || isLed(scene, body.name) || !hasWeight(scene, body.name) ||
            isHeld(scene, body.name) || box.isEmpty())
            continue;
        const bool falls = isKnown && i < motion->bodies()
                               ? hasFallen(standing, box, motion->at(i, motion->computed()), *up)
                               : isOnGrid(box, *up) && !areBelow(standing, box, *up);
        if (falls)
            found.push_back(i);
    }
    return found;
}

bool nothingMoves(const scene::Scene& scene) {
    return noForceActs(scene) && !std::ranges::all_of(scene.bodies, &scene::Body::fixed) &&
           std::ranges::all_of(scene.bodies, rests);
}

bool lacksWeight(const scene::Scene& scene) {
    const auto isFixed = [](const scene::Body& body) { return body.fixed; };
    return noForceActs(scene) && scene.ropes.empty() &&
           std::ranges::any_of(scene.bodies, isFixed) &&
           std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
               return !body.fixed && !isHeld(scene, body.name) && wouldFall(scene, body);
           });
}

} // namespace gestures
