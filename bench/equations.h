// The scenes that all programs run, as somebody would write them who writes a program for that
// scene only. The constants here are the scenes' definition.
//
//   S1   free body, principal inertias 1, 2, 3, angular velocity (0.01, 1, 0), 60 s
//   S2   two rods of 10 x 1.1 x 1.1 and mass 10 under gravity 10, one after the other from the
//   origin
//        along -x and let go level, 5 s: S2a on soft links, S2b on exact pins
//   S3   N pendulums of length 1, amplitudes 0.5 to 1.5 rad, gravity 10, the first one's times
//        ratio^2, 10 s
//   S4   512 elastic balls in a box, 10 s (gas.h)
//   S5   Galperin's billiard (billiard.h)
//   S6   a mass on a critically damped link, 1 s
#pragma once

#include "integrators.h"

namespace bench {

// Not std::numbers: Simbody's headers are not C++20, nor is its driver.
template <class Real> inline constexpr Real pi = Real(3.141592653589793238462643383279502884L);

inline constexpr double s1Span = 60, s2Span = 5, s3Span = 10, s4Span = 10, s6Span = 1;
// S5: a little more than up to the last hit, for n = 0, 1, ...
inline constexpr double s5Spans[] = {3.5, 4.5, 8.5, 4, 3.5};

// Euler's equations and the quaternion's: w, x, y, z and the angular velocity in body axes.
template <class Real> struct FreeBody {
    static constexpr std::size_t n = 7;
    static State<Real, n> start() { return {1, 0, 0, 0, Real(1) / 100, 1, 0}; }
    void operator()(const State<Real, n>& s, State<Real, n>& d) const {
        const Real w = s[0], x = s[1], y = s[2], z = s[3], p = s[4] / 2, q = s[5] / 2, r = s[6] / 2;
        d[0] = -(x * p + y * q + z * r);
        d[1] = w * p + y * r - z * q;
        d[2] = w * q + z * p - x * r;
        d[3] = w * r + x * q - y * p;
        d[4] = -s[5] * s[6];           // (2 - 3) / 1
        d[5] = s[6] * s[4];            // (3 - 1) / 2
        d[6] = -s[4] * s[5] / Real(3); // (1 - 2) / 3
    }
};

namespace rods {
inline constexpr double mass = 10, half = 5, gravity = 10, tightness = 5000;
inline constexpr double inertia = mass / 12 * (100 + 1.1 * 1.1);
} // namespace rods

// S2a in the plane that it stays in: x, y, angle of both rods, then their rates.
// At the first rod's right end F = -k d - c v towards the origin; its left end and the second's
// right end pull each other by the same law.
template <class Real> struct PlanarRods {
    static constexpr std::size_t n = 12;
    Real damping = 2 * std::sqrt(Real(rods::tightness) * Real(rods::mass));

    static State<Real, n> start() { return {-5, 0, 0, -15, 0, 0, 0, 0, 0, 0, 0, 0}; }
    void operator()(const State<Real, n>& s, State<Real, n>& d) const {
        constexpr Real k = rods::tightness, m = rods::mass;
        const Real c1 = rods::half * std::cos(s[2]), s1 = rods::half * std::sin(s[2]);
        const Real c2 = rods::half * std::cos(s[5]), s2 = rods::half * std::sin(s[5]);
        const Real fx = -k * (s[0] + c1) - damping * (s[6] - s1 * s[8]);
        const Real fy = -k * (s[1] + s1) - damping * (s[7] + c1 * s[8]);
        const Real gx =
            -k * (s[0] - c1 - s[3] - c2) - damping * (s[6] + s1 * s[8] - s[9] + s2 * s[11]);
        const Real gy =
            -k * (s[1] - s1 - s[4] - s2) - damping * (s[7] - c1 * s[8] - s[10] - c2 * s[11]);
        for (std::size_t i = 0; i < 6; ++i)
            d[i] = s[i + 6];
        d[6] = (fx + gx) / m;
        d[7] = (fy + gy) / m - rods::gravity;
        d[8] = (c1 * (fy - gy) - s1 * (fx - gx)) / Real(rods::inertia);
        d[9] = -gx / m;
        d[10] = -gy / m - rods::gravity;
        d[11] = (-c2 * gy + s2 * gx) / Real(rods::inertia);
    }
    // Centres of both rods.
    static void centres(const State<Real, n>& s, double (&out)[4]) {
        for (int i = 0; i < 2; ++i) {
            out[2 * i] = static_cast<double>(s[static_cast<std::size_t>(3 * i)]);
            out[2 * i + 1] = static_cast<double>(s[static_cast<std::size_t>(3 * i + 1)]);
        }
    }
};

// S2b in minimal coordinates: the directions of the rods, seen from their right ends.
template <class Real> struct MinimalRods {
    static constexpr std::size_t n = 4;
    static State<Real, n> start() { return {pi<Real>, pi<Real>, 0, 0}; }
    void operator()(const State<Real, n>& s, State<Real, n>& d) const {
        constexpr Real m = rods::mass, l = rods::half, g = rods::gravity, i = rods::inertia;
        constexpr Real m11 = i + m * l * l + m * 4 * l * l, m22 = i + m * l * l, b = 2 * m * l * l;
        const Real cosine = std::cos(s[0] - s[1]), sine = std::sin(s[0] - s[1]);
        const Real m12 = b * cosine;
        const Real r1 = -b * sine * s[3] * s[3] - 3 * m * l * g * std::cos(s[0]);
        const Real r2 = b * sine * s[2] * s[2] - m * l * g * std::cos(s[1]);
        const Real determinant = m11 * m22 - m12 * m12;
        d[0] = s[2];
        d[1] = s[3];
        d[2] = (m22 * r1 - m12 * r2) / determinant;
        d[3] = (m11 * r2 - m12 * r1) / determinant;
    }
    static void centres(const State<Real, n>& s, double (&out)[4]) {
        const double a = static_cast<double>(s[0]), b = static_cast<double>(s[1]);
        out[0] = rods::half * std::cos(a);
        out[1] = rods::half * std::sin(a);
        out[2] = 2 * out[0] + rods::half * std::cos(b);
        out[3] = 2 * out[1] + rods::half * std::sin(b);
    }
};

template <class Real> struct Pendulum {
    static constexpr std::size_t n = 2;
    Real gravity = 10; // over the length, which is 1
    void operator()(const State<Real, n>& s, State<Real, n>& d) const {
        d[0] = s[1];
        d[1] = -gravity * std::sin(s[0]);
    }
};
inline double amplitudeOf(int pendulum, int count) {
    return 0.5 + static_cast<double>(pendulum) / (count - 1);
}
inline double gravityOf(int pendulum, double ratio) {
    return pendulum == 0 ? 10 * ratio * ratio : 10;
}

} // namespace bench
