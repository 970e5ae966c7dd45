#include "simulation/bearing_rates.h"

namespace simulation {
namespace {

using physics::GapConstraint;
using physics::GapRow;
using Kind = physics::GapConstraint::Kind;

struct Contact { // world
    Vector normal = Vector::UnitX();
    Vector onBody = Vector::Zero(), onSupport = Vector::Zero(); // material points
};

Vector along(const Vector& v, const Vector& direction) { return direction * direction.dot(v); }

// Where the two lines come nearest, on the first.
Vector crossingOf(const Vector& p, const Vector& a, const Vector& q, const Vector& b) {
    const Vector across = a.cross(b);
    return p + a * ((q - p).cross(b).dot(across) / across.squaredNorm());
}

Contact contactOf(const GapConstraint& c, const BodyState& body, const BodyState& support) {
    const Vector p = body.position + body.attitude * c.bodyPoint;
    const Vector q = support.position + support.attitude * c.supportPoint;
    const Vector edge = support.attitude * c.supportEdge;
    switch (c.kind) {
    case Kind::onSupportPlane: {
        const Vector normal = support.attitude * c.normal;
        return {.normal = normal, .onBody = p, .onSupport = p - c.radius * normal};
    }
    case Kind::onBodyPlane: {
        const Vector normal = body.attitude * c.normal;
        return {.normal = normal, .onBody = q + c.radius * normal, .onSupport = q};
    }
    case Kind::roundOnLine: {
        const Vector foot = q + along(p - q, edge);
        return {.normal = (p - foot).normalized(), .onBody = p, .onSupport = foot};
    }
    case Kind::edgeOnEdge: {
        const Vector own = body.attitude * c.bodyEdge;
        const Vector across = own.cross(edge).normalized();
        const Vector place = crossingOf(p, own, q, edge);
        return {
            .normal = c.flipped ? Vector(-across) : across, .onBody = place, .onSupport = place};
    }
    default:
        return {.normal = (p - q).normalized(), .onBody = p, .onSupport = q};
    }
}

Vector velocityAt(const BodyState& state, const Vector& point) {
    return state.velocity + state.angularVelocity.cross(point - state.position);
}

} // namespace

GapRow bearingRow(const GapConstraint& constraint, const BodyRecord& record, const BodyState& body,
                  const BodyState& support) {
    GapRow row;
    Vector turning;
    if (constraint.kind == Kind::tilt) {
        turning = body.attitude * constraint.bodyEdge;
        row.rate = turning.dot(body.angularVelocity);
    } else {
        const Contact contact = contactOf(constraint, body, support);
        row.linear = contact.normal;
        turning = (contact.onBody - body.position).cross(contact.normal);
        row.rate = contact.normal.dot(velocityAt(body, contact.onBody) -
                                      velocityAt(support, contact.onSupport));
    }
    row.angular = record.isSpinInWorldAxes ? turning : Vector(body.attitude.conjugate() * turning);
    return row;
}

BodyState withoutRates(const BodyState& state, const physics::BodyMotion& motion,
                       bool attitudeIsHeld, std::span<const GapRow> rows) {
    std::vector<GapRow> independent;
    for (const std::size_t i : physics::independentOf(motion, attitudeIsHeld, rows))
        independent.push_back(rows[i]);
    const physics::VelocityChange change =
        physics::changeToRates(motion, attitudeIsHeld, independent);
    BodyState still = state;
    still.velocity += change.linear;
    still.angularVelocity +=
        motion.symbols.isSpinInWorldAxes ? change.angular : Vector(state.attitude * change.angular);
    return still;
}

} // namespace simulation
