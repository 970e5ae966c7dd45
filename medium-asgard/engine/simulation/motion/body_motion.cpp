#include "motion/body_motion.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace simulation {
namespace {

using physics::BodyUnknown;
using solution::Histories;

double valueOf(const Histories& histories, std::size_t unknown, double t, Side side) {
    return side == Side::after ? histories.value(unknown, t)
                               : histories.pieceBefore(unknown, t).value(t);
}

Vector valuesOf(const BodyRecord& body, BodyUnknown first, const Histories& histories, double t,
                Side side) {
    const std::size_t i = body.firstUnknown + first;
    return {valueOf(histories, i, t, side), valueOf(histories, i + 1, t, side),
            valueOf(histories, i + 2, t, side)};
}

Quaternion attitudeOf(const BodyRecord& body, const Histories& histories, double t, Side side) {
    const std::size_t i = body.firstUnknown + physics::qw;
    return Quaternion(valueOf(histories, i, t, side), valueOf(histories, i + 1, t, side),
                      valueOf(histories, i + 2, t, side), valueOf(histories, i + 3, t, side))
        .normalized();
}

// Coefficients of the piece in powers of r = (t - origin) / scale.
solution::Coefficients inTermsOf(const solution::Piece& piece, double origin, double scale) {
    return solution::reparametrize(piece.coefficients, (origin - piece.origin) / piece.scale,
                                   scale / piece.scale);
}

std::size_t lengthOf(std::span<const solution::Coefficients> columns) {
    std::size_t length = 1;
    for (const solution::Coefficients& column : columns)
        for (std::size_t k = length; k < column.size(); ++k)
            if (column[k] != 0)
                length = k + 1;
    return length;
}

} // namespace

std::vector<BodyRecord> recordsOf(const physics::EquationsOfMotion& equations) {
    std::vector<BodyRecord> records;
    for (const physics::BodyMotion& body : equations.bodies)
        records.push_back({.isFixed = body.isFixed,
                           .isSpinInWorldAxes = body.symbols.isSpinInWorldAxes,
                           .start = body.start,
                           .firstUnknown = body.firstUnknown,
                           .mass = body.isFixed ? solution::infinity : body.mass.mass,
                           .radius = body.mass.radius,
                           .arms = body.arms,
                           .centroid = body.mass.centroid});
    for (std::size_t u = physics::bodyUnknowns * equations.set.quaternions.size();
         u < equations.owners.size(); ++u)
        records[equations.owners[u]].more.push_back(u);
    return records;
}

BodyState stateOf(const BodyRecord& body, std::span<const double> values) {
    using namespace physics;
    const auto vectorAt = [&](std::size_t i) {
        return Vector(values[i], values[i + 1], values[i + 2]);
    };
    BodyState state;
    state.position = vectorAt(x);
    state.velocity = vectorAt(dx);
    state.attitude = Quaternion(values[qw], values[qx], values[qy], values[qz]).normalized();
    const Vector spin = vectorAt(w1);
    state.angularVelocity = body.isSpinInWorldAxes ? spin : state.attitude * spin;
    return state;
}

BodyState stateOf(const BodyRecord& body, const Histories& histories, double time, Side side) {
    if (body.isFixed)
        return {.position = body.start.position, .attitude = body.start.attitude};
    BodyState state;
    state.position = valuesOf(body, physics::x, histories, time, side);
    state.velocity = valuesOf(body, physics::dx, histories, time, side);
    state.attitude = attitudeOf(body, histories, time, side);
    const Vector spin = valuesOf(body, physics::w1, histories, time, side);
    state.angularVelocity = body.isSpinInWorldAxes ? spin : state.attitude * spin;
    return state;
}

double knownUntil(const BodyRecord& body, const Histories& histories) {
    double until = solution::infinity;
    if (!body.isFixed)
        for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
            until = std::min(until, histories.reached(body.firstUnknown + i));
    return until;
}

std::optional<double> endOf(const BodyRecord& body, const Histories& histories,
                            std::size_t unknowns) {
    std::optional<double> end;
    for (std::size_t i = 0; i < unknowns && !body.isFixed; ++i)
        if (const auto* stop = histories.stop(body.firstUnknown + i);
            stop && !(end && *end <= stop->time))
            end = stop->time;
    return end;
}

Acceleration accelerationOf(const BodyRecord& body, const Histories& histories, double time) {
    if (body.isFixed)
        return {};
    const auto derivatives = [&](BodyUnknown first) {
        const std::size_t i = body.firstUnknown + first;
        return Vector(histories.derivative(i, time), histories.derivative(i + 1, time),
                      histories.derivative(i + 2, time));
    };
    const Vector spinRate = derivatives(physics::w1);
    // Along the body's axes too, dw/dt is the vector's own rate: w x w = 0.
    const Vector angular = body.isSpinInWorldAxes
                               ? spinRate
                               : attitudeOf(body, histories, time, Side::after) * spinRate;
    return {derivatives(physics::dx), angular};
}

void MovingBody::read(const Histories& histories) {
    histories_ = &histories;
    forget();
}

void MovingBody::standAt(const geometry::Pose& centre) {
    record_.isFixed = true;
    record_.start = centre;
    forget();
}

const collision::MotionPiece& MovingBody::pieceAt(double t) const {
    if (!piece_ || isContinued_ || (!record_.isFixed && (t < piece_->from || t >= piece_->until)))
        piece_ = solvedPiece(t);
    return *piece_;
}

collision::MotionPiece MovingBody::solvedPiece(double t) const {
    const Quaternion& q = record_.start.attitude;
    const Eigen::Vector4d atStart(q.w(), q.x(), q.y(), q.z());
    if (record_.isFixed)
        return {.from = 0,
                .until = solution::infinity,
                .scale = 1,
                .position = {record_.start.position},
                .attitude = {atStart}};
    const std::size_t count = isBall_ ? 3 : 7;
    std::array<solution::Piece, 7> pieces;
    double from = -solution::infinity, until = solution::infinity;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t which = i < 3 ? physics::x + i : physics::qw + (i - 3);
        pieces[i] = histories_->piece(record_.firstUnknown + which, t);
        from = std::max(from, pieces[i].origin);
        until = std::min(until, pieces[i].until);
    }
    // A piece continued beyond its end (the last known one) holds from there on.
    from = std::min(from, t);
    isContinued_ = until <= t;
    if (isContinued_)
        until = solution::infinity;
    const double scale = std::isfinite(until) ? until - from : 1;
    std::array<solution::Coefficients, 7> columns;
    for (std::size_t i = 0; i < count; ++i)
        columns[i] = inTermsOf(pieces[i], from, scale);
    collision::MotionPiece piece{
        .from = from, .until = until, .scale = scale, .position = {}, .attitude = {}};
    for (std::size_t k = 0; k < lengthOf(std::span(columns).first(3)); ++k)
        piece.position.emplace_back(columns[0][k], columns[1][k], columns[2][k]);
    if (isBall_)
        piece.attitude = {atStart};
    for (std::size_t k = 0; !isBall_ && k < lengthOf(std::span(columns).subspan(3)); ++k)
        piece.attitude.emplace_back(columns[3][k], columns[4][k], columns[5][k], columns[6][k]);
    return piece;
}

} // namespace simulation
