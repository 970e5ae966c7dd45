// The explicit methods of the hand-written loops, each written for speed and nothing else: the
// number of unknowns and of columns is known to the compiler, nothing is allocated, no error is
// estimated where a step is given.
//
// A right-hand side is f(y, dy) of arrays of N numbers; time, where it matters, is one of them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace bench {

template <class Real, std::size_t N> using State = std::array<Real, N>;

// Kutta's method of order 4.
template <class Real, std::size_t N, class F>
inline void rk4Step(const F& f, Real h, State<Real, N>& y) {
    State<Real, N> k1, k2, k3, k4, at;
    f(y, k1);
    for (std::size_t i = 0; i < N; ++i)
        at[i] = y[i] + h / 2 * k1[i];
    f(at, k2);
    for (std::size_t i = 0; i < N; ++i)
        at[i] = y[i] + h / 2 * k2[i];
    f(at, k3);
    for (std::size_t i = 0; i < N; ++i)
        at[i] = y[i] + h * k3[i];
    f(at, k4);
    for (std::size_t i = 0; i < N; ++i)
        y[i] += h / 6 * (k1[i] + 2 * (k2[i] + k3[i]) + k4[i]);
}

// Weights of the columns of extrapolation to step 0 in even powers, for 2, 4, 6, ... substeps.
template <class Real, int Columns> constexpr std::array<Real, Columns> extrapolationWeights() {
    std::array<Real, Columns> weights{};
    for (int j = 0; j < Columns; ++j) {
        Real w = 1;
        for (int i = 0; i < Columns; ++i)
            if (i != j) {
                const Real a = Real(2 * (j + 1)), b = Real(2 * (i + 1));
                w *= a * a / (a * a - b * b);
            }
        weights[static_cast<std::size_t>(j)] = w;
    }
    return weights;
}

// Gragg, Bulirsch, Stoer: the modified midpoint rule with 2, 4, ..., 2 Columns substeps,
// extrapolated. The order is 2 Columns.
template <int Columns, class Real, std::size_t N, class F>
inline void gbsStep(const F& f, Real h, State<Real, N>& y) {
    static constexpr auto weights = extrapolationWeights<Real, Columns>();
    State<Real, N> slope0, slope, before, now, sum{};
    f(y, slope0);
    for (int j = 0; j < Columns; ++j) {
        const int substeps = 2 * (j + 1);
        const Real step = h / Real(substeps);
        for (std::size_t i = 0; i < N; ++i) {
            before[i] = y[i];
            now[i] = y[i] + step * slope0[i];
        }
        for (int m = 1; m < substeps; ++m) {
            f(now, slope);
            for (std::size_t i = 0; i < N; ++i) {
                const Real next = before[i] + 2 * step * slope[i];
                before[i] = now[i];
                now[i] = next;
            }
        }
        for (std::size_t i = 0; i < N; ++i)
            sum[i] += weights[static_cast<std::size_t>(j)] * now[i];
    }
    y = sum;
}

// Dormand and Prince's pair of order 5(4), adaptive; the first slope of a step is the last one of
// the step before.
template <std::size_t N> class Dopri5 {
public:
    Dopri5(double tolerance, double firstStep) : tolerance_(tolerance), h_(firstStep) {}

    template <class F> void advance(const F& f, double span, State<double, N>& y) {
        State<double, N> k2, k3, k4, k5, k6, k7, at, next;
        if (fresh_)
            f(y, k1_);
        fresh_ = false;
        for (double t = 0; t < span;) {
            const bool last = t + h_ >= span;
            const double h = last ? span - t : h_;
            stage(f, y, h, at, k2, {1.0 / 5}, k1_);
            stage(f, y, h, at, k3, {3.0 / 40, 9.0 / 40}, k1_, k2);
            stage(f, y, h, at, k4, {44.0 / 45, -56.0 / 15, 32.0 / 9}, k1_, k2, k3);
            stage(f, y, h, at, k5, {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
                  k1_, k2, k3, k4);
            stage(f, y, h, at, k6,
                  {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656}, k1_,
                  k2, k3, k4, k5);
            stage(f, y, h, next, k7,
                  {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}, k1_, k2,
                  k3, k4, k5, k6);
            double error = 0;
            for (std::size_t i = 0; i < N; ++i) {
                const double e =
                    h * (71.0 / 57600 * k1_[i] - 71.0 / 16695 * k3[i] + 71.0 / 1920 * k4[i] -
                         17253.0 / 339200 * k5[i] + 22.0 / 525 * k6[i] - 1.0 / 40 * k7[i]);
                const double scale = tolerance_ * (1 + std::max(std::abs(y[i]), std::abs(next[i])));
                error += e * e / (scale * scale);
            }
            error = std::sqrt(error / N);
            const double factor = std::clamp(0.9 * std::pow(error + 1e-300, -0.2), 0.2, 5.0);
            if (error <= 1) {
                t = last ? span : t + h;
                y = next;
                k1_ = k7;
            }
            if (error > 1 || !last || factor < 1)
                h_ = h * factor;
        }
    }

private:
    template <class F, std::size_t S, class... K>
    static void stage(const F& f, const State<double, N>& y, double h, State<double, N>& at,
                      State<double, N>& slope, const double (&a)[S], const K&... k) {
        for (std::size_t i = 0; i < N; ++i) {
            std::size_t s = 0;
            double sum = 0;
            ((sum += a[s++] * k[i]), ...);
            at[i] = y[i] + h * sum;
        }
        f(at, slope);
    }

    double tolerance_, h_;
    bool fresh_ = true;
    State<double, N> k1_{};
};

} // namespace bench
