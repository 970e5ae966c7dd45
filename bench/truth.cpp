#include "truth.h"

#include "equations.h"

#include <limits>

namespace bench {
namespace {

template <class Equations> RodSamples centresAlong(const Equations& equations, int stepsPerSample) {
    auto state = Equations::start();
    RodSamples samples;
    for (int i = 0; i < s2Samples; ++i) {
        for (int s = 0; s < stepsPerSample; ++s)
            gbsStep<8>(equations, 0.5L / stepsPerSample, state);
        double out[4];
        Equations::centres(state, out);
        samples.push_back({out[0], out[1], out[2], out[3]});
    }
    return samples;
}

} // namespace

std::array<double, 4> s1Attitude() {
    const FreeBody<long double> body;
    auto state = FreeBody<long double>::start();
    for (int i = 0; i < 240; ++i)
        gbsStep<8>(body, 0.25L, state);
    std::array<double, 4> attitude{};
    for (std::size_t i = 0; i < 4; ++i)
        attitude[i] = static_cast<double>(state[i]);
    return attitude;
}

double s1Error(const std::array<double, 4>& attitude) {
    static const std::array<double, 4> right = s1Attitude();
    // The sine of half the angle is the length of the vector part of right* attitude.
    const auto& a = right;
    const auto& b = attitude;
    const double x = a[0] * b[1] - a[1] * b[0] - a[2] * b[3] + a[3] * b[2];
    const double y = a[0] * b[2] - a[2] * b[0] - a[3] * b[1] + a[1] * b[3];
    const double z = a[0] * b[3] - a[3] * b[0] - a[1] * b[2] + a[2] * b[1];
    const double w = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    return 2 * std::atan2(std::hypot(x, y, z), std::abs(w));
}

RodSamples s2aCentres() { return centresAlong(PlanarRods<long double>{}, 100); }
RodSamples s2bCentres() { return centresAlong(MinimalRods<long double>{}, 20); }

double rodError(const RodSamples& samples, const RodSamples& right) {
    double worst = samples.size() == right.size() ? 0 : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < std::min(samples.size(), right.size()); ++i)
        for (std::size_t rod = 0; rod < 2; ++rod) {
            const double d = std::hypot(samples[i][2 * rod] - right[i][2 * rod],
                                        samples[i][2 * rod + 1] - right[i][2 * rod + 1]);
            if (!(d <= worst)) // what is not a number stays
                worst = d;
        }
    return worst;
}

std::vector<double> s3Angles(int count, double ratio) {
    std::vector<double> angles;
    for (int p = 0; p < count; ++p) {
        const long double gravity = gravityOf(p, ratio);
        const Pendulum<long double> pendulum{gravity};
        State<long double, 2> state{amplitudeOf(p, count), 0};
        const int steps = static_cast<int>(4 * std::sqrt(gravityOf(p, ratio) / 10));
        for (int i = 0; i < s3Samples; ++i) {
            for (int s = 0; s < steps; ++s)
                gbsStep<8>(pendulum, 1.0L / steps, state);
            angles.push_back(static_cast<double>(state[0]));
        }
    }
    return angles;
}

double worstDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = a.size() == b.size() ? 0 : std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        if (const double d = std::abs(a[i] - b[i]); !(d <= worst))
            worst = d;
    return worst;
}

std::vector<double> s6Times(double tightness) {
    std::vector<double> times;
    for (const double unit : {1.0, 2.0, 4.0})
        if (unit / std::sqrt(tightness) < s6Span)
            times.push_back(unit / std::sqrt(tightness));
    for (int i = 1; i <= 10; ++i)
        times.push_back(0.1 * i);
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
}

std::vector<double> s6Places(double tightness) {
    std::vector<double> places;
    for (const double t : s6Times(tightness))
        places.push_back((1 + std::sqrt(tightness) * t) * std::exp(-std::sqrt(tightness) * t));
    return places;
}

} // namespace bench
