#include "contacts/bearing_rates.h"

#include <cmath>

namespace simulation {
namespace {

using physics::GapConstraint;
using physics::GapRow;
using ConstraintKind = physics::GapConstraint::Kind;

struct Contact { // world
    Vector normal = Vector::UnitX();
    Vector onBody = Vector::Zero(), onSupport = Vector::Zero(); // material points
    double gap = 0;
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
    case ConstraintKind::onSupportPlane: {
        const Vector normal = support.attitude * c.normal;
        return {.normal = normal,
                .onBody = p,
                .onSupport = p - c.radius * normal,
                .gap = normal.dot(p - q) - c.radius};
    }
    case ConstraintKind::onBodyPlane: {
        const Vector normal = body.attitude * c.normal;
        return {.normal = normal,
                .onBody = q + c.radius * normal,
                .onSupport = q,
                .gap = normal.dot(p - q) - c.radius};
    }
    case ConstraintKind::roundOnLine: {
        const Vector foot = q + along(p - q, edge);
        return {.normal = (p - foot).normalized(),
                .onBody = p,
                .onSupport = foot,
                .gap = (p - foot).norm() - c.radius};
    }
    case ConstraintKind::edgeOnEdge: {
        const Vector own = body.attitude * c.bodyEdge;
        const Vector across = own.cross(edge).normalized();
        const Vector place = crossingOf(p, own, q, edge);
        return {
            .normal = c.flipped ? Vector(-across) : across, .onBody = place, .onSupport = place};
    }
    default:
        return {.normal = (p - q).normalized(),
                .onBody = p,
                .onSupport = q,
                .gap = (p - q).norm() - c.radius};
    }
}

Vector inWorld(const Vector& turning, const physics::BodyMotion& motion, const BodyState& state) {
    return motion.symbols.isSpinInWorldAxes ? turning : Vector(state.attitude * turning);
}

} // namespace

BearingRow bearingRow(const GapConstraint& constraint, const BodyRecord& record,
                      const BodyState& body, const BodyState& support) {
    BearingRow row;
    Vector turning;
    if (constraint.kind == ConstraintKind::tilt) {
        turning = body.attitude * constraint.bodyEdge;
        row.rates.rate = turning.dot(body.angularVelocity);
        const Vector normal = support.attitude * constraint.normal;
        row.gap = normal.dot(body.attitude * constraint.inPlane);
    } else {
        const Contact contact = contactOf(constraint, body, support);
        row.rates.linear = contact.normal;
        turning = (contact.onBody - body.position).cross(contact.normal);
        row.rates.rate = contact.normal.dot(body.velocityAt(contact.onBody) -
                                            support.velocityAt(contact.onSupport));
        row.gap = contact.gap;
    }
    row.rates.angular =
        record.isSpinInWorldAxes ? turning : Vector(body.attitude.conjugate() * turning);
    return row;
}

BodyState bearingExactly(const BodyState& state, const physics::BodyMotion& motion,
                         const physics::Held& held, std::span<const BearingRow> rows) {
    std::vector<GapRow> all;
    for (const BearingRow& row : rows)
        all.push_back(row.rates);
    std::vector<GapRow> rates, gaps;
    for (const std::size_t i : physics::independentOf(motion, held, all)) {
        rates.push_back(all[i]);
        gaps.push_back(all[i]);
        gaps.back().rate = rows[i].gap;
    }
    const physics::VelocityChange speed = physics::changeToRates(motion, held, rates);
    const physics::VelocityChange place = physics::changeToRates(motion, held, gaps);
    BodyState exact = state;
    exact.velocity += withoutRounding(speed.linear);
    exact.angularVelocity += withoutRounding(inWorld(speed.angular, motion, state));
    exact.position += withoutRounding(place.linear);
    const Vector turn = withoutRounding(inWorld(place.angular, motion, state));
    if (!turn.isZero(0))
        exact.attitude = turnedBy(state.attitude, turn);
    return exact;
}

Vector withoutRounding(const Vector& v) {
    constexpr double rounding = 1e-9;
    return v.unaryExpr([least = rounding * v.cwiseAbs().maxCoeff()](double x) {
        return std::abs(x) <= least ? 0 : x;
    });
}

Quaternion turnedBy(const Quaternion& attitude, const Vector& turn) {
    const Quaternion rotation(1, turn.x() / 2, turn.y() / 2, turn.z() / 2);
    return (rotation * attitude).normalized();
}

} // namespace simulation
