#include "solution/error_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

namespace {

// Most lengths are 1, and a division takes long.
double over(double value, double length) { return length == 1 ? value : value / length; }

} // namespace

ErrorControl::ErrorControl(std::vector<UnknownScale> scales, double tolerance)
    : scales_(std::move(scales)), seen_(scales_.size()), weights_(scales_.size()),
      tolerance_(tolerance) {
    for (const UnknownScale& s : scales_)
        leastExtent_ = std::max(leastExtent_, s.extent);
}

// Hairer and Wanner, Solving ODEs II, IV.8.
double ErrorControl::newtonTolerance() const {
    const double rounding = 10 * std::numeric_limits<double>::epsilon() / tolerance_;
    return std::min(0.03, std::max(rounding, std::sqrt(tolerance_)));
}

void ErrorControl::observe(std::span<const double> y) {
    if (!any_)
        for (std::size_t i = 0; i < y.size(); ++i)
            seen_[i] = {y[i], y[i]};
    any_ = true;
    measure<true>(y);
}

// With what was seen before; that and these are what was seen from now on, if it observes.
template <bool Observes> void ErrorControl::measure(std::span<const double> y) {
    double extent = leastExtent_, speed = 0, other = 0;
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const double low = any_ ? std::min(seen_[i].low, y[i]) : y[i];
        const double high = any_ ? std::max(seen_[i].high, y[i]) : y[i];
        if constexpr (Observes)
            seen_[i] = {low, high};
        const double length = scales_[i].lengthPerUnit;
        if (scales_[i].kind == UnknownScale::Kind::position)
            extent = std::max(extent, length * (high - low));
        else if (scales_[i].kind == UnknownScale::Kind::velocity)
            speed = std::max(speed, length * std::max(high, -low));
        else
            other = std::max({other, high, -low});
    }
    extent_ = extent;
    speed_ = speed;
    other_ = other;
}

double ErrorControl::crossing() const {
    return extent_ > 0 && speed_ > 0 ? extent_ / speed_ : std::numeric_limits<double>::infinity();
}

double ErrorControl::magnitude(std::size_t i) const {
    switch (scales_[i].kind) {
    case UnknownScale::Kind::position:
        return extent_ / scales_[i].lengthPerUnit;
    case UnknownScale::Kind::velocity:
        return speed_ / scales_[i].lengthPerUnit;
    case UnknownScale::Kind::other:
        break;
    }
    return std::max({seen_[i].high, -seen_[i].low, 1e-3 * other_});
}

double ErrorControl::newtonNoise(bool isControlled) const {
    constexpr double most = 0.1, uncontrolled = 8;
    return isControlled ? std::min(noise(), most) : uncontrolled * noise();
}

double ErrorControl::rounding(std::size_t i) const {
    const bool isPosition = scales_[i].kind == UnknownScale::Kind::position;
    return isPosition ? rounding_ / scales_[i].lengthPerUnit : 0;
}

double ErrorControl::displacement(std::span<const double> rates, double h) const {
    double farthest = 0;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const double length = scales_[i].lengthPerUnit, change = h * std::abs(rates[i]);
        double moved = 0;
        if (scales_[i].kind == UnknownScale::Kind::position)
            moved = extent_ > 0 ? change * length / extent_ : 0;
        else if (length > 0)
            moved = extent_ > 0 ? h * change * length / extent_ : 0;
        else
            moved = magnitude(i) > 0 ? change / magnitude(i) : 0;
        if (!(moved <= farthest))
            farthest = std::isnan(moved) ? std::numeric_limits<double>::infinity() : moved;
    }
    return farthest;
}

void ErrorControl::prepare(std::span<const double> y, double h) {
    constexpr double rounding = units * std::numeric_limits<double>::epsilon();
    measure<false>(y);
    step_ = h;
    double coarsest = 0; // rounding of the position farthest from the origin
    for (std::size_t i = 0; i < scales_.size(); ++i)
        if (scales_[i].kind == UnknownScale::Kind::position)
            coarsest = std::max(coarsest, rounding * std::abs(y[i]) * scales_[i].lengthPerUnit);
    rounding_ = coarsest / units;
    const double place = tolerance_ * extent_, speed = tolerance_ * speed_;
    // A speed that does not show within the step.
    constexpr double shortest = std::numeric_limits<double>::min();
    const double unseen = std::max(0.01 * tolerance_ * extent_ / std::max({h, duration_, shortest}),
                                   coarsest / std::max(h, shortest));
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const double length = scales_[i].lengthPerUnit;
        double weight = std::max(rounding * std::abs(y[i]), 1e-280);
        if (scales_[i].kind == UnknownScale::Kind::position)
            weight = std::max(weight, over(place, length));
        else if (scales_[i].kind == UnknownScale::Kind::velocity)
            weight = std::max({weight, over(speed, length), over(unseen, length)});
        else
            weight = std::max({weight, tolerance_ * seen_[i].high, -tolerance_ * seen_[i].low,
                               tolerance_ * std::abs(y[i]), tolerance_ * 1e-3 * other_,
                               length > 0 ? over(unseen, length) : 0});
        weights_[i] = weight;
    }
}

// Rounding of a position moves a stiff end as far, and its velocity by that over the step.
double ErrorControl::noise() const {
    const double rounding = units * rounding_;
    double noise = 0;
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const double length = scales_[i].lengthPerUnit;
        if (scales_[i].kind == UnknownScale::Kind::position)
            noise = std::max(noise, rounding / length / weights_[i]);
        else if (length > 0)
            noise = std::max(noise, rounding / length / step_ / weights_[i]);
    }
    return noise;
}

double ErrorControl::norm(std::span<const double> error) const {
    double largest = 0;
    for (std::size_t i = 0; i < error.size(); ++i) {
        const double e = std::abs(error[i]) / weights_[i];
        if (!(e <= largest)) // a NaN stays
            largest = e;
        if (std::isnan(largest))
            return std::numeric_limits<double>::infinity();
    }
    return largest;
}

} // namespace solution
