#include "contacts/gap_rates.h"

namespace simulation {
namespace {

using physics::GapConstraint;
using ConstraintKind = physics::GapConstraint::Kind;

Vector centripetal(const BodyState& state, const Vector& point) {
    const Vector& w = state.angularVelocity;
    return w.cross(w.cross(point - state.position));
}

Vector accelerationAt(const Placed& placed, const Vector& point) {
    return placed.acceleration.linear +
           placed.acceleration.angular.cross(point - placed.state.position) +
           centripetal(placed.state, point);
}

Vector normalRate(const GapConstraint& c, const Vector& normal, const BodyState& body,
                  const BodyState& support) {
    const Vector &w = body.angularVelocity, &u = support.angularVelocity;
    if (c.kind == ConstraintKind::onSupportPlane)
        return u.cross(normal);
    if (c.kind == ConstraintKind::onBodyPlane)
        return w.cross(normal);
    if (c.kind != ConstraintKind::edgeOnEdge)
        return Vector::Zero();
    const Vector a = body.attitude * c.bodyEdge;
    const Vector b = support.attitude * c.supportEdge;
    const double length = (c.flipped ? -1 : 1) * a.cross(b).norm();
    const Vector rate = (w.cross(a).cross(b) + a.cross(u.cross(b))) / length;
    return rate - normal * normal.dot(rate);
}

} // namespace

void measureGap(Corner& corner, const Touch& touch, const Vector& bodyPoint,
                const Vector& supportPoint, const Placed& body, const Placed& support) {
    const GapConstraint& c = corner.constraint;
    const Vector& n = touch.normal;
    const bool onPlane =
        c.kind == ConstraintKind::onSupportPlane || c.kind == ConstraintKind::onBodyPlane;
    // On a plane, the material point of its owner that lies under the other's point.
    const Vector p =
        c.kind == ConstraintKind::onBodyPlane ? Vector(supportPoint + c.radius * n) : bodyPoint;
    const Vector q =
        c.kind == ConstraintKind::onSupportPlane ? Vector(bodyPoint - c.radius * n) : supportPoint;
    const Vector speed = body.state.velocityAt(p) - support.state.velocityAt(q);
    const Vector turning = normalRate(c, n, body.state, support.state);
    corner.rate =
        n.dot(body.state.velocityAt(corner.point) - support.state.velocityAt(corner.point));
    corner.gap = onPlane ? n.dot(bodyPoint - supportPoint) - c.radius : touch.gap;
    corner.extra =
        n.dot(centripetal(body.state, p) - accelerationAt(support, q)) + 2 * turning.dot(speed);
    if (onPlane) {
        corner.extra -= c.radius * turning.squaredNorm();
    } else if (c.kind != ConstraintKind::edgeOnEdge) {
        Vector across = speed - n * n.dot(speed);
        if (c.kind == ConstraintKind::roundOnLine) {
            const Vector edge = support.state.attitude * c.supportEdge;
            across -= edge * edge.dot(across);
        }
        corner.extra += across.squaredNorm() / c.radius;
    }
}

} // namespace simulation
