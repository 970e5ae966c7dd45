// When do vectors come to where their directions have none, and when do they leave?
//
// A vector is put to 0 where it is about to be no more than a step may err by. When |u|
// (held_field.h) would exceed 1, it leaves along the d for which its rate is parallel to d itself:
// with a' = F + M u it is d = (l - M)^-1 F, |d| = 1. Near rest a/|a| turns to that d within |a| /
// |F|, which is stiff: there d stands for a/|a| until a and d are farther apart than a step may err
// by.
#pragma once

#include "modes/held_field.h"

#include <span>
#include <vector>

namespace solution {

class StickSlip {
public:
    StickSlip(ModelFunctions& functions, HeldField& field, Mode& mode)
        : f_(functions), field_(field), model_(*mode.model), mode_(mode) {}

    // The error that a step may have, of each state: less is 0, for directions.
    void setReach(std::span<const double> reach, double tolerance) {
        reach_.assign(reach.begin(), reach.end());
        tolerance_ = tolerance;
    }
    struct Approach {
        std::size_t direction;
        double length;   // of its vector
        double duration; // until that is 0, as it now falls
        bool isNear;     // that is within reach
    };
    // Of vectors that fall.
    [[nodiscard]] std::vector<Approach> approaches(double t, std::span<const double> y);
    // Puts their vectors to 0, where they stay as long as they can; a vector that cannot leaves at
    // once, by a hundredth of the reach. False: nothing holds them there, and nothing was done.
    [[nodiscard]] bool rest(std::span<const std::size_t> directions, double t, std::span<double> y);
    // Of one that sets off: how much farther its vector may deviate from the direction of the pull.
    [[nodiscard]] double leeway();
    // These leave, or go free when they have set off. False: one of them can do neither.
    [[nodiscard]] bool leave(std::span<const std::size_t> directions, double t,
                             std::span<double> y);
    void releaseWhereJumped(double t, std::span<const double> y);
    // None is held.
    void forget() {
        mode_.sticking.clear();
        mode_.leaving.reset();
    }

private:
    [[nodiscard]] bool leaveRest(std::size_t direction, double t, std::span<double> y);
    [[nodiscard]] bool setFree(double t, std::span<double> y);
    void put(std::size_t direction, const Eigen::VectorXd& target,
             const HeldField::Response& response, std::span<double> y);
    [[nodiscard]] double reachOf(std::size_t part);

    ModelFunctions& f_;
    HeldField& field_;
    const ComponentModel& model_;
    Mode& mode_;
    std::vector<double> reach_; // by state
    double tolerance_ = 0;      // by which it was made
};

} // namespace solution
