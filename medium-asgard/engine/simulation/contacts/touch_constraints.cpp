#include "contacts/touch_constraints.h"

#include "geometry/outline.h"
#include "surfaces/posed_parts.h"

#include <cmath>
#include <optional>
#include <utility>

namespace simulation {
namespace {

using geometry::depthInside;
using physics::GapConstraint;
using ConstraintKind = physics::GapConstraint::Kind;

GapConstraint onPlane(ConstraintKind kind, const Vector& bodyPoint, const Vector& supportPoint,
                      const Touch& touch, const Placed& body, const Placed& support) {
    GapConstraint c;
    c.kind = kind;
    c.support = support.index;
    c.bodyPoint = intoFrame(body, bodyPoint);
    c.supportPoint = intoFrame(support, supportPoint);
    c.normal = turnedInto(kind == ConstraintKind::onBodyPlane ? body : support, touch.normal);
    c.supportTurns = support.turns;
    c.supportRotation = support.state.attitude.toRotationMatrix();
    return c;
}

// With a face flat on a plane that does not turn, the centre's distance from it stays, and so do
// the directions that lie in it. They are those of the face itself, which may yet be tilted by what
// counts as touching.
std::vector<GapConstraint> flat(const Touch& touch, const Placed& body, const Placed& support) {
    GapConstraint distance = onPlane(ConstraintKind::onSupportPlane, body.state.position,
                                     touch.supportFace[0], touch, body, support);
    const Vector normal =
        -faceNormal(posed(body, touch.bodyPart, body.state.position), -touch.normal);
    distance.radius = normal.dot(body.state.position - touch.bodyFace[0]);
    std::vector<GapConstraint> constraints{distance};
    const Vector across = turnedInto(body, normal).unitOrthogonal();
    const Vector along = turnedInto(body, normal).cross(across);
    for (const auto& [axis, inPlane] : {std::pair(across, along), {along, Vector(-across)}}) {
        GapConstraint tilt = distance;
        tilt.kind = ConstraintKind::tilt;
        tilt.bodyEdge = axis;
        tilt.inPlane = inPlane;
        constraints.push_back(tilt);
    }
    return constraints;
}

// The edge of an outline (or the outline, if it is one) that a point lies on and not at its end.
std::optional<Vector> edgeThrough(const std::vector<Vector>& outline, const Vector& point,
                                  double tolerance) {
    const std::size_t edges = outline.size() == 2 ? 1 : outline.size();
    for (std::size_t i = 0; i < edges && outline.size() > 1; ++i) {
        const Vector &a = outline[i], &b = outline[(i + 1) % outline.size()];
        const Vector edge = (b - a).normalized();
        const double along = edge.dot(point - a);
        if (edge.cross(point - a).norm() <= tolerance && along > tolerance &&
            along < (b - a).norm() - tolerance)
            return edge;
    }
    return std::nullopt;
}

// A single corner where an edge of the body crosses one of the support: the place at which it bears
// goes along both, and is no point of either.
std::optional<GapConstraint> crossingAt(const Touch& touch, const Corner& corner,
                                        const Placed& body, const Placed& support) {
    constexpr double parallel = 1e-3, near = 1e-5;
    const auto ofBody = edgeThrough(touch.bodyFace, corner.point, near * touch.size);
    const auto ofSupport = edgeThrough(touch.supportFace, corner.point, near * touch.size);
    if (!ofBody || !ofSupport)
        return std::nullopt;
    const double across = ofBody->cross(*ofSupport).dot(touch.normal);
    if (std::abs(across) < parallel)
        return std::nullopt;
    GapConstraint c =
        onPlane(ConstraintKind::edgeOnEdge, corner.point, corner.point, touch, body, support);
    c.bodyEdge = turnedInto(body, *ofBody);
    c.supportEdge = turnedInto(support, *ofSupport);
    c.flipped = across < 0;
    return c;
}

} // namespace

std::vector<GapConstraint> constraintsOf(const Touch& touch,
                                         const std::vector<std::size_t>& bearing,
                                         const Placed& body, const Placed& support) {
    std::vector<GapConstraint> constraints;
    if (touch.isFlat && bearing.size() > 2 && !support.turns)
        return flat(touch, body, support);
    Vector middle = Vector::Zero();
    for (const std::size_t i : bearing)
        middle += touch.corners[i].point / static_cast<double>(bearing.size());
    const bool isSupportsEdge = touch.isFlat && bearing.size() < 3 &&
                                depthInside(touch.supportFace, touch.normal, middle) <
                                    depthInside(touch.bodyFace, touch.normal, middle);
    if (bearing.size() == 1 && !touch.bodyFace.empty())
        if (const auto crossing = crossingAt(touch, touch.corners[bearing[0]], body, support))
            return {*crossing};
    for (const std::size_t i : bearing)
        if (isSupportsEdge)
            constraints.push_back(onPlane(ConstraintKind::onBodyPlane, touch.bodyFace[0],
                                          touch.corners[i].point, touch, body, support));
        else
            constraints.push_back(touch.corners[i].constraint);
    return constraints;
}

} // namespace simulation
