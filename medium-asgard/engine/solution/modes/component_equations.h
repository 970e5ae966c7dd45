// The equations of one component while no phase of its unknowns begins or ends: y' = f(t, y), held
// values h(t, y), and the branches of switching expressions that are in force.
//
// Held values are put into the derivatives symbolically, so that f reads time, the differential
// unknowns (states) and other components only. The Jacobian is derived symbolically.
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
// and v >= 1 at 1. Such surfaces are joined where one of them is passed, and have one weight where
// they are slid upon.
//
// Directions (directions.h). Where a/|a| is 0/0, f has u in its place, |u| <= 1, such that a stays
// 0: friction in a plane holds (Filippov's set is the image of a ball). a is put to 0 where it is
// about to be no more than a step may err by. When |u| would exceed 1, a leaves along the d for
// which the rate of a is parallel to d itself: with a' = F + M u it is d = (l - M)^-1 F, |d| = 1.
// Near rest a/|a| turns to that d within |a| / |F|, which is stiff: there d stands for a/|a| until
// a and d are farther apart than a step may err by.
//
// LIMIT: with several surfaces at once f is taken as affine in the weights, which holds unless
// switching terms multiply each other or stand in each other's guards. Such motion ends with a
// reason when it cannot go on.
#pragma once

#include "dense/first_violation.h"
#include "dense/inputs.h"
#include "equations/bound_model.h"
#include "expression/function.h"
#include "integrators/system.h"
#include "modes/mode.h"

#include <Eigen/Core>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace solution {

class ComponentEquations final : public System {
public:
    // `bound` is shared with other runs over the same equations; here is what a run changes.
    ComponentEquations(std::shared_ptr<const BoundModel> bound, const Histories& histories);

    // Places in the component's unknowns of the differential ones and of the held ones, in order of
    // evaluation.
    [[nodiscard]] const std::vector<std::size_t>& states() const { return bound_->states; }
    [[nodiscard]] const std::vector<std::size_t>& held() const { return bound_->held; }
    // Held unknowns whose values depend on each other in a circle; then no other function may be
    // called.
    [[nodiscard]] const std::vector<std::size_t>& loop() const { return bound_->loop; }
    [[nodiscard]] Inputs& inputs() { return inputs_; }
    [[nodiscard]] bool readsInputs() const { return readsInputs_; }
    [[nodiscard]] const ComponentModel& model() const { return model_; }
    [[nodiscard]] const std::shared_ptr<const BoundModel>& bound() const { return bound_; }

    // Nothing switches and nothing is held.
    [[nodiscard]] bool isPlain() const { return isPlain_; }
    [[nodiscard]] std::span<const double> constants() const {
        return std::span(in_).subspan(model_.variables());
    }

    // System, for the integrators.
    [[nodiscard]] std::size_t size() const override { return states().size(); }
    [[nodiscard]] bool rates(double t, std::span<const double> y, std::span<double> out) override;
    [[nodiscard]] double* place() override { return isPlain_ ? in_.data() + 1 : nullptr; }
    [[nodiscard]] Direct direct() override {
        if (!isPlain_ || !code_.entry)
            return {};
        return {code_, in_.data(), scratch_.data(), readsInputs_ ? this : nullptr};
    }
    void putInputs(double t) override { inputs_.values(t, std::span(in_).subspan(1 + size())); }
    [[nodiscard]] const Pattern& jacobianPattern() override;
    [[nodiscard]] bool jacobian(double t, std::span<const double> y,
                                std::span<double> entries) override;
    [[nodiscard]] std::span<const std::pair<std::size_t, std::size_t>> integrals() const override {
        return model_.integrals();
    }
    [[nodiscard]] std::span<const std::size_t> configuration() const override {
        return model_.configuration();
    }

    // Values of the held unknowns. False: not finite.
    [[nodiscard]] bool heldValues(double t, std::span<const double> y, std::span<double> out);
    // Sliding had no solution when rates() was asked last: then that is why it failed.
    [[nodiscard]] bool slidingFailed() const { return slidingFailed_; }
    // A stage of a step that starts on a surface, as from rest where drag is v sqrt(abs(v)), may
    // lie a little beyond it, where the branch that holds has no value. From now on rates() takes
    // the other one there, until lookNoMoreBeyond(). False: it does already, or no surface is here.
    [[nodiscard]] bool lookBeyond(double t, std::span<const double> y);
    void lookNoMoreBeyond() { mode_.looksBeyond = false; }
    // Places in `unknowns` of those whose rate or value is not finite.
    [[nodiscard]] std::vector<std::size_t> notFinite(double t, std::span<const double> y);

    // The outputs, for models in closed form: rates of states, then held values. All nodes are of
    // this graph, which holds nothing else: its bits depend on the component alone.
    [[nodiscard]] const expression::Graph& graph() const { return model_.graph(); }
    [[nodiscard]] expression::Node time() const { return model_.symbols()[0]; }
    [[nodiscard]] std::span<const expression::Node> outputs() const { return model_.outputs(); }
    [[nodiscard]] std::optional<expression::Decision> decisionOf(expression::Node switching) const;
    // The value of a symbol other than time or a state: an input, or a constant of this component.
    [[nodiscard]] std::optional<std::size_t> stateOf(expression::Node symbol) const;
    [[nodiscard]] std::optional<std::size_t> inputOf(expression::Node symbol) const;
    [[nodiscard]] std::optional<double> constantOf(expression::Node symbol) const;
    [[nodiscard]] bool readsStates() const { return model_.readsStates(); }

    // The model's peaks (equations/peaks.h): causes and their rates where states have these, and
    // heights.
    void peakCauses(const ComponentModel::PeakFunctions& peaks, double t, std::span<const double> y,
                    std::span<const double> rates, std::span<double> out);
    void peakHeights(double t, std::span<const double> y, std::span<double> out);

    // Branches. decide() is from the values alone, with what the fields say on a surface itself.
    void decide(double t, std::span<double> y);
    [[nodiscard]] std::size_t watches() const { return watches_.size() + mode_.sticking.size(); }
    void watch(double t, std::span<const double> y, std::span<double> values);
    // At its time the rates lead away from all its surfaces, to the sides that hold: only an error
    // of polynomials crosses them, where a guard is smaller than that.
    [[nodiscard]] bool contradicts(const Violation& violation, double t, std::span<const double> y);
    // There the rates lead away from the one surface of the violation, to the side that holds, and
    // its guard is no more than what rounding leaves of a difference: the motion, which started on
    // the surface, has just left it, and goes on where it is. From then on crossings back count
    // beyond `standing` only. A surface that was passed is not grazed so: swings that become ever
    // shorter would never end.
    [[nodiscard]] bool grazesByRounding(const Violation& violation, double t,
                                        std::span<const double> y);
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
    [[nodiscard]] std::vector<std::size_t> surfacesOf(const Violation& violation) const;
    [[nodiscard]] const Mode& mode() const { return mode_; }
    // On surfaces, or held at 0 where directions have none.
    [[nodiscard]] bool sliding() const { return mode_.isHeld(); }

    // Directions (component_sticking.cpp).
    [[nodiscard]] bool hasDirections() const { return !model_.directions().ranges.empty(); }
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
    // Those whose vector is 0, but for rounding.
    [[nodiscard]] std::vector<std::size_t> directionsAtRest(double t, std::span<const double> y);
    // Puts their vectors to 0, where they stay as long as they can; a vector that cannot leaves at
    // once, by a hundredth of the reach. False: nothing holds them there, and nothing was done.
    [[nodiscard]] bool rest(std::span<const std::size_t> directions, double t, std::span<double> y);
    // Unknowns (places) that the guards of its watches read, and those of other components.
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const Violation& violation) const;
    [[nodiscard]] std::vector<std::size_t> inputsOf(const Violation& violation) const;

private:
    struct Watch {
        enum class Kind { side, least, most } kind; // least, most: of a weight
        std::size_t surface;
    };
    static constexpr double standing = 1e-12; // on a surface, by the value of its guard
    // The distance of a move off a surface, or off a length of 0, for its direction; its square is
    // still a number.
    static constexpr double nextToNothing = 1e-150;
    // Less is what next to nothing makes of a rate of 0: in proportion to it, to its square or to
    // its cube root.
    static constexpr double vanishing = 1e-40;

    void fill(double t, std::span<const double> y);
    void evaluate(std::span<double> out);
    void evaluateWhereItIs();                    // into out_, by the values of guards
    void setSide(std::size_t surface, int side); // and that of those that are joined with it
    void setOwnSide(std::size_t surface, int side);
    void setGrazed(std::size_t surface, bool isGrazed);
    void refreshWatches();
    struct Slope {
        double rate;
        double noise; // what rounding may make of a rate of 0
        double near;  // and of a guard of 0, where its root was located
        double least; // and of a guard of 0, where what it reads is exact
        double value; // the guard
        bool still;   // constant on the branches in force, whatever moves
    };
    // On the branches that are in force for the equations.
    void evaluate(const ComponentModel::Derived& derived, std::span<double> out);
    void evaluate(const ComponentModel::Derived& derived, std::span<const double> in,
                  std::span<double> out);
    [[nodiscard]] Slope guardRate(std::size_t surface, std::span<const double> rates);
    [[nodiscard]] Slope slopeOf(const ComponentModel::Derived& derivatives,
                                std::span<const double> rates);
    [[nodiscard]] bool weigh(); // weights_ and rates of sliding at what fill() was given
    void settleOn(std::size_t surface);
    [[nodiscard]] bool leadsInside(const Watch& watch);
    void field(); // rates into out_, whether sliding or not
    [[nodiscard]] double guard(std::size_t surface) const; // after evaluating guards_
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
    [[nodiscard]] std::vector<std::size_t> symbolsOf(const Violation& violation) const;
    [[nodiscard]] bool passWhole(std::size_t surface, bool insist);
    // Joining (component_joined.cpp).
    [[nodiscard]] bool takeLevel(std::size_t surface);
    void join(std::size_t surface);
    using Distances = std::array<double, 4>;
    [[nodiscard]] Distances distancesAround(std::size_t surface);
    [[nodiscard]] std::optional<int>
    orientationBeside(std::size_t surface, std::span<const Distances, 2> mine, std::size_t other);
    [[nodiscard]] bool isOnSide(std::size_t surface) const;
    [[nodiscard]] expression::Decision decisionBeside(std::size_t surface, int side) const;
    [[nodiscard]] double distance(std::size_t surface);
    [[nodiscard]] double valueOf(std::size_t surface);
    [[nodiscard]] std::vector<double> distancesOfSliding();
    [[nodiscard]] bool leaveWhereJumped(std::span<const double> before);
    [[nodiscard]] bool holdsOn(const std::vector<std::size_t>& surfaces);
    // Corners (component_corners.cpp).
    [[nodiscard]] std::vector<std::size_t> surfacesHere();
    struct Solution {
        bool within, leaves; // weights within (0, 1); all others lead away, and none along
    };
    [[nodiscard]] bool isSolved(std::span<const std::size_t> surfaces, Solution asked);
    [[nodiscard]] bool solveCorner();
    [[nodiscard]] bool settleWeights(double t, std::span<const double> y);
    void project(double t, std::span<double> y);
    // Directions (component_sticking.cpp).
    void evaluateOutputs(std::span<double> out);
    void measure();
    struct Column { // of what is solved for while sliding
        bool isPart;
        std::size_t which; // surface, or part
    };
    [[nodiscard]] std::vector<Column> columns() const;
    void setColumn(const Column& column, bool isSet);
    [[nodiscard]] double rateOf(const Column& column, std::span<const double> rates);
    [[nodiscard]] bool weighWithDirections();
    [[nodiscard]] bool solveWithDirections();
    [[nodiscard]] Eigen::VectorXd vectorOf(std::size_t direction) const;
    [[nodiscard]] double leeway();
    [[nodiscard]] bool setFree(double t, std::span<double> y);
    void releaseWhereJumped(double t, std::span<const double> y);
    [[nodiscard]] double excess(std::size_t direction) const;
    struct Response;
    [[nodiscard]] std::optional<Response> responseOf(std::size_t direction);
    void put(std::size_t direction, const Eigen::VectorXd& target, const Response& response,
             std::span<double> y);
    [[nodiscard]] const ComponentModel::Gradient& gradientOf(const Column& column) const;
    [[nodiscard]] double scaleOf(std::size_t part) const;
    [[nodiscard]] double reachOf(std::size_t part);
    [[nodiscard]] bool leaveRest(std::size_t direction, double t, std::span<double> y);
    [[nodiscard]] bool leaveRest(const Violation& violation, double t, std::span<double> y);
    [[nodiscard]] bool differences(double t, std::span<const double> y, std::span<double> entries);

    std::shared_ptr<const BoundModel> bound_;
    const ComponentModel& model_;
    Inputs inputs_;
    expression::Function::Scratch scratch_;
    std::vector<double> in_; // values of the model's symbols; constants stand at the end
    std::vector<double> out_, base_, other_, guards_;

    Mode mode_;
    std::vector<int> ahead_;      // those that looksAhead() saw, by surface
    std::vector<char> wasPassed_; // by surface, since the start or the last event
    // On these the motion was told to stand, at that time; passing another then moves it off none
    // of them.
    std::vector<std::size_t> standing_;
    double standingAt_ = 0;
    std::vector<double> weights_;
    std::optional<std::size_t>
        given_; // of what sticks, the direction whose units are not to be found
    double growth_ = 0,
           pull_ = 0;           // of what sets off: rate of its vector, and of it without friction
    std::vector<double> units_; // for parts of unit vectors that are held, by part
    std::vector<double> inMoving_;          // symbols, and rates of states and inputs
    std::vector<double> measures_, inHeld_; // of the model's directions
    std::vector<double> reach_;             // by state
    double tolerance_ = 0;                  // by which it was made
    bool slidingFailed_ = false;
    std::vector<Watch> watches_;
    std::vector<expression::Decision> derivedDecisions_;
    expression::Function::Code code_; // of a plain one, once there is any
    bool isPlain_;                    // nothing switches and nothing is held
    bool readsInputs_;                // of other components
};

} // namespace solution
