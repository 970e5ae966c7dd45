// The multipliers of conditions (component_model.h, Conditions) at one point: forces of joints.
//
//     A m = -b     so that all second rates  g'' = A m + b  are 0.
//
// A = J M^-1 J' for joints between bodies. Those of ties are 0. held_conditions.h solves for m; a
// condition that nothing can keep, as a joint between two bodies that are held, has no solution.
//
// Places and velocities drift off their conditions by the errors of steps. project() moves them
// back by what the multipliers push, the least way in the metric of the kinetic energy (Hairer and
// Wanner, Solving Ordinary Differential Equations II, VII.2): places by Newton's method until
// rounding is left, then velocities.
#pragma once

#include "modes/composed_conditions.h"
#include "modes/disc_friction.h"
#include "modes/held_conditions.h"
#include "modes/mode.h"
#include "modes/model_functions.h"
#include "modes/slip_forces.h"

#include <Eigen/Core>

#include <algorithm>
#include <span>
#include <vector>

namespace solution {

class Multipliers {
public:
    // `mode` outlives them, and says which conditions hold.
    Multipliers(ModelFunctions& functions, const Mode& mode)
        : f_(functions), model_(modelOf(*functions.bound())), mode_(mode),
          conditions_(conditionsOf(*functions.bound())),
          held_(conditions_, *functions.bound(), mode), friction_(*functions.bound(), mode, gaps_),
          slips_(conditions_, friction_) {
        if (functions.bound()->composed)
            composed_.emplace(functions);
    }
    Multipliers(const Multipliers&) = delete;
    Multipliers& operator=(const Multipliers&) = delete;

    [[nodiscard]] std::size_t size() const { return conditions_.isTie.size(); }
    // Puts them into the point of the functions, on the branches of the mode. False: none keep the
    // conditions that hold; then they are what errs least.
    bool solve();
    // The same, and as many of the model's outputs with them, where machine code has both: where
    // all conditions hold always, and it finds that it keeps them. False: it has not.
    [[nodiscard]] bool solveWith(std::span<double> outputs);
    // There is such code, and the mode is one that it knows. It is made, or refused for good, at
    // the first point that is solved for.
    [[nodiscard]] bool areSolvedAtOnce() const {
        return atOnce_.model && areAllInside() && mode_.sticking.empty();
    }
    // Never by such code, as for readers at any times in any order: the way then depends on the
    // point alone.
    void solveInSteps() { atOnce_.isDecided = true; }
    // At the point that was solved for last, once linearise() was called, how they change where the
    // point does. `change`: of second rates with multipliers as they are; then of the multipliers.
    // `gaps`: of the values of Conditions::gaps.
    void linearise();
    void change(std::span<const double> gaps, Eigen::Ref<Eigen::VectorXd> change);
    // As Conditions::moves.
    [[nodiscard]] std::span<const double> moves() {
        evaluateMoves();
        return moves_;
    }
    // Null: the conditions are one expression.
    [[nodiscard]] ComposedConditions* composed() { return composed_ ? &*composed_ : nullptr; }
    // The last solve() found forces that keep what holds, and those of slips follow the forces that
    // they change.
    [[nodiscard]] bool areFound() const { return areFound_; }
    // Conditions that hold are redundant there.
    [[nodiscard]] bool isRedundant() const { return !held_.isRegular(); }
    // How the last forces were found: a clause; "": there are none.
    [[nodiscard]] std::string how() const;
    [[nodiscard]] std::span<const double> values() const { return std::span(f_.in()).last(size()); }
    // Rates without multipliers, at the point of the last solve(), get what these add, where the
    // model has no multipliers.
    void addForces(std::span<double> rates) const {
        if (composed_)
            composed_->addForces(rates);
    }
    void put(std::size_t row, double value) { f_.in()[f_.in().size() - size() + row] = value; }
    // The answer of the last solve(): the values, and the second rates of the conditions.
    struct Solution {
        std::vector<double> values, second;
    };
    [[nodiscard]] Solution solution() const {
        return {{values().begin(), values().end()}, second_};
    }
    void take(const Solution& solution);
    // Of stops, contacts and friction that hold, a gap or a rate is not 0 but for rounding: so it
    // is within a step, whose polynomials know no conditions. Once gaps are evaluated.
    [[nodiscard]] bool isOff(std::span<const double> y) const;
    // Places are off the conditions that hold, those of joints, too, by more than their resolution.
    // Once gaps are evaluated.
    [[nodiscard]] bool areOffPlaces() const;
    // Moves the states onto the conditions that hold.
    void project(double t, std::span<double> y);
    // Conditions that no forces, and after project() no velocities, keep together with the others.
    [[nodiscard]] const std::vector<std::size_t>& contradictory() const {
        return unheld_.contradictory;
    }
    // Conditions without bounds off which places were by more than rounding, before project() moved
    // them, since forgetApart().
    [[nodiscard]] const std::vector<std::size_t>& apart() const { return unheld_.apart; }
    void forgetApart() {
        unheld_.apart.clear();
        unheld_.farApart.clear();
    }
    // The same for a motion that went on: by more than the errors of any steps.
    [[nodiscard]] const std::vector<std::size_t>& farApart() const { return unheld_.farApart; }

    // All velocities that multipliers push become 0 if they are 0 but for this.
    void rest(double none, std::span<double> y) const;
    // Rates of velocities, where all of these are 0, are 0 if forces cancel but for rounding: what
    // is at rest stays there to the last bit. After solve().
    void balance(std::span<const double> y, std::span<double> rates);

    // The largest of the velocities that multipliers push.
    [[nodiscard]] double fastest(std::span<const double> y) const;

    // Gaps and their rates at the point of the functions, once evaluated.
    void evaluateGaps();
    [[nodiscard]] double gap(std::size_t row) const { return gaps_[row]; }
    [[nodiscard]] double rate(std::size_t row) const { return gaps_[size() + row]; }
    // A contact that lasts only at some places: the first of the functions that are not negative
    // while it does, and the one behind the last; then the value of one of them.
    [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> confines(std::size_t row) const {
        const std::vector<std::uint32_t>& first = conditions_.firstValid;
        return {first[row], first[row + 1]};
    }
    [[nodiscard]] double confine(std::uint32_t which) const { return gaps_[2 * size() + which]; }
    // Once gaps are evaluated.
    [[nodiscard]] const DiscFriction& friction() const { return friction_; }
    // After solve(): of a condition, whether it holds or not.
    [[nodiscard]] double secondRate(std::size_t row) const;
    // After solve(): the largest second rate that the force of a contact gives its own gap.
    [[nodiscard]] double weight() const;
    // After solve(): how friction turns slips about. It acts against the slip, so that what a slip
    // has across its way fades with the rate  mu N A / |slip|, A being the second rate that a force
    // of 1 gives. Of slow slips the fastest of these is the largest eigenvalue of the Jacobian.
    struct Turns {
        double fastest = 0;
        // The slip that comes to rest first along the rates that it has here, of those that turn
        // many times on that way: explicit steps would become ever shorter there.
        struct Stop {
            std::size_t disc;
            double duration; // up to where so little is left of it
        };
        std::optional<Stop> stop = std::nullopt;
    };
    [[nodiscard]] Turns turns();
    // Second rates of these conditions as matrix times their multipliers and a rest, in which the
    // others stand at their bounds; those that are not on second rates have their own values.
    struct System {
        Eigen::MatrixXd matrix;
        Eigen::VectorXd rest;
    };
    [[nodiscard]] System systemOf(std::span<const std::size_t> rows);
    // Moves the velocities as these impulses do.
    void push(std::span<const std::size_t> rows, const Eigen::VectorXd& impulses,
              std::span<double> y);

private:
    [[nodiscard]] std::optional<double> stopOf(std::size_t disc) const;
    [[nodiscard]] bool holds(std::size_t row) const {
        return mode_.kept[row] == complementarity::State::inside;
    }
    [[nodiscard]] bool holdAlways() const;
    [[nodiscard]] bool areAllInside() const {
        return std::ranges::all_of(mode_.kept, [](complementarity::State kept) {
            return kept == complementarity::State::inside;
        });
    }
    [[nodiscard]] bool areSolvedAtOnceHere();
    void evaluate();
    [[nodiscard]] std::span<const double> matrix() const { // once evaluated
        return std::span(second_).first(conditions_.matrix.size());
    }
    [[nodiscard]] bool factorise();
    [[nodiscard]] bool solveHeld();
    [[nodiscard]] bool factoriseMoves();
    [[nodiscard]] double bound(std::size_t row) const;
    void addBounds();
    [[nodiscard]] bool isSolved();
    void findApart();
    [[nodiscard]] bool findContradictory(std::span<const double> y);
    void move(std::span<const ComponentModel::Entry> entries, std::size_t first,
              const Eigen::VectorXd& by, std::span<double> y) const;
    void evaluateMoves();
    [[nodiscard]] double largestGap() const;
    [[nodiscard]] double placesOff();
    [[nodiscard]] double leftOff();
    [[nodiscard]] bool solveRates();
    [[nodiscard]] bool solveForGaps();
    [[nodiscard]] bool moveOntoGaps(double t, std::span<double> y);
    [[nodiscard]] bool moveOntoConditions(double t, std::span<double> y);

    ModelFunctions& f_;
    const ComponentModel& model_;
    const Mode& mode_;
    const ComponentModel::Conditions& conditions_;
    std::optional<ComposedConditions> composed_;
    HeldConditions held_;
    std::vector<double> second_, ties_, gaps_, moves_;
    DiscFriction friction_;
    SlipForces slips_;
    bool areFound_ = true;
    struct AtOnce {
        bool isDecided = false;                        // whether there is a model
        const ComponentModel::Solved* model = nullptr; // none: never
        bool isLast = false;                           // it made the last solution
        bool projects = false;                         // project() uses it now
        std::vector<double> in, values; // symbols at the point of the matrix, and rates; outputs
        std::vector<double> before;     // states before project(), for another way
        [[nodiscard]] bool isPositive(std::size_t first) const {
            bool isPositive = true;
            for (std::size_t k = first; k < values.size(); ++k)
                isPositive = isPositive && values[k] > 0;
            return isPositive;
        }
    } atOnce_;
    Eigen::VectorXd rest_, found_; // second rates without the multipliers that hold; by row
    struct Unheld {                // rows
        std::vector<std::size_t> apart, farApart, contradictory;
    } unheld_;
};

} // namespace solution
