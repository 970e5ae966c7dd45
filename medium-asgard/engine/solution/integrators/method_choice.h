// Explicit or implicit? Decided for each component by cost, from counts alone, while it runs.
//
// Every component begins explicit. It tries the implicit method
//     when h |lambda| (by its stages, or as it was told) has on average used four fifths of the
//     explicit method's stability for 20 steps: the step is bound by stability; or
//     after 80 steps in which it used a tenth: stiffness then often costs accuracy (order
//     reduction), though an oscillation that is merely well resolved looks the same.
// An implicit step costs as much as some ten explicit ones, and a trial a Jacobian to derive
// besides. So where ten explicit steps are no short time of the motion (less than a 250th of what
// it takes to cross its extent), there must have been fifty times as many steps before it is tried.
// A trial lasts 12 steps. It is kept when its last 8 steps advanced time by at least 1.3 times as
// much per cost as the explicit ones did. Cost, in right-hand sides: 8 for a Jacobian, 60 for its
// real and complex factors, 12 for an iteration's solves (measured with machine code).
// An implicit method that has settled is left when its steps fall below six times what the explicit
// one could take, by the spectral radius of the Jacobian. Each change back doubles the evidence
// that the next trial needs, up to 320 where steps are short: then they have cost more than a
// trial.
#pragma once

#include "integrators/method.h"

namespace solution {

class MethodChoice {
public:
    [[nodiscard]] bool implicit() const { return implicit_; }
    [[nodiscard]] bool isTrial() const { return trial_; }
    // The choice after an event: a trial that was not decided counts for nothing.
    [[nodiscard]] MethodChoice restarted() const;
    [[nodiscard]] bool operator==(const MethodChoice&) const = default;

    // After each accepted step of length h, of a motion that crosses its extent in `crossing` at
    // its fastest, and of which some |lambda| is known where it began; true: go on with the other
    // method.
    [[nodiscard]] bool changesAfter(const Method& method, double h, double crossing,
                                    double known = 0);
    // A new method begins to count its work.
    void begin() { before_ = 0; }
    // Now and then |lambda| must be told to an implicit method.
    [[nodiscard]] bool wantsSpectralRadius() const;
    [[nodiscard]] bool changesFor(double spectralRadius, double h);

private:
    void change(bool implicit);
    [[nodiscard]] double costOf(const Method& method) const;

    bool implicit_ = false, trial_ = false, tried_ = false;
    std::size_t evidence_ = 20, steps_ = 0; // steps since the last change
    double stability_ = 0;                  // mean of what explicit steps used, or of h / limit
    double before_ = 0;                     // cost at the last step
    double progress_ = 0, cost_ = 0;        // of recent steps, older ones counting less
    double explicitRate_ = 0;               // progress per cost before the trial
};

} // namespace solution
