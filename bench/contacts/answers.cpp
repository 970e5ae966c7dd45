#include "answers.h"

#include "extrapolation.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace bench::contacts {
namespace {

using Vector = std::array<Real, 2>;

struct Matrix {
    Real xx = 0, xy = 0, yy = 0; // symmetric
};
Vector operator*(const Matrix& m, const Vector& v) {
    return {m.xx * v[0] + m.xy * v[1], m.xy * v[0] + m.yy * v[1]};
}
Matrix inverse(const Matrix& m) {
    const Real d = m.xx * m.yy - m.xy * m.xy;
    return {m.yy / d, -m.xy / d, m.xx / d};
}
// a m a, with symmetric a and m.
Matrix around(const Matrix& a, const Matrix& m) {
    const Vector first = a * (m * Vector{a.xx, a.xy}), second = a * (m * Vector{a.xy, a.yy});
    return {first[0], first[1], second[1]};
}

// Angles of the rods, then their rates. The forces in the hinges follow from a symmetric system of
// two unknowns for each hinge, and each hinge meets its neighbours only.
struct Chain {
    static constexpr Real length = 1, mass = 1, depth = 0.1L;
    static constexpr Real inertia = mass / 12 * (length * length + depth * depth);

    std::size_t count;

    void operator()(const std::vector<Real>& y, std::vector<Real>& slope) const {
        constexpr Real e = 1 / mass, c = length * length / (4 * inertia);
        std::vector<Vector> along(count), right(count), force(count + 1);
        std::vector<Matrix> turning(count), pivot(count);
        for (std::size_t i = 0; i < count; ++i) {
            along[i] = {std::cos(y[i]), std::sin(y[i])};
            const auto [x, s] = along[i];
            turning[i] = {c * s * s, -c * s * x, c * x * x};
        }
        const auto next = [&](std::size_t i) { // what the force of hinge i + 1 does at hinge i
            return Matrix{turning[i].xx - e, turning[i].xy, turning[i].yy - e};
        };
        for (std::size_t i = 0; i < count; ++i) {
            const auto pull = [&](std::size_t rod) {
                const Real rate = y[count + rod];
                return rate * rate * length / 2;
            };
            pivot[i] = {turning[i].xx + e, turning[i].xy, turning[i].yy + e};
            right[i] = {-pull(i) * along[i][0], -pull(i) * along[i][1]};
            if (i == 0) {
                right[i][1] += Real(standardGravity);
                continue;
            }
            const Matrix &t = turning[i - 1], link = next(i - 1);
            const Matrix above = inverse(pivot[i - 1]), less = around(link, above);
            const Vector known = link * (above * right[i - 1]);
            pivot[i].xx += e + t.xx - less.xx;
            pivot[i].xy += t.xy - less.xy;
            pivot[i].yy += e + t.yy - less.yy;
            for (std::size_t a = 0; a < 2; ++a)
                right[i][a] -= pull(i - 1) * along[i - 1][a] + known[a];
        }
        for (std::size_t i = count; i-- > 0;) {
            const Vector later = next(i) * force[i + 1];
            const Vector rest =
                i + 1 < count ? Vector{right[i][0] - later[0], right[i][1] - later[1]} : right[i];
            force[i] = inverse(pivot[i]) * rest;
        }
        for (std::size_t i = 0; i < count; ++i) {
            const Vector sum = {force[i][0] + force[i + 1][0], force[i][1] + force[i + 1][1]};
            slope[i] = y[count + i];
            slope[count + i] =
                -length / (2 * inertia) * (along[i][0] * sum[1] - along[i][1] * sum[0]);
        }
    }
};

} // namespace

std::vector<double> tippingAngles(double width, double height, double slope,
                                  const std::vector<double>& times) {
    const Real arm = std::hypot(Real(width), Real(height)) / 2;
    const Real pull = Real(standardGravity) * arm /
                      ((Real(width) * width + Real(height) * height) / 12 + arm * arm);
    const auto f = [&](const std::vector<Real>& y, std::vector<Real>& rate) {
        rate[0] = y[1];
        rate[1] = pull * std::sin(y[0]);
    };
    std::vector<double> angles;
    const Real start = slope - std::atan2(Real(width), Real(height));
    for (const auto& state : along(f, {start, 0}, 0.02L, times))
        angles.push_back(static_cast<double>(state[0]));
    return angles;
}

std::vector<std::vector<Place>> chainPlaces(int count, const std::vector<double>& times) {
    const Chain chain{static_cast<std::size_t>(count)};
    std::vector<std::vector<Place>> all;
    for (const auto& state : along(chain, std::vector<Real>(2 * chain.count, 0), 0.02L, times)) {
        Real x = 0, y = 0;
        std::vector<Place> places;
        for (std::size_t i = 0; i < chain.count; ++i) {
            const Real dx = Chain::length / 2 * std::cos(state[i]),
                       dy = Chain::length / 2 * std::sin(state[i]);
            places.push_back({static_cast<double>(x + dx), static_cast<double>(y + dy), 0});
            x += 2 * dx;
            y += 2 * dy;
        }
        all.push_back(std::move(places));
    }
    return all;
}

SliderCrank::Pose SliderCrank::pose(long double crankAngle) const {
    const Real c = std::cos(crankAngle), s = std::sin(crankAngle), a = crank, b = rod;
    Pose pose;
    pose.rodAngle = -std::asin(a / b * s);
    const Real rc = std::cos(pose.rodAngle), rs = std::sin(pose.rodAngle);
    pose.rodRate = -a * c / (b * rc);
    const auto place = [](Real x, Real y) {
        return Place{static_cast<double>(x), static_cast<double>(y), 0};
    };
    pose.at = {place(a / 2 * c, a / 2 * s), place(a * c + b / 2 * rc, a * s + b / 2 * rs),
               place(a * c + b * rc, 0)};
    const Real q = pose.rodRate, rodX = -a * s - b / 2 * rs * q, rodY = a * c + b / 2 * rc * q,
               piston = -a * s - b * rs * q;
    pose.velocity = {place(-a / 2 * s, a / 2 * c), place(rodX, rodY), place(piston, 0)};
    const Real t = thickness;
    pose.inertia = crankMass * ((a * a + t * t) / 12 + a * a / 4) +
                   rodMass * ((b * b + t * t) / 12 * q * q + rodX * rodX + rodY * rodY) +
                   pistonMass * piston * piston;
    return pose;
}

std::vector<std::vector<Place>> SliderCrank::places(const std::vector<double>& times) const {
    const Real twiceEnergy = pose(angle).inertia * rate * rate;
    const auto f = [&](const std::vector<Real>& y, std::vector<Real>& slope) {
        slope[0] = std::sqrt(twiceEnergy / pose(y[0]).inertia);
    };
    std::vector<std::vector<Place>> all;
    for (const auto& state : along(f, {Real(angle)}, 0.002L, times)) {
        const auto at = pose(state[0]).at;
        all.emplace_back(at.begin(), at.end());
    }
    return all;
}

std::vector<std::vector<Place>> SliderCrank::placesHeld(const std::vector<double>& times) const {
    std::vector<std::vector<Place>> all;
    for (const double time : times) {
        const auto at = pose(angle + Real(rate) * time).at;
        all.emplace_back(at.begin(), at.end());
    }
    return all;
}

namespace {

Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1]; }

} // namespace

// Of both coordinates, and the directions in which they move the hub and the trunk.
struct Walker::Mass {
    Vector leg, trunk;
    Matrix matrix;
};

Walker::Mass Walker::mass(Real legAngle, Real trunkAngle) const {
    Mass found;
    found.leg = {-(leg * std::cos(legAngle) + foot), -leg * std::sin(legAngle)};
    found.trunk = {hang * std::cos(trunkAngle), hang * std::sin(trunkAngle)};
    const Real wheel = wheelMass * (Real(2) / 5 * foot * foot + Real(leg) * leg),
               box = Real(trunkMass) * trunk * trunk / 6, all = Real(wheelMass) + trunkMass;
    found.matrix = {wheel + all * dot(found.leg, found.leg),
                    trunkMass * dot(found.leg, found.trunk),
                    box + trunkMass * dot(found.trunk, found.trunk)};
    return found;
}

Walker::Pair Walker::accelerations(const std::vector<Real>& state) const {
    const auto [a, b, legRate, trunkRate] = std::tuple{state[0], state[1], state[2], state[3]};
    const Mass m = mass(a, b);
    const Vector legTurns = {leg * std::sin(a) * legRate * legRate,
                             -leg * std::cos(a) * legRate * legRate},
                 trunkTurns = {-hang * std::sin(b) * trunkRate * trunkRate,
                               hang * std::cos(b) * trunkRate * trunkRate};
    Vector ofTrunk, ofAll; // forces, without the accelerations of the coordinates
    for (std::size_t i = 0; i < 2; ++i) {
        const Real weight = i == 1 ? Real(standardGravity) : 0;
        ofTrunk[i] = trunkMass * (legTurns[i] + trunkTurns[i] + weight);
        ofAll[i] = ofTrunk[i] + wheelMass * (legTurns[i] + weight);
    }
    return inverse(m.matrix) * Vector{-couple - dot(m.leg, ofAll), couple - dot(m.trunk, ofTrunk)};
}

// The impulse of the new foot changes neither the momentum about it of all nor the trunk's about
// the hub.
std::vector<Real> Walker::landed(const std::vector<Real>& state) const {
    const Real next = state[0] + 2 * std::numbers::pi_v<Real> / legs;
    const Mass before = mass(state[0], state[1]), after = mass(next, state[1]);
    const Real wheel = wheelMass * (Real(2) / 5 * foot * foot + Real(leg) * leg),
               box = Real(trunkMass) * trunk * trunk / 6;
    Vector ofTrunk, ofAll;
    for (std::size_t i = 0; i < 2; ++i) {
        const Real hub = before.leg[i] * state[2];
        ofTrunk[i] = trunkMass * (hub + before.trunk[i] * state[3]);
        ofAll[i] = ofTrunk[i] + wheelMass * hub;
    }
    const Vector rates = inverse(after.matrix) * Vector{wheel * state[2] + dot(after.leg, ofAll),
                                                        box * state[3] + dot(after.trunk, ofTrunk)};
    return {next, state[1], rates[0], rates[1]};
}

std::vector<std::vector<Place>> Walker::places(const std::vector<double>& times) const {
    const auto f = [&](const std::vector<Real>& y, std::vector<Real>& slope) {
        const Pair rates = accelerations(y);
        slope = {y[2], y[3], rates[0], rates[1]};
    };
    constexpr Real longest = 0.01L;
    const Real lands = -std::numbers::pi_v<Real> / legs;
    std::vector<Real> y = {0, 0, rate, 0};
    Real now = 0, stands = 0; // `stands`: where the hub is with this leg straight down
    std::vector<std::vector<Place>> all;
    const auto hub = [&] { return stands - foot * y[0] - leg * std::sin(y[0]); };
    for (const double time : times) {
        while (now < time) {
            Real h = std::min(longest, time - now);
            std::vector<Real> end = y;
            extrapolate(f, h, end);
            const bool ends = end[0] <= lands;
            // Newton's method for the instant of landing.
            for (int round = 0; ends && round < 20 && std::abs(end[0] - lands) > 1e-18L; ++round) {
                h -= (end[0] - lands) / end[2];
                end = y;
                extrapolate(f, h, end);
            }
            y = end;
            now += h;
            if (ends) {
                const Real at = hub();
                y = landed(y);
                stands += at - hub();
            }
        }
        const Real x = hub(), height = foot + leg * std::cos(y[0]);
        const auto place = [](Real px, Real py) {
            return Place{static_cast<double>(px), static_cast<double>(py), 0};
        };
        all.push_back(
            {place(x, height), place(x + hang * std::sin(y[1]), height - hang * std::cos(y[1]))});
    }
    return all;
}

} // namespace bench::contacts
