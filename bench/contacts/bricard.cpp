#include "bricard.h"

#include "extrapolation.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace bench::contacts {
namespace {

using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;

constexpr std::size_t rods = 5;

Vector vector(const Place& place) { return {place[0], place[1], place[2]}; }

// A rod, and the hinge at its far end. Velocities are per rate of motion along the curve of u and
// w, accelerations are those of an even motion along it.
struct Rod {
    Matrix attitude;
    Vector at, velocity, acceleration;
    Vector end, endVelocity, endAcceleration;
    Vector spin, spinRate;
};

std::array<Rod, rods> rodsAt(Real u, Real w) {
    const Real su = std::sin(u), cu = std::cos(u), sw = std::sin(w), cw = std::cos(w);
    // Of sin u + sin w + sin u sin w, which stays 0.
    const Real du = cu * (1 + sw), dw = cw * (1 + su), duu = -su * (1 + sw), dww = -sw * (1 + su),
               duw = cu * cw;
    const std::array<Real, 2> angle{u, w}, rate{dw, -du},
        bend{duw * dw - dww * du, duw * du - duu * dw};
    std::array<Rod, rods> all;
    Rod before;
    before.attitude.setIdentity();
    for (Vector* v : {&before.end, &before.endVelocity, &before.endAcceleration, &before.spin,
                      &before.spinRate})
        v->setZero();
    for (std::size_t i = 0; i < rods; ++i) {
        const std::size_t which = i % 2;
        const Vector own = vector(Bricard::axes[i]), axis = before.attitude * own;
        Rod& rod = all[i];
        rod.attitude = before.attitude * Eigen::AngleAxis<Real>(angle[which], own);
        rod.spin = before.spin + rate[which] * axis;
        rod.spinRate =
            before.spinRate + bend[which] * axis + before.spin.cross(Vector(rate[which] * axis));
        const Vector arm =
            rod.attitude * (vector(Bricard::hinges[i + 1]) - vector(Bricard::hinges[i]));
        const Vector turned = rod.spin.cross(arm);
        const Vector bent = rod.spinRate.cross(arm) + rod.spin.cross(turned);
        rod.at = before.end + arm / 2;
        rod.velocity = before.endVelocity + turned / 2;
        rod.acceleration = before.endAcceleration + bent / 2;
        rod.end = before.end + arm;
        rod.endVelocity = before.endVelocity + turned;
        rod.endAcceleration = before.endAcceleration + bent;
        before = rod;
    }
    return all;
}

// u, w and the rate.
void slopeOf(const std::vector<Real>& y, std::vector<Real>& slope) {
    const Real u = y[0], w = y[1], rate = y[2];
    Real mass = 0, force = 0;
    const std::array<Rod, rods> all = rodsAt(u, w);
    for (std::size_t i = 0; i < rods; ++i) {
        const Rod& rod = all[i];
        const Vector edges = vector(Bricard::edges(i));
        const Vector squares = edges.cwiseProduct(edges);
        const Vector moments =
            (Vector::Constant(squares.sum()) - squares) / 12; // of a box of mass 1
        const Matrix inertia = rod.attitude * moments.asDiagonal() * rod.attitude.transpose();
        const Vector momentum = inertia * rod.spin;
        const Vector couple = inertia * rod.spinRate + rod.spin.cross(momentum);
        mass += rod.velocity.squaredNorm() + rod.spin.dot(momentum);
        force -= Real(standardGravity) * rod.velocity.y() +
                 rate * rate * (rod.velocity.dot(rod.acceleration) + rod.spin.dot(couple));
    }
    slope = {rate * std::cos(w) * (1 + std::sin(u)), -rate * std::cos(u) * (1 + std::sin(w)),
             force / mass};
}

} // namespace

Place Bricard::centre(std::size_t rod) {
    Place at{};
    for (std::size_t a = 0; a < 3; ++a)
        at[a] = (hinges[rod][a] + hinges[rod + 1][a]) / 2;
    return at;
}

Place Bricard::edges(std::size_t rod) {
    Place size{};
    for (std::size_t a = 0; a < 3; ++a)
        size[a] = std::max(thickness, std::abs(hinges[rod + 1][a] - hinges[rod][a]));
    return size;
}

std::vector<std::vector<Place>> Bricard::places(const std::vector<double>& times) {
    std::vector<std::vector<Place>> all;
    for (const std::vector<Real>& state : along(slopeOf, {0, 0, 0}, 0.01L, times)) {
        std::vector<Place> now;
        for (const Rod& rod : rodsAt(state[0], state[1]))
            now.push_back({static_cast<double>(rod.at.x()), static_cast<double>(rod.at.y()),
                           static_cast<double>(rod.at.z())});
        all.push_back(std::move(now));
    }
    return all;
}

double Bricard::halfSwing() {
    std::vector<Real> state = {0, 0, 0};
    Real now = 0.01L;
    extrapolate(slopeOf, now, state);
    const Real way = state[2] > 0 ? 1 : -1;
    const auto event = [&](const std::vector<Real>& y) { return way * y[2]; };
    while (event(state) > 0)
        now += extrapolateUntil(slopeOf, 0.01L, state, event);
    return static_cast<double>(now);
}

double Bricard::gap(double u) {
    const Real w = std::asin(-std::sin(Real(u)) / (1 + std::sin(Real(u))));
    const Rod last = rodsAt(u, w).back();
    return static_cast<double>((last.end - vector(hinges.back())).norm() +
                               (last.attitude * vector(axes.back()) - vector(axes.back())).norm());
}

} // namespace bench::contacts
