// One strongly connected component on its way through time: its phases, its switches, and the
// steps that its models propose (step_model.h) and it accepts. solver.h says what one step is.
//
//     startAt(t, values)         values of its unknowns are given; stands on an anchor
//     while (input = waitsFor()) some other component must advance first
//     step()                     until time() is far enough or ended()
//     backTo(t)                  forget everything after t: an event
//     restart(jumps)             go on from there
#pragma once

#include "equations/prepared_equations.h"
#include "exact/plain_motion.h"
#include "stepping/step_models.h"

#include <limits>
#include <memory>

namespace solution {

class Component {
public:
    // The parts of its solver that a component is told of, all of which outlive it. `zero` may
    // change with the equations; then the components that it concerns are made anew.
    struct Surroundings {
        const EquationsInForce& set;
        const Histories& histories;
        const Options& options;
        const ZeroStates& zero;
        ComponentModels& models;
    };
    Component(const Surroundings& surroundings, std::vector<std::size_t> unknowns);
    Component(const Component&) = delete;
    Component& operator=(const Component&) = delete;
    // With equations that were prepared for the phases in force at the start.
    void use(const PreparedEquations::Component& prepared);

    [[nodiscard]] const std::vector<std::size_t>& unknowns() const { return unknowns_; }
    [[nodiscard]] const std::shared_ptr<History>& history() const { return writer_.history(); }
    [[nodiscard]] double time() const { return progress_.time; }
    // Where its next step would end, as far as that is known; else time().
    [[nodiscard]] double nextEnd() const { return progress_.time + progress_.proposed; }
    [[nodiscard]] bool ended() const { return stop_.has_value(); }
    [[nodiscard]] const std::optional<Stop>& stop() const { return stop_; }
    [[nodiscard]] const std::vector<double>& values() const { return progress_.values; }
    [[nodiscard]] double valueOf(std::size_t unknown) const; // of one of its own
    [[nodiscard]] const ComponentEquations& equations() const { return *equations_; }
    [[nodiscard]] ErrorControl& control() { return memory_.now.control; }

    // Other components read it: its trembling may be all that moves them.
    void setRead(bool isRead) { progress_.isRead = isRead; }

    void startAt(double t, std::span<const double> values);
    // An unknown of another component that must be known for longer before the next step.
    [[nodiscard]] std::optional<std::size_t> waitsFor();
    void step();

    // Steps beside others (side_by_side.h, integration.h): whether its next ones may be made so,
    // and what becomes of one that was made, was refused for good, or changed the method.
    [[nodiscard]] Integration& integration() { return models_.integration(); }
    [[nodiscard]] bool isInStride() const { return models_.integration().isInStride() && !stop_; }
    void takeStride(double h, double to, double next);
    void endStride(const Attempt& attempt, double h);
    void changeMethodAfterStride();
    // With the values at time(), from where it steps by itself again.
    void leaveStride(std::span<const double> y) { progress_.put(equations_->states(), y); }

    // Its values at t are on the conditions that held up to there.
    void backTo(double t);
    // Where to end the step that has t within, so that from there on values at t are on the
    // conditions that hold: its polynomials are not. Nothing: they are, or nothing can be done.
    [[nodiscard]] std::optional<double> endBefore(double t);
    struct Jump {
        std::size_t place; // in unknowns()
        double value;
    };
    void restart(std::span<const Jump> jumps);
    // Both at once where that is next to nothing: plain motion (exact/plain_motion.h) goes on to
    // the end of time in one piece from its value at t, or from `jump`. False: it is none, and
    // nothing was done. The unknown that it reads must go on so already.
    [[nodiscard]] bool resume(double t, std::optional<double> jump);
    // Of plain motion that goes on for ever.
    [[nodiscard]] const PlainRate* plainRate() const;
    // Others keep its motion from t on, until it goes on by itself along this polynomial of t -
    // origin.
    void leave(double t);
    void goOn(double origin, std::span<const double> coefficients);
    void end(Stop::Reason reason, const std::vector<std::size_t>& culprits,
             const std::string& sentence);

    [[nodiscard]] ComponentStatistics statistics() const;
    [[nodiscard]] std::size_t evaluations() const;
    [[nodiscard]] std::size_t switches() const { return counts_.switches; } // that it has passed
    [[nodiscard]] std::size_t bytes() const; // beside its history, about
    [[nodiscard]] std::size_t checkpointBytesBefore(double t) const;

private:
    // Phases and regimes.
    void findQuaternions();
    void openRegime(bool withJumps);
    void takeEquations(std::vector<std::size_t> phases);
    void applyJumps();
    void makeControl();
    void begin(); // decides branches, drops the method, stands on an anchor
    void placeAnchor();
    void takeLayout();
    void endWhereContradictory();
    void endWhereApart(const std::vector<std::size_t>& apart);
    void decideRest(std::vector<double>& y);
    void takeHeldValues();
    void takeModes();
    void releaseConditions();
    void landOnConditions();
    [[nodiscard]] std::vector<double> states() const { return progress_.at(equations_->states()); }

    // Steps.
    [[nodiscard]] bool endsBeforeStep();
    [[nodiscard]] bool stepOverSliver();
    [[nodiscard]] bool stepPlainly();
    void take(const Proposal& proposal);
    void end(const Ending& ending) { end(ending.reason, ending.culprits, ending.sentence); }
    void accept(const StepPiece& piece);
    void write(const StepPiece& piece);
    [[nodiscard]] bool land(std::span<const double>& y);
    [[nodiscard]] bool overflows(std::span<const double> y);
    void arrive(); // at the boundary: a phase, an input's event, an input's end

    // Switches.
    void pass(const Violation& violation, bool immediate);
    [[nodiscard]] ComponentEquations::Passing passing(const Violation& violation, bool immediate);
    [[nodiscard]] bool comesToRest(std::vector<double>& y);
    void settle(double next);
    [[nodiscard]] std::string switchingWith(const Violation& violation) const;

    Surroundings around_;
    std::vector<std::size_t> unknowns_;
    std::unique_ptr<ComponentEquations> equations_;
    Memory memory_;
    Progress progress_;
    PieceWriter writer_;
    Boundary boundary_;
    SwitchLog switches_;
    Oversight oversight_;
    ComponentStatistics counts_;
    StepContext context_;
    StepModels models_;
    std::optional<PlainRate> plainRate_;
    std::optional<Stop> stop_;
};

} // namespace solution
