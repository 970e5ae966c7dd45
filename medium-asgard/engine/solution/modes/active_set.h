// Which multipliers with bounds hold their conditions, and what ends that?
//
//     low < m < high    the condition holds: its second rate is 0
//     m = low, high     the condition is left: a stop is open, a brake or a motor slips
//
// A condition with a gap is a stop: gap >= 0, m >= 0, one of both 0. One of velocities is a brake
// or a motor: its force is low while the rate is positive, and high while it is negative.
//
// Between events the set is held. A force that reaches a bound, a gap or a rate that reaches 0 ends
// it (watch()). A gap that closes is a blow: velocities jump by Newton's law, in one solve with all
// that hangs together. Then the second rates and the laws give the next set (complementarity/), a
// little ahead of the event: at a bound itself they have two answers.
//
// LIMIT: hops lower than a condition's resolution are left out.
#pragma once

#include "complementarity/laws.h"
#include "modes/multipliers.h"

#include <span>
#include <vector>

namespace solution {

class ActiveSet {
public:
    ActiveSet(ModelFunctions& functions, Multipliers& multipliers, Mode& mode);

    // There are bounds.
    [[nodiscard]] bool empty() const { return bounded_.empty(); }
    // The set is another.
    void refresh();
    // Functions that end it when they fall below 0, of the mode that was refreshed last.
    [[nodiscard]] std::size_t size() const { return watches_.size(); }
    // At the point of the functions, for which the multipliers are solved.
    void watch(std::span<double> values);
    // The set that follows from the values alone, where some may touch and approach.
    void decide(double t, std::span<double> y);
    // The set after these watches fell; y with what blows give. False: no forces keep the laws.
    // `rates` of the states led there.
    [[nodiscard]] bool cross(std::span<const std::size_t> watches, double t, std::span<double> y,
                             std::span<const double> rates);

private:
    enum class Kind { gap, least, most, forward, backward };
    struct Watch {
        std::size_t row;
        Kind kind;
    };
    [[nodiscard]] const BoundModel::Law& law(std::size_t row) const {
        return f_.bound()->laws[row];
    }
    [[nodiscard]] bool isStop(std::size_t row) const;
    [[nodiscard]] complementarity::Laws lawsOf(std::span<const std::size_t> rows,
                                               bool isBlow) const;
    void blow(std::span<const std::size_t> hit, double t, std::span<double> y);
    void give(std::span<const std::size_t> hit, std::span<const double> restitutions, double t,
              std::span<double> y);
    void slip(double fastest, double t, std::span<const double> y);
    [[nodiscard]] bool isLow(std::size_t row, double rate);
    [[nodiscard]] bool isCandidate(std::size_t row, double fastest) const;
    [[nodiscard]] bool settle(std::span<const std::size_t> fallen, double fastest, double t,
                              std::span<const double> y);

    ModelFunctions& f_;
    Multipliers& multipliers_;
    Mode& mode_;
    std::vector<std::size_t> bounded_; // multipliers
    std::vector<Watch> watches_;
    double lastCross_ = 0, ahead_ = 0; // the last event, and how far its laws looked ahead
};

} // namespace solution
