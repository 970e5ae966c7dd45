// The equations of one component while no phase of its unknowns begins or ends: y' = f(t, y), held
// values h(t, y), and the branches of switching expressions that are in force.
//
// Held values are put into the derivatives symbolically, so that f reads time, the differential
// unknowns (states) and other components only. The Jacobian is derived symbolically.
//
// mode.h says what a mode is, held_field.h what the right-hand side is in one, guards.h what ends
// it, mode_solver.h and stick_slip.h what the next one is.
#pragma once

#include "integrators/system.h"
#include "modes/mode_solver.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace solution {

class ComponentEquations final : public System {
public:
    using Crossing = ModeSolver::Crossing;
    using Passing = ModeSolver::Passing;
    using Approach = StickSlip::Approach;

    // `bound` is shared with other runs over the same equations; here is what a run changes.
    ComponentEquations(std::shared_ptr<const BoundModel> bound, const Histories& histories);
    ComponentEquations(const ComponentEquations&) = delete;
    ComponentEquations& operator=(const ComponentEquations&) = delete;

    // Places in the component's unknowns of the differential ones and of the held ones, in order of
    // evaluation.
    [[nodiscard]] const std::vector<std::size_t>& states() const { return bound()->states; }
    [[nodiscard]] const std::vector<std::size_t>& held() const { return bound()->held; }
    [[nodiscard]] const std::vector<std::size_t>& multipliers() const {
        return bound()->multipliers;
    }
    // Of the last rates().
    [[nodiscard]] std::span<const double> multiplierValues() {
        return field_.multipliers().values();
    }
    // How they were found: a clause; "": there are none.
    [[nodiscard]] std::string howMultipliersAreFound() const { return field_.multipliers().how(); }
    // For readers, which ask at any times in any order.
    void solveMultipliersInSteps() { field_.multipliers().solveInSteps(); }
    // Moves the states onto the conditions that multipliers keep.
    void project(double t, std::span<double> y);
    // Held unknowns whose values depend on each other in a circle; then no other function may be
    // called.
    [[nodiscard]] const std::vector<std::size_t>& loop() const { return bound()->loop; }
    [[nodiscard]] Inputs& inputs() { return functions_.inputs(); }
    [[nodiscard]] bool readsInputs() const { return readsInputs_; }
    [[nodiscard]] const ComponentModel& model() const { return *mode_.model; }
    [[nodiscard]] const std::shared_ptr<const BoundModel>& bound() const {
        return functions_.bound();
    }

    // Nothing switches and nothing is held.
    [[nodiscard]] bool isPlain() const { return isPlain_; }
    [[nodiscard]] std::span<const double> constants() const {
        return std::span(functions_.in()).subspan(model().variables(), model().constants());
    }

    // System, for the integrators.
    [[nodiscard]] std::size_t size() const override { return states().size(); }
    [[nodiscard]] bool rates(double t, std::span<const double> y, std::span<double> out) override;
    [[nodiscard]] double* place() override {
        return isPlain_ || field_.findsRatesAtOnce() ? functions_.in().data() + 1 : nullptr;
    }
    [[nodiscard]] Direct direct() override {
        if (!isPlain_ || !functions_.code().entry)
            return {};
        return {functions_.code(), functions_.in().data(), functions_.scratch().data(),
                readsInputs_ ? this : nullptr};
    }
    void putInputs(double t) override { functions_.putInputs(t); }
    [[nodiscard]] const Pattern& jacobianPattern() override;
    [[nodiscard]] bool jacobian(double t, std::span<const double> y,
                                std::span<double> entries) override;
    [[nodiscard]] std::span<const std::pair<std::size_t, std::size_t>> integrals() const override {
        return model().integrals();
    }
    [[nodiscard]] std::span<const std::size_t> configuration() const override {
        return model().configuration();
    }

    // Values of the held unknowns. False: not finite.
    [[nodiscard]] bool heldValues(double t, std::span<const double> y, std::span<double> out);
    // Sliding had no solution when rates() was asked last: then that is why it failed.
    [[nodiscard]] bool slidingFailed() const { return slidingFailed_; }
    // No forces keep the conditions of multipliers there.
    [[nodiscard]] bool isContradictory() const { return field_.isContradictory(); }
    // Places in `unknowns` of multipliers whose conditions no forces, and after project() no
    // velocities, keep together; and of those off which places were before project(), since
    // forgetApart().
    [[nodiscard]] std::vector<std::size_t> contradictory() const {
        return placesOf(field_.multipliers().contradictory());
    }
    [[nodiscard]] std::vector<std::size_t> apart() const {
        return placesOf(field_.multipliers().apart());
    }
    [[nodiscard]] std::vector<std::size_t> farApart() const {
        return placesOf(field_.multipliers().farApart());
    }
    // Places in `unknowns` of multipliers whose bounds are violated.
    [[nodiscard]] std::vector<std::size_t> boundedOf(const Violation& violation) const {
        return placesOf(guards_.multipliersOf(violation));
    }
    void forgetApart() { field_.multipliers().forgetApart(); }
    // A stage of a step that starts on a surface, as from rest where drag is v sqrt(abs(v)), may
    // lie a little beyond it, where the branch that holds has no value. From now on rates() takes
    // the other one there, until lookNoMoreBeyond(). False: it does already, or no surface is here.
    [[nodiscard]] bool lookBeyond(double t, std::span<const double> y);
    void lookNoMoreBeyond() { mode_.looksBeyond = false; }
    // Places in `unknowns` of those whose rate or value is not finite.
    [[nodiscard]] std::vector<std::size_t> notFinite(double t, std::span<const double> y);

    // The outputs, for models in closed form: rates of states, then held values. All nodes are of
    // this graph, which holds nothing else: its bits depend on the component alone.
    [[nodiscard]] const expression::Graph& graph() const { return model().graph(); }
    [[nodiscard]] expression::Node time() const { return model().symbols()[0]; }
    [[nodiscard]] std::span<const expression::Node> outputs() const { return model().outputs(); }
    [[nodiscard]] const ModelFunctions& functions() const { return functions_; }
    [[nodiscard]] ModelFunctions& functions() { return functions_; }
    [[nodiscard]] bool readsStates() const { return model().readsStates(); }

    // Branches.
    [[nodiscard]] const Mode& mode() const { return mode_; }
    // Whether conditions of multipliers hold, as their histories keep it.
    [[nodiscard]] std::vector<double> kept() const;
    void takeKept(std::span<const double> states);
    // With conditions that hold as these say, for this question alone: Multipliers::isOff(), and of
    // `all` conditions areOffPlaces(), too.
    enum class Conditions { ofContacts, all };
    [[nodiscard]] bool isOff(double t, std::span<const double> y, std::span<const double> kept,
                             Conditions asked = Conditions::ofContacts);
    // A contact closes or loses its place on a step's polynomials, and elsewhere on states that the
    // conditions hold.
    [[nodiscard]] bool movesContacts(const Violation& violation, std::span<const double> y);
    // It has done so before t, on states that the conditions hold.
    [[nodiscard]] bool hasMovedContacts(const Violation& violation, double t,
                                        std::span<const double> y);
    // Contacts that slip slower than that rest (active_set.h).
    void setSlow(const ActiveSet::Slow& slow) { active_.setSlow(slow); }
    // A contact slips.
    [[nodiscard]] bool slips() const { return active_.slips(); }
    [[nodiscard]] bool slipsSlowly() const { return active_.slipsSlowly(); }
    // How friction turns slips about there; not at all where the equations have no rates.
    using Turns = Multipliers::Turns;
    [[nodiscard]] Turns turns(double t, std::span<const double> y);
    // Contacts that slip do so as these states move.
    void takeSlips(double t, std::span<const double> y) { active_.takeSlips(t, y); }
    // Forces of slips are sought from those at the end of a step on (ActiveSet::followCentres).
    void followCentres(double t, std::span<const double> y) { active_.followCentres(t, y); }
    // Conditions are gone for ever where these values, by place, say so. True: some went now.
    [[nodiscard]] bool release(std::span<const double> values);
    // As takeKept(), but for those that are gone alone.
    void takeGone(std::span<const double> values);
    // Its conditions are put together from blocks (equations/composition.h).
    [[nodiscard]] bool isComposed() const { return bound()->composed != nullptr; }
    // On surfaces, or held at 0 where directions have none.
    [[nodiscard]] bool sliding() const { return mode_.isHeld(); }
    [[nodiscard]] std::size_t watches() const { return guards_.size(); }
    [[nodiscard]] Guards& guards() { return guards_; }
    [[nodiscard]] const Guards& guards() const { return guards_; }
    [[nodiscard]] ModeSolver& solver() { return solver_; }

    // Directions.
    [[nodiscard]] bool hasDirections() const { return !model().directions().ranges.empty(); }
    [[nodiscard]] StickSlip& stickSlip() { return stick_; }
    // Those whose vector is 0, but for rounding.
    [[nodiscard]] std::vector<std::size_t> directionsAtRest(double t, std::span<const double> y) {
        return field_.directionsAtRest(t, y);
    }
    // As StickSlip::rest(), with the guards of the mode that it leaves.
    [[nodiscard]] bool rest(std::span<const std::size_t> directions, double t, std::span<double> y);

private:
    [[nodiscard]] std::vector<std::size_t> placesOf(const std::vector<std::size_t>& rows) const {
        std::vector<std::size_t> places;
        places.reserve(rows.size());
        for (const std::size_t row : rows)
            places.push_back(multipliers()[row]);
        return places;
    }
    void fillProjected(double t, std::span<const double> y);
    // By states, by columns: of second rates with multipliers as they are, then of multipliers; and
    // of the values of Conditions::gaps.
    struct MultiplierSlopes {
        Eigen::MatrixXd second, gaps;
    };
    void differentiate(std::span<double> entries, MultiplierSlopes& slopes);
    void addMultipliers(MultiplierSlopes& slopes, std::span<double> entries);
    [[nodiscard]] bool differences(double t, std::span<const double> y, std::span<double> entries);

    Mode mode_;
    ModelFunctions functions_;
    HeldField field_;
    StickSlip stick_;
    ActiveSet active_;
    Guards guards_;
    ModeSolver solver_;
    bool slidingFailed_ = false;
    bool isPlain_;     // nothing switches and nothing is held
    bool readsInputs_; // of other components
};

} // namespace solution
