#include "solution/error_control.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

ErrorControl::ErrorControl(std::vector<UnknownScale> scales, double tolerance)
    : scales_(std::move(scales)), seen_(scales_.size()), weights_(scales_.size()),
      tolerance_(tolerance) {
    for (const UnknownScale& s : scales_) {
        leastExtent_ = std::max(leastExtent_, s.extent);
        if (s.kind == UnknownScale::Kind::position)
            radius_ = std::max(radius_, s.lengthPerUnit);
    }
}

// Hairer and Wanner, Solving ODEs II, IV.8.
double ErrorControl::newtonTolerance() const {
    const double rounding = 10 * std::numeric_limits<double>::epsilon() / tolerance_;
    return std::min(0.03, std::max(rounding, std::sqrt(tolerance_)));
}

void ErrorControl::observe(std::span<const double> y) {
    for (std::size_t i = 0; i < y.size(); ++i) {
        seen_[i].low = any_ ? std::min(seen_[i].low, y[i]) : y[i];
        seen_[i].high = any_ ? std::max(seen_[i].high, y[i]) : y[i];
    }
    any_ = true;
    measure(y);
}

void ErrorControl::measure(std::span<const double> y) {
    extent_ = leastExtent_;
    speed_ = other_ = 0;
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const double low = any_ ? std::min(seen_[i].low, y[i]) : y[i];
        const double high = any_ ? std::max(seen_[i].high, y[i]) : y[i];
        const double length = scales_[i].lengthPerUnit;
        if (scales_[i].kind == UnknownScale::Kind::position)
            extent_ = std::max(extent_, length * (high - low));
        else if (scales_[i].kind == UnknownScale::Kind::velocity)
            speed_ = std::max(speed_, length * std::max(high, -low));
        else
            other_ = std::max({other_, high, -low});
    }
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

void ErrorControl::prepare(std::span<const double> y, double h) {
    constexpr double rounding = 16 * std::numeric_limits<double>::epsilon();
    measure(y);
    double coarsest = 0; // rounding of the position farthest from the origin
    for (std::size_t i = 0; i < scales_.size(); ++i)
        if (scales_[i].kind == UnknownScale::Kind::position)
            coarsest = std::max(coarsest, rounding * std::abs(y[i]) * scales_[i].lengthPerUnit);
    // A speed that does not show within the step.
    const double unseen = std::max(0.01 * tolerance_ * extent_, coarsest) /
                          std::max(h, std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < scales_.size(); ++i) {
        const double length = scales_[i].lengthPerUnit;
        double weight = std::max(rounding * std::abs(y[i]), 1e-280);
        if (scales_[i].kind == UnknownScale::Kind::position)
            weight = std::max(weight, tolerance_ * extent_ / length);
        else if (scales_[i].kind == UnknownScale::Kind::velocity)
            weight = std::max({weight, tolerance_ * speed_ / length, unseen / length});
        else
            weight = std::max({weight, tolerance_ * seen_[i].high, -tolerance_ * seen_[i].low,
                               tolerance_ * std::abs(y[i]), tolerance_ * 1e-3 * other_,
                               radius_ > 0 ? unseen / radius_ : 0});
        weights_[i] = weight;
    }
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
