#include "integrators/error_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

ErrorControl::ErrorControl(std::vector<UnknownScale> scales, double tolerance)
    : scales_(std::move(scales)), seen_(scales_.size()), weights_(scales_.size()),
      tolerance_(tolerance) {
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const auto& [kind, length, extent] = scales_[i];
        leastExtent_ = std::max(leastExtent_, extent);
        (kind == UnknownScale::Kind::position   ? positions_
         : kind == UnknownScale::Kind::velocity ? velocities_
                                                : others_)
            .push_back({i, length});
    }
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
    const auto seen = [&](std::size_t i) {
        const Seen before = any_ ? seen_[i] : Seen{y[i], y[i]};
        const Seen now = {std::min(before.low, y[i]), std::max(before.high, y[i])};
        if constexpr (Observes)
            seen_[i] = now;
        return now;
    };
    double extent = leastExtent_, speed = 0, other = 0;
    for (const auto& [i, length] : positions_) {
        const auto [low, high] = seen(i);
        extent = std::max(extent, length * (high - low));
    }
    for (const auto& [i, length] : velocities_) {
        const auto [low, high] = seen(i);
        speed = std::max(speed, length * std::max(high, -low));
    }
    for (const auto& [i, length] : others_) {
        const auto [low, high] = seen(i);
        other = std::max(std::max(other, high), -low);
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

namespace {

// By the lengths of unknowns one after another, of which most are the same; a division takes long.
class Quotient {
public:
    explicit Quotient(double value) : value_(value), quotient_(value) {}
    [[nodiscard]] double over(double length) {
        if (length != length_) {
            length_ = length;
            quotient_ = value_ / length;
        }
        return quotient_;
    }

private:
    double value_, length_ = 1, quotient_;
};

} // namespace

void ErrorControl::prepare(std::span<const double> y, double h) {
    constexpr double rounding = units * std::numeric_limits<double>::epsilon();
    measure<false>(y);
    step_ = h;
    double coarsest = 0; // rounding of the position farthest from the origin
    for (const auto& [i, length] : positions_)
        coarsest = std::max(coarsest, rounding * std::abs(y[i]) * length);
    rounding_ = coarsest / units;
    // A speed that does not show within the step.
    constexpr double shortest = std::numeric_limits<double>::min();
    Quotient place(tolerance_ * extent_), speed(tolerance_ * speed_);
    Quotient unseen(std::max(0.01 * tolerance_ * extent_ / std::max({h, duration_, shortest}),
                             coarsest / std::max(h, shortest)));
    const auto rounded = [&](std::size_t i) { return std::max(rounding * std::abs(y[i]), 1e-280); };
    for (const auto& [i, length] : positions_)
        weights_[i] = std::max(rounded(i), place.over(length));
    for (const auto& [i, length] : velocities_)
        weights_[i] = std::max(std::max(rounded(i), speed.over(length)), unseen.over(length));
    const double all = tolerance_ * 1e-3 * other_;
    for (const auto& [i, length] : others_) {
        const auto [low, high] = seen_[i];
        const double own =
            std::max(std::max(tolerance_ * high, -tolerance_ * low), tolerance_ * std::abs(y[i]));
        const double weight = std::max(std::max(rounded(i), own), all);
        weights_[i] = length > 0 ? std::max(weight, unseen.over(length)) : weight;
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
