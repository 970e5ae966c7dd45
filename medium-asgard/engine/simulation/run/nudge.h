// How much of a motion is rounding? The same run again, with values a unit in the last place
// beside what they were wherever they are given: velocities at the start and after each impact, and
// places of what moves at the start. Where the two runs part, rounding has grown so far that nobody
// could tell them apart from the truth. Far from time 0 impacts are late by more than that, and far
// from the origin the place of a hit on the body has fewer digits: velocities are nudged by as much
// more.
//
// Places of what stands still are left as they are, so that what touches goes on touching, and
// zeros stay zeros, so that what never moves need not be modelled in the nudged run either. No
// randomness: the value itself gives its nudge, whatever else is in the scene.
#pragma once

#include "motion/body_motion.h"

#include "expression/equations.h"
#include "solution/event_source.h"

#include <vector>

namespace simulation {

// Values of all unknowns at the start.
[[nodiscard]] std::vector<double> nudgedStart(const expression::EquationSet& equations);

class NudgedSource final : public solution::EventSource, private solution::Turns {
public:
    NudgedSource(solution::EventSource& source, const std::vector<BodyRecord>& bodies,
                 double start);

    void use(solution::Turns& turns) override {
        turns_ = &turns;
        source_.use(*this);
    }
    [[nodiscard]] std::optional<solution::Event> next(const solution::Histories& histories,
                                                      double known) override {
        return source_.next(histories, known);
    }
    void apply(const solution::Histories& histories, const solution::Event& event,
               solution::EquationsInForce& equations, solution::Changes& changes) override;
    [[nodiscard]] std::size_t bytesBefore(double t) const override {
        return source_.bytesBefore(t);
    }

private:
    [[nodiscard]] bool turn(double time, std::span<solution::Turn> turns) override;
    [[nodiscard]] std::optional<double> approach(double time, std::span<const std::size_t> unknowns,
                                                 const IsBefore& isBefore) override {
        return turns_->approach(time, unknowns, isBefore);
    }
    // The velocity that becomes `velocity`, where the largest coordinate is `farthest`.
    [[nodiscard]] double given(double velocity, std::size_t unknown, double time,
                               double farthest) const;

    [[nodiscard]] double unitsAt(double time, std::size_t unknown, double farthest) const;

    solution::EventSource& source_;
    double start_;
    std::vector<double> radii_; // by body of the equations: unknowns of each follow each other
    solution::Turns* turns_ = nullptr;
};

} // namespace simulation
