#include "physics/surface_gap.h"

#include "physics/surface_nearest.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace surfaces {
namespace {

// A number with its first two rates.
struct Moving {
    double value = 0, rate = 0, second = 0;
};
Moving operator+(const Moving& a, const Moving& b) {
    return {a.value + b.value, a.rate + b.rate, a.second + b.second};
}
Moving operator-(const Moving& a, const Moving& b) {
    return {a.value - b.value, a.rate - b.rate, a.second - b.second};
}
Moving operator*(const Moving& a, const Moving& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate,
            a.second * b.value + 2 * a.rate * b.rate + a.value * b.second};
}
Moving operator/(const Moving& a, const Moving& b) {
    const double value = a.value / b.value, rate = (a.rate - value * b.rate) / b.value;
    return {value, rate, (a.second - 2 * rate * b.rate - value * b.second) / b.value};
}
Moving sqrt(const Moving& a) {
    const double value = std::sqrt(a.value), rate = a.rate / (2 * value);
    return {value, rate, (a.second - 2 * rate * rate) / (2 * value)};
}
Moving like(const Moving& /*a*/, double value) { return {value, 0, 0}; }

Triple<Moving> moving(const Vector& value, const Vector& rate, const Vector& second) {
    return {{value.x(), rate.x(), second.x()},
            {value.y(), rate.y(), second.y()},
            {value.z(), rate.z(), second.z()}};
}

} // namespace
} // namespace surfaces

namespace {

using surfaces::Place;
using surfaces::Triple;

Triple<double> of(const Vector& v) { return {v.x(), v.y(), v.z()}; }
Vector of(const Triple<double>& v) { return {v.x, v.y, v.z}; }

Place<double> of(const SurfacePose& pose) {
    return {of(pose.centre),
            {of(Vector(pose.rotation.row(0))), of(Vector(pose.rotation.row(1))),
             of(Vector(pose.rotation.row(2)))}};
}

Matrix crossing(const Vector& v) {
    Matrix m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Place<surfaces::Moving> of(const SurfaceMotion& motion) {
    const Matrix turns = crossing(motion.spin), &rotation = motion.pose.rotation;
    const Matrix rate = turns * rotation;
    const Matrix second = crossing(motion.spinRate) * rotation + turns * rate;
    Place<surfaces::Moving> place;
    place.centre = surfaces::moving(motion.pose.centre, motion.velocity, motion.acceleration);
    for (int i = 0; i < 3; ++i)
        place.rotation[static_cast<std::size_t>(i)] =
            surfaces::moving(rotation.row(i), rate.row(i), second.row(i));
    return place;
}

} // namespace

bool haveGap(SurfacePiece::Kind body, SurfacePiece::Kind support) {
    using Kind = SurfacePiece::Kind;
    const Kind first = std::min(body, support), second = std::max(body, support);
    if (second == Kind::plane)
        return first == Kind::point || first == Kind::circle || first == Kind::ellipsoid;
    if (first == Kind::point)
        return second != Kind::ellipsoid;
    return second == Kind::line || second == Kind::circle;
}

NearestSurfaces nearest(const SurfaceGap& gap, const SurfacePose& body,
                        const SurfacePose& support) {
    const surfaces::Nearest<double> found = surfaces::nearestOf(gap, of(body), of(support));
    return {found.gap, of(found.normal), of(found.contact), of(found.place), found.steady};
}

SurfaceGap fromSphereIfSteady(const SurfaceGap& gap, const SurfacePose& body,
                              const SurfacePose& support) {
    using Kind = SurfacePiece::Kind;
    if (!gap.hasFeet() || gap.body.kind != Kind::circle || gap.support.kind != Kind::circle)
        return gap;
    const NearestSurfaces feet = nearest(gap, body, support);
    SurfaceGap found = gap;
    double least = HUGE_VAL;
    for (const double branch : {1.0, -1.0}) {
        SurfaceGap other = gap;
        other.branch = branch;
        const NearestSurfaces at = nearest(other, body, support);
        const double away = (at.contact - feet.contact).norm();
        if (at.steady > feet.steady / 2 && away < least)
            found = other, least = away;
    }
    return found;
}

double accelerationOf(const SurfaceGap& gap, const SurfaceMotion& body,
                      const SurfaceMotion& support) {
    return surfaces::nearestOf(gap, of(body), of(support)).gap.second;
}

double NearestSurfaces::nearFoot() const { return std::min(0.2, std::sqrt(steady) / 4); }

double reachBelow(const SurfacePiece& piece, const Vector& normal) {
    return surfaces::lowest(piece, of(SurfacePose{}), of(normal)).reach;
}

} // namespace physics
