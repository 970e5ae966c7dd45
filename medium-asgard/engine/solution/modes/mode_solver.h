// On which branches does a motion go on at a switch?
//
// Sides of surfaces (equations/surfaces.h). A surface is passed when the field behind it leads away
// from it. When it leads back, motion slides on the surface (Filippov 1988): with f- and f+ the
// fields of both sides,
//
//     f = f- + w (f+ - f-),   w such that grad g . f + dg/dt = 0,
//
// until w leaves [0, 1]; several such surfaces at once give a linear system for their weights. This
// is how a block that friction stops stays where it is. Where a state is itself the guard, its rate
// is set to 0, so that it stays exactly.
//
// On floor and ceil it slides along a whole number, between the branches beside it.
//
// Switches at the same place change together: sign(v), v >= 0, floor(v) and ceil(v) at 0, floor(v)
// and v >= 1 at 1. Such surfaces are found to be coincident where one of them is passed, and have
// one weight where they are slid upon.
//
// Directions of vectors that come to 0: stick_slip.h.
//
// LIMIT: with several surfaces at once f is taken as affine in the weights, which holds unless
// switching terms multiply each other or stand in each other's guards. Such motion ends with a
// reason when it cannot go on. The contacts at a start are decided with the weights that switches
// had before, and with no force along directions at rest.
#pragma once

#include "modes/guards.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class ModeSolver {
public:
    ModeSolver(ModelFunctions& functions, HeldField& field, StickSlip& stick, ActiveSet& active,
               Guards& guards, Mode& mode)
        : f_(functions), field_(field), stick_(stick), active_(active), guards_(guards),
          model_(*mode.model), mode_(mode) {}

    // From the values alone, with what the fields say on a surface itself.
    void decide(double t, std::span<double> y);
    enum class Crossing { done, impossible };
    // How surfaces are passed. Where each side seems to lead to the other, by rounding or since the
    // motion only touches the surface, it `stands` on it until it is seen where the motion goes,
    // and then `leaves` to that side, from where it stood. A motion that goes neither way `stays`
    // until it has left by itself. Where several meet, and passing one after the other does not
    // end, the passing of all of them is `solved` at once: each is slid upon, or left to a side to
    // which the field leads.
    enum class Passing { across, solved, stands, leaves, stays };
    // Passes the surfaces of those watches, or slides on them; y is put onto surfaces of sliding.
    [[nodiscard]] Crossing cross(const Violation& violation, double t, std::span<double> y,
                                 Passing how);
    // At that point the motion has left a surface on which it stood: cross() may go back to where
    // it stood, and let it leave from there. The way between is less than watches tell.
    [[nodiscard]] bool looksAhead(const Violation& violation, double t, std::span<const double> y);
    // Swings about these surfaces have come to their end, in ever shorter times: is the motion held
    // on all of them, within that reach of its states? Then it is from now on, and y is put there.
    [[nodiscard]] bool holdOn(const std::vector<std::size_t>& surfaces, double t,
                              std::span<const double> reach, std::span<double> y);
    // There it is on all of these, but for what counts as standing on them.
    [[nodiscard]] bool standsOn(const std::vector<std::size_t>& surfaces, double t,
                                std::span<const double> y);

private:
    using Watch = Guards::Watch;
    void settleOn(std::size_t surface);
    [[nodiscard]] bool isRight(std::size_t surface);
    [[nodiscard]] expression::Decision wholeBranch(std::size_t surface,
                                                   std::span<const double> rates);
    struct Passed {
        bool isAlone = false;                   // no other falls at the same time
        std::vector<std::size_t> surfaces = {}; // the field behind them may lead back
        std::vector<std::size_t> settled = {};  // where nothing more is asked
        std::vector<std::size_t> joined = {};   // passed with one of `surfaces`
        std::vector<std::size_t> stood = {};    // of `surfaces`, those on which it stood
    };
    void follow(const Passed& passed);
    [[nodiscard]] bool follow(std::size_t surface, std::span<const double> rates, bool passed);
    void pass(const Watch& watch, Passing how, Passed& passed);
    void passAcross(std::size_t surface, Passed& passed);
    void slideWhereLedBack(const Passed& passed);
    struct Late { // after a switch was passed, and the rates before it
        double seconds = 0;
        std::vector<double> rates = {};
    };
    [[nodiscard]] Late lateness(const Violation& violation);
    void makeUp(const Late& late, double t, std::span<double> y);
    enum class Front { leadsHere, rests, leadsAway };
    [[nodiscard]] Front front(std::size_t surface);
    [[nodiscard]] bool passWhole(std::size_t surface, bool insist);
    // Coincident switches (mode_solver_intersections.cpp).
    [[nodiscard]] bool takeLevel(std::size_t surface);
    void join(std::size_t surface);
    using Distances = std::array<double, 4>;
    [[nodiscard]] Distances distancesAround(std::size_t surface);
    [[nodiscard]] std::optional<int>
    orientationBeside(std::size_t surface, std::span<const Distances, 2> mine, std::size_t other);
    [[nodiscard]] std::vector<double> distancesOfSliding();
    [[nodiscard]] bool leaveWhereJumped(std::span<const double> before);
    [[nodiscard]] bool holdsOn(const std::vector<std::size_t>& surfaces);
    // Switch intersections.
    [[nodiscard]] std::vector<std::size_t> surfacesHere();
    struct Solution {
        bool within, leaves; // weights within (0, 1); all others lead away, and none along
    };
    [[nodiscard]] bool isSolved(std::span<const std::size_t> surfaces, Solution asked);
    [[nodiscard]] bool solveCorner();
    [[nodiscard]] bool settleWeights(double t, std::span<const double> y);
    void decideContacts(double t, std::span<double> y);
    void project(double t, std::span<double> y);

    ModelFunctions& f_;
    HeldField& field_;
    StickSlip& stick_;
    ActiveSet& active_;
    Guards& guards_;
    const ComponentModel& model_;
    Mode& mode_;
    std::vector<int> ahead_; // sides that looksAhead() saw, by surface
    // On these the motion was told to stand, at that time; passing another then moves it off none
    // of them.
    std::vector<std::size_t> standing_;
    double standingAt_ = 0;
};

} // namespace solution
