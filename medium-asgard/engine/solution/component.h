// One strongly connected component on its way through time: its phases, model, method, switches and
// pieces. solver.h says what one step is.
//
//     startAt(t, values)         values of its unknowns are given; stands on an anchor
//     while (input = waitsFor()) some other component must advance first
//     step()                     until time() is far enough or ended()
//     backTo(t)                  forget everything after t: an event
//     restart(jumps)             go on from there
//
// Models, least first: `closed-form` (closed_form.h, linear_motion.h), `quadrature` (a single
// unknown whose rate reads time and other components only, by an explicit method, unless pieces
// integrate exactly), `explicit`, `implicit` (method_choice.h).
#pragma once

#include "dense/piece_writer.h"
#include "equations/equations_in_force.h"
#include "equations/prepared_equations.h"
#include "integrators/method_choice.h"
#include "modes/switch_log.h"
#include "oversight/peak_centres.h"
#include "oversight/watched_times.h"
#include "solution/component_equations.h"
#include "solution/linear_motion.h"
#include "solution/solver.h"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>

namespace solution {

// A step that would end within a hundredth of its length before its limit is stretched to it; one
// of fixed length only over rounding.
[[nodiscard]] inline double landingOf(const Options& options) {
    return options.fixedStep ? 1 + 1e-9 : 1.01;
}

inline constexpr double heldPart = 1e-3; // of the tolerance, that polynomials of held values err by

// Below this a step does not move time by more than rounding.
[[nodiscard]] inline double shortestStep(double t) {
    return 4 * std::numeric_limits<double>::epsilon() * std::abs(t) +
           std::numeric_limits<double>::min();
}

class ExplicitRungeKutta;

class Component {
public:
    // The parts of its solver that a component is told of, all of which outlive it. `zero` may
    // change with the equations; then the components that it concerns are made anew.
    struct Surroundings {
        const EquationsInForce& set;
        const UnknownIndex& index;
        const Histories& histories;
        const Options& options;
        const ZeroStates& zero;
        ComponentModels& models;
    };
    Component(const Surroundings& surroundings, std::vector<std::size_t> unknowns);
    // With equations that were prepared for the phases in force at the start.
    void use(const PreparedEquations::Component& prepared);

    [[nodiscard]] const std::vector<std::size_t>& unknowns() const { return unknowns_; }
    [[nodiscard]] const std::shared_ptr<History>& history() const { return writer_.history(); }
    [[nodiscard]] double time() const { return time_; }
    // Where its next step would end, as far as that is known; else time().
    [[nodiscard]] double nextEnd() const { return time_ + proposed_; }
    [[nodiscard]] bool ended() const { return stop_.has_value(); }
    [[nodiscard]] const std::optional<Stop>& stop() const { return stop_; }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }

    // Other components read it: its trembling may be all that moves them.
    void setRead(bool isRead) { isRead_ = isRead; }

    void startAt(double t, std::span<const double> values);
    // An unknown of another component that must be known for longer before the next step.
    [[nodiscard]] std::optional<std::size_t> waitsFor();
    void step();

    // Its next step is one of an explicit method that nothing watches and that reads no other: it
    // may be made beside those of others (side_by_side.h), as step() would make it.
    [[nodiscard]] bool mayGoSideBySide() const;
    [[nodiscard]] bool isInStride() const { return strides_ && method_ && !stop_; }
    [[nodiscard]] ExplicitRungeKutta& stride() const;
    [[nodiscard]] ErrorControl& control() { return control_; }
    [[nodiscard]] const ComponentEquations& equations() const { return *equations_; }
    // Where the next attempt is to end; none: there is more to it, for step().
    [[nodiscard]] std::optional<double> strideEnd() const;
    // False: no shorter one can be made. Then it is out of stride for endStride().
    [[nodiscard]] bool refuseStride(const Attempt& attempt, double h);
    void endStride(const Attempt& attempt, double h);
    // The accepted step, by its polynomials, which columns() takes.
    [[nodiscard]] std::span<Coefficients> columns() { return columns_; }
    void takeStride(double h, double to, double next);
    [[nodiscard]] bool changesAfterStride(double h, double crossing);
    void changeMethodAfterStride() { changeMethod(); }
    // With the values at time(), from where it steps by itself again.
    void leaveStride(std::span<const double> y);

    void backTo(double t);
    struct Jump {
        std::size_t place; // in unknowns()
        double value;
    };
    void restart(std::span<const Jump> jumps);
    // Both at once where that is next to nothing: a single unknown in closed form, whose rate is a
    // constant or another unknown, goes on to the end of time in one piece from its value at t, or
    // from `jump`. False: it is none of these, and nothing was done. The unknown that it reads must
    // go on so already.
    [[nodiscard]] bool resume(double t, std::optional<double> jump);
    // Of a single unknown in closed form that goes on for ever: its rate is a constant, or another
    // unknown.
    struct PlainRate {
        double constant = 0;
        std::optional<std::size_t> unknown; // it is that one
    };
    [[nodiscard]] const PlainRate* plainRate() const;
    // Others keep its motion from t on, until it goes on by itself along this polynomial of t -
    // origin.
    void leave(double t);
    void goOn(double origin, std::span<const double> coefficients);
    void end(Stop::Reason reason, const std::vector<std::size_t>& culprits,
             const std::string& sentence);

    // A later finish would have been hopeless (pace.h).
    [[nodiscard]] double hopelessBeyond() const { return hopelessBeyond_; }

    [[nodiscard]] ComponentStatistics statistics() const;
    [[nodiscard]] std::size_t evaluations() const;
    [[nodiscard]] std::size_t bytes() const; // beside its history, about
    [[nodiscard]] std::size_t checkpointBytesBefore(double t) const;

private:
    enum class Model { undecided, closedForm, linear, held, integrated };

    // Phases and regimes.
    void openRegime(bool withJumps);
    void takeEquations(std::vector<std::size_t> phases);
    void applyJumps();
    void makeControl();
    void begin(); // decides branches, drops the method, stands on an anchor
    void placeAnchor();
    void takeHeldValues();
    void findQuaternions();
    [[nodiscard]] std::vector<double> stateValues() const;
    void takeStates(std::vector<double>& y) const;
    void setStates(std::span<const double> y);
    void normalize();

    // Steps.
    [[nodiscard]] std::optional<std::size_t> look(std::size_t unknown, double target,
                                                  std::size_t joints, std::size_t& near);
    void decideModel();
    [[nodiscard]] bool tryClosedForm();
    struct PlainPiece {
        std::array<double, maximumCoefficients> row{};
        std::size_t count = 2;
        double scale = 1;
    };
    [[nodiscard]] std::optional<PlainPiece> plainPiece(double t, double value) const;
    void append(double t, const PlainPiece& piece);
    [[nodiscard]] bool stepPlainly();
    void stepClosedForm();
    [[nodiscard]] bool tryLinear();
    void stepLinear();
    [[nodiscard]] bool isUnseen(double h);
    void findPlainRate();
    void stepHeld();
    [[nodiscard]] bool isPaceDue() const;
    [[nodiscard]] bool isHopeless();
    void integrate();
    [[nodiscard]] bool beginMethod();
    [[nodiscard]] double longestFirst() const;
    [[nodiscard]] bool mayStride() const;
    [[nodiscard]] std::unique_ptr<Method> chooseMethod();
    void endWithoutRate(double t, std::span<const double> y);
    void finish(double to);
    [[nodiscard]] bool land(double to);
    [[nodiscard]] double longest() const; // that the next step may be, by what is watched
    [[nodiscard]] std::optional<double> overlooked(double h, double until);
    [[nodiscard]] bool isFollowed(double t, double h, double spacing);
    [[nodiscard]] bool hasCentres() const;
    [[nodiscard]] std::vector<double> centresIn(std::span<const Coefficients> states, double origin,
                                                double scale, double until);
    [[nodiscard]] std::vector<double> centresOf(const ComponentModel::PeakFunctions& peaks,
                                                std::span<const Coefficients> states, double origin,
                                                double scale, double until);
    [[nodiscard]] bool towers(double t, double h);
    [[nodiscard]] std::optional<double>
    besideCentre(double middle, double until, const std::function<bool(double)>& holds) const;
    void lookCloser(double at, double h);
    [[nodiscard]] std::optional<Violation> violationOfStep(double to, double h);
    [[nodiscard]] bool isInvented(const Violation& found, double h);
    [[nodiscard]] bool overflows();
    [[nodiscard]] bool refuse(const Attempt& attempt, double h);
    [[nodiscard]] bool stepAcross(double h);
    [[nodiscard]] bool passByRounding();
    [[nodiscard]] bool reachLastRate(double h);
    void stopAtUnderflow(Attempt::Outcome outcome, double h);
    void arrive(); // at limit_: a phase, an input's event, an input's end

    // Switches.
    [[nodiscard]] std::optional<Violation> violation(double from, double to, double scale,
                                                     std::span<const Coefficients> columns);
    void pass(const Violation& violation, bool immediate);
    void passWhereItIs(const Violation& violation);
    // Passes in a row, without time going on, that may go to and fro.
    [[nodiscard]] std::size_t patience() const { return equations_->watches() + 1; }
    [[nodiscard]] ComponentEquations::Passing passing(const Violation& violation, bool immediate);
    [[nodiscard]] bool comesToRest(std::vector<double>& y);
    [[nodiscard]] bool leaves(const Violation& found, double scale,
                              std::span<const Coefficients> columns);
    void settle();
    // Directions (component_rest.cpp).
    void takeReach(std::span<const double> y);
    void decideRest(std::vector<double>& y);
    [[nodiscard]] bool reachesRest();
    [[nodiscard]] double partOfWay(std::size_t direction, double length, double duration);
    [[nodiscard]] bool goToRest(std::size_t direction, double duration);
    [[nodiscard]] std::string switchingWith(const Violation& violation) const;

    // Pieces: `columns` of the states over [time_, until], polynomials of (t - time_)/scale.
    void append(std::span<const Coefficients> states, double scale, double until);
    struct Held;
    void takeLayout();
    [[nodiscard]] bool fitHeld(double until, double part, std::span<Coefficients> columns);

    void reconsider(double h);
    [[nodiscard]] double spectralRadius();
    void changeMethod();
    void keepCounts();
    void remember(); // a checkpoint at time_
    [[nodiscard]] std::string names(const std::vector<std::size_t>& places) const;

    Surroundings around_;
    const EquationsInForce& set_;
    const Histories& histories_;
    const Options& options_;
    std::vector<std::size_t> unknowns_;
    PieceWriter writer_;
    History& history_;
    double tolerance_;
    double longestPart_ = 1;            // of what is watched, that an explicit step may be
    std::vector<std::size_t> lookedAt_; // of each input, the step that the last one began in

    double time_ = 0;
    std::vector<double> values_; // of all unknowns at time_
    std::vector<double> y_;      // of the states, while a step ends
    std::vector<Coefficients> columns_;
    std::optional<Stop> stop_;

    std::vector<std::size_t> phases_;
    double phasesFrom_ = 0, nextPhase_ = infinity;
    std::unique_ptr<ComponentEquations> equations_;
    ErrorControl control_;
    History::Pairs pairs_;                              // columns, of equations_
    std::vector<std::size_t> places_, others_, all_;    // of them, of no pair, all
    std::vector<const Coefficients*> kept_;             // of each column, while one is appended
    std::vector<std::vector<std::size_t>> quaternions_; // places; without entries that stay 0

    bool isRead_ = true;
    double hopelessBeyond_ = infinity;
    Model model_ = Model::undecided;
    std::optional<PlainRate> plainRate_;
    std::unique_ptr<LinearMotion> linear_;
    double lost_ = 0; // by the rounding of time_, of the time to which linear motion has come
    std::unique_ptr<Method> method_;
    MethodChoice choice_;
    bool mayChange_ = false;       // the method, by cost
    bool strides_ = false;         // as long as it has this method
    double proposed_ = 0;          // length of the next step; 0: not known yet
    double limit_ = infinity;      // where the next step must end at the latest
    double restsAfter_ = infinity; // a length of the next step on this side of rest
    struct Falling {               // of a vector whose direction ends at rest, when last looked at
        double time, length, duration;
        double part; // of the way to rest that a step may go
    };
    std::map<std::size_t, Falling> falling_; // by direction
    bool limitRestarts_ = false;             // an input restarts at limit_
    std::optional<std::size_t> ends_;        // an input's motion ends at limit_
    WatchedTimes watched_;
    double suspect_ = -infinity; // a watched time that a step passed over
    int invented_ = 0;           // switches in a row that were not believed
    SwitchLog switches_;

    // The state that later steps depend on besides the values, for going back.
    struct Checkpoint {
        double time;
        std::vector<std::size_t> phases;
        ErrorControl control;
        MethodChoice choice;
    };
    std::vector<Checkpoint> checkpoints_;

    ComponentStatistics counts_;
};

} // namespace solution
