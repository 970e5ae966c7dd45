// How far may a step go towards a place where directions have none, as where friction in a plane
// stops a body?
//
// Near rest the rates turn within ever shorter times. A step goes no farther than nine tenths of
// the way to where the present rates lead to rest, so that explicit steps stay on this side of it
// and come nearer by a tenth each time where the way is straight. Where it is not, since the pull
// is nearly as strong as the friction, directions turn so much faster than the length falls that an
// explicit step swings about the way: it goes half as far, until the length falls as foreseen. A
// vector that is nearer than the error that a step may have goes to rest along its rates.
#pragma once

#include "stepping/step_model.h"

#include <map>
#include <optional>

namespace solution {

// The motion along these rates of the states for a time h, into `curves` and, at its end, into y:
// rates of velocities move places, too.
void goAlong(const ComponentEquations& equations, std::span<const double> rates, double h,
             std::vector<double>& y, std::vector<Coefficients>& curves);

class RestApproach {
public:
    explicit RestApproach(const StepContext& context) : context_(context) {}
    void begin() { falling_.clear(); }
    // The way to rest where the motion is there at once. None: the next step may take so long.
    // `farthest`: how far the present rates are followed.
    [[nodiscard]] std::optional<StepPiece> arrive(double farthest);
    [[nodiscard]] double longest() const { return longest_; }

private:
    [[nodiscard]] double partOfWay(const ComponentEquations::Approach& approach);
    [[nodiscard]] std::optional<StepPiece> goTo(std::size_t direction, double duration);

    const StepContext& context_;
    double longest_ = infinity; // of the next step, on this side of rest
    struct Falling {            // a vector whose direction ends at rest, when last looked at
        double time, length, duration;
        double part; // of the way to rest that a step may go
    };
    std::map<std::size_t, Falling> falling_; // by direction
    std::vector<Coefficients> line_;
    std::vector<double> y_;
};

// The reach of directions at rest: the error that a step may have.
void takeReach(const StepContext& context, std::span<const double> y);

} // namespace solution
