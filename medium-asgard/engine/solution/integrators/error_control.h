// How large may an error of one step be, for each unknown of a component?
//
//   position    tolerance * E / lengthPerUnit, E the extent of the component's motion: the range of
//               its positions so far, at least what the caller says its bodies measure
//   velocity    tolerance * the largest speed in the component so far
//   any other   tolerance * its own largest value so far, at least 1e-3 of the largest such value
//               of the component (a spin that is zero but for rounding is no quantity of its own)
//
// An error in a velocity or a spin that moves nothing by a hundredth of the position's tolerance
// within the step, or by less than the rounding of the positions, is also allowed, so that a body
// at rest is not followed into its rounding errors. Where something may peak (equations/peaks.h) a
// step is as short as the peak, but the speed that the peak leaves acts for long after: the check
// then takes a longer time. No scale is below the rounding of the value itself.
//
// The norm is the maximum, not a mean over unknowns: the promise holds for each body, and a mean
// would let one moving body hide among many that rest.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace solution {

struct UnknownScale {
    enum class Kind { position, velocity, other };
    Kind kind = Kind::other;
    // Of itself, or of the position that it is the velocity of; of a spin, what it moves in one of
    // time. 0: of nothing.
    double lengthPerUnit = 0;
    double extent = 0; // the least that its component's extent is
};

class ErrorControl {
public:
    ErrorControl() = default;
    ErrorControl(std::vector<UnknownScale> scales, double tolerance);

    [[nodiscard]] double tolerance() const { return tolerance_; }
    // The error that a Newton iteration may leave, in units of the tolerance; never below rounding.
    [[nodiscard]] double newtonTolerance() const;
    // The size that rounding of positions leaves of a correction in the step last prepared, in the
    // same units: no correction below this says how an iteration converges. At fixed steps nothing
    // is gained by less.
    [[nodiscard]] double newtonNoise(bool isControlled = true) const;
    // Accepted values widen ranges and largest values.
    void observe(std::span<const double> y);
    // The displacement by an error in a velocity counts over at least that time from now on.
    void countSpeedsOver(double duration) { duration_ = duration; }
    // Scales for a step of length h to `y`, the values seen so far and these.
    void prepare(std::span<const double> y, double h);
    // max |error_i| / scale_i, with the scales last prepared.
    [[nodiscard]] double norm(std::span<const double> error) const;
    [[nodiscard]] double scale(std::size_t i) const { return weights_[i]; }
    // Of a position, by that which is farthest from the origin in its component; 0 of all else.
    [[nodiscard]] double rounding(std::size_t i) const;
    // The largest displacement by these rates of velocities within a step of length h, over the
    // extent. For an unknown without a position: its change over its magnitude.
    [[nodiscard]] double displacement(std::span<const double> rates, double h) const;
    // The size against which a rate is judged slow or fast; 0: nothing is known yet.
    [[nodiscard]] double magnitude(std::size_t i) const;
    [[nodiscard]] double extent() const { return extent_; }
    // How long the largest speed takes through the extent; infinite while nothing has moved.
    [[nodiscard]] double crossing() const;

    static constexpr double units = 16; // in the last place, that errors are allowed to be

private:
    friend class AlikeSteps;
    struct Seen {
        double low = 0, high = 0;
    };
    template <bool Observes> void measure(std::span<const double> y);
    [[nodiscard]] double noise() const;

    struct Measured {
        std::size_t unknown;
        double lengthPerUnit;
    };

    std::vector<UnknownScale> scales_;
    std::vector<Measured> positions_, velocities_, others_; // of these
    std::vector<Seen> seen_;
    std::vector<double> weights_;
    double tolerance_ = 1e-6;
    bool any_ = false;
    double leastExtent_ = 0, rounding_ = 0;
    double duration_ = 0;                       // least time for which an error in a speed counts
    double step_ = 0;                           // last prepared
    double extent_ = 0, speed_ = 0, other_ = 0; // with the values last measured
};

} // namespace solution
