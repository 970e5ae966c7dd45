// What is right, and how far from it a run is. By extrapolation of order 16 in long double, with
// steps so short that halving them changes nothing above 1e-13; S6 by its formula.
#pragma once

#include <array>
#include <vector>

namespace bench {

// S1: the attitude after 60 s.
[[nodiscard]] std::array<double, 4> s1Attitude();
// The angle between this attitude and the right one.
[[nodiscard]] double s1Error(const std::array<double, 4>& attitude);

// S2: x, y of the first rod's centre and of the second's, at 0.5, 1, ..., 5 s.
inline constexpr int s2Samples = 10;
using RodSamples = std::vector<std::array<double, 4>>;
[[nodiscard]] RodSamples s2aCentres();
[[nodiscard]] RodSamples s2bCentres();
// Worst distance of a centre from where it should be.
[[nodiscard]] double rodError(const RodSamples& samples, const RodSamples& right);

// S3: angles of all pendulums at 1, 2, ..., 10 s, one after the other.
inline constexpr int s3Samples = 10;
[[nodiscard]] std::vector<double> s3Angles(int count, double ratio);
// Worst difference; lengths are 1, so that this is a length.
[[nodiscard]] double worstDifference(const std::vector<double>& a, const std::vector<double>& b);

// S6: the place at the times sampled, from 1 at rest: (1 + w t) exp(-w t), w = sqrt(k).
[[nodiscard]] std::vector<double> s6Times(double tightness);
[[nodiscard]] std::vector<double> s6Places(double tightness);

} // namespace bench
