// A model of a component proposes its steps; the component accepts them, all in one place
// (Component::accept()).
//
// Models, least first: `closed-form` (exact/closed_form.h), `linear` (exact/linear_motion.h), held
// values alone, rest, and integration by a method, which is `quadrature` (a single unknown whose
// rate reads time and other components only), `explicit` or `implicit` (method_choice.h).
#pragma once

#include "dense/piece_writer.h"
#include "equations/equations_in_force.h"
#include "modes/component_equations.h"
#include "modes/switch_log.h"
#include "oversight/oversight.h"
#include "stepping/boundary.h"
#include "stepping/memory.h"
#include "stepping/options.h"
#include "stepping/progress.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace solution {

// The motion of a component from where it is, to be accepted. Spans hold until the next proposal.
struct StepPiece {
    // From the component's time; of no length where it is changed in place.
    StateCurves curves;
    // The states at its end. None: they stay as they are, or are kept elsewhere.
    std::optional<std::span<const double>> end = std::nullopt;
    // Polynomials of held values that the model knows; none: the writer finds them.
    std::optional<std::span<const Coefficients>> held = std::nullopt;
    enum class Kind {
        nothing,   // no time goes on: nothing is written
        uncounted, // as long as a formula holds
        step,
        integrated, // by a method
        atRest      // no step, but another tolerance may find it moving
    };
    Kind kind = Kind::uncounted;
    const Violation* crossing = nullptr; // switches to be passed at its end; none: null
    // The model begins anew at its end: directions are held that were not before, or a contact
    // changes shortly after.
    bool endsAnew = false;
    double next = 0; // how long the step after that is; 0: not known
};
struct SwitchAtOnce { // before any time goes on
    Violation violation;
};
struct Ending {
    Stop::Reason reason;
    std::vector<std::size_t> culprits; // places of unknowns
    std::string sentence;
};
struct NextModel {}; // this one cannot go on from here
struct TryAgain {};  // the next step is proposed otherwise
using Proposal = std::variant<StepPiece, SwitchAtOnce, Ending, NextModel, TryAgain>;

// The parts of a component that its models step with; all outlive them.
struct StepContext {
    const Options& options;
    const EquationsInForce& set;
    const std::vector<std::size_t>& unknowns;
    double tolerance;
    const std::unique_ptr<ComponentEquations>& inForce;
    const Boundary& boundary;
    const History& history;
    Progress& progress;
    Memory& memory;
    SwitchLog& switches;
    Oversight& oversight;
    ComponentStatistics& counts;

    [[nodiscard]] ComponentEquations& equations() const { return *inForce; }
    [[nodiscard]] ErrorControl& control() const { return memory.now.control; }
    [[nodiscard]] double time() const { return progress.time; }
    [[nodiscard]] double limit() const { return boundary.limit(); }
    [[nodiscard]] std::vector<double> states() const { return progress.at(equations().states()); }

    // The first switch on these curves.
    [[nodiscard]] std::optional<Violation> violationOn(const StateCurves& curves) const;
    // Passings in a row, without time going on, that may go to and fro.
    [[nodiscard]] std::size_t patience() const { return equations().watches() + 1; }
    // A switch on these curves is passed where they begin: the component is on the wrong side
    // there, or stood on a surface and has left it.
    [[nodiscard]] bool passesAtOnce(const Violation& found, const StateCurves& curves) const;
    // The right-hand side has no value at t, y: for which unknowns, or does nothing slide?
    [[nodiscard]] Ending endingWithoutRate(double t, std::span<const double> y) const;
    // Conditions of these multipliers contradict each other; none: it is not known which do.
    [[nodiscard]] Ending endingOf(std::vector<std::size_t> contradictory) const;
    [[nodiscard]] std::string names(const std::vector<std::size_t>& places) const;
};

// Shortly before t, in a step from `origin`: near its beginning the polynomial of a step errs by
// next to nothing, and what is left of it is more than what a projection moves, so that what is at
// t still lies ahead. Nothing: no time would be left.
[[nodiscard]] std::optional<double> shortlyBefore(double t, double origin);

class StepModel {
public:
    virtual ~StepModel() = default;
    // The next step, at most to the boundary.
    [[nodiscard]] virtual Proposal propose() = 0;
    // Its last piece was accepted and ended in no switch: `y` are the states there. A switch to be
    // passed at its end, an ending, or neither.
    using Afterwards = std::variant<std::monostate, Violation, Ending>;
    [[nodiscard]] virtual Afterwards goOn(std::span<const double> /*y*/) { return {}; }
    // It knows how long its next step is.
    [[nodiscard]] virtual bool looksAhead() const { return false; }
};

} // namespace solution
