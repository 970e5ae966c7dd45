// The right-hand side of a component in a mode: rates of states, and held values.
//
// While nothing is held it is what the branches of the mode say. With f- and f+ the fields of both
// sides of a surface that is slid upon (Filippov 1988) it is
//
//     f = f- + w (f+ - f-),   w such that grad g . f + dg/dt = 0;
//
// several such surfaces at once give a linear system for their weights. Where a state is itself the
// guard, its rate is set to 0, so that it stays exactly.
//
// Directions. With a the vector whose direction it is, scaled by the roots of its weights, and u
// what stands for a/|a| while a is held at 0: expressions of a/|a| are evaluated with u times next
// to nothing for a and next to nothing for |a|.
//
// All is at the point of the functions (model_functions.h). Branches of the mode are tried; what is
// slid upon is on its lower side afterwards, as Mode has it.
//
// LIMIT: with several surfaces at once f is taken as affine in the weights, which holds unless
// switching terms multiply each other or stand in each other's guards.
#pragma once

#include "modes/multipliers.h"

#include <optional>
#include <span>
#include <vector>

namespace solution {

class HeldField {
public:
    HeldField(ModelFunctions& functions, Mode& mode);

    // On the branches of the mode, whether it slides or not.
    void outputs(std::span<double> out);
    // In the mode, with the weights and units of the functions: false where it slides and has no
    // solution. Then values() are others, and there are no weights.
    [[nodiscard]] bool weigh();
    // values() in the mode; where it slides and has no solution, on its branches.
    void find();
    // Rates of a model without held values, without values(). False: they are to be had by find().
    [[nodiscard]] bool findRatesAtOnce(std::span<double> rates) {
        const bool isFound = !mode_.isHeld() && model_.held() == 0 && multipliers_.solveWith(rates);
        isContradictory_ = isContradictory_ && !isFound;
        return isFound;
    }
    // findRatesAtOnce() finds them, but at points where the code refuses itself.
    [[nodiscard]] bool findsRatesAtOnce() const {
        return !mode_.isHeld() && model_.held() == 0 && multipliers_.areSolvedAtOnce();
    }
    [[nodiscard]] std::vector<double> here() {
        find();
        return values_;
    }
    [[nodiscard]] const std::vector<double>& values() const { return values_; }
    // outputs() into values().
    void findOutputs() { outputs(values_); }
    // The outputs are values(), by the branches that guards have where those in force have none.
    void findBeyond();
    [[nodiscard]] std::size_t size() const { return values_.size(); }
    // Of the last outputs(): no multipliers keep the conditions.
    [[nodiscard]] bool isContradictory() const { return isContradictory_; }
    [[nodiscard]] Multipliers& multipliers() { return multipliers_; }
    [[nodiscard]] const Multipliers& multipliers() const { return multipliers_; }

    // Directions whose vector is 0, but for rounding, and is not held there.
    [[nodiscard]] std::vector<std::size_t> directionsAtRest(double t, std::span<const double> y);
    // Of the square of a unit vector, over what can be.
    [[nodiscard]] double excess(std::size_t direction) const;
    // Of a direction that sets off: the rate of its vector, and that without friction.
    [[nodiscard]] double growth() const { return growth_; }
    [[nodiscard]] double pull() const { return pull_; }

    // a' = rate + change u
    struct Response {
        Eigen::VectorXd rate;
        Eigen::MatrixXd change;
        std::vector<std::vector<double>> fields; // change of all rates by each u
        struct Departure {
            Eigen::VectorXd direction;
            double growth;
        };
        // It draws a to 0, or does nothing, whatever the direction.
        [[nodiscard]] bool brakes() const;
        // The d of length 1 for which rate + change d is l d.
        [[nodiscard]] std::optional<Departure> departure() const;
    };
    // Of a direction that is held, while all else that is held stays so.
    [[nodiscard]] std::optional<Response> responseOf(std::size_t direction);

    struct Column { // of what is solved for while sliding
        bool isPart;
        std::size_t which; // surface, or part
    };
    [[nodiscard]] std::vector<Column> columns() const;
    [[nodiscard]] const ComponentModel::Gradient& gradientOf(const Column& column) const;

private:
    // Less is what next to nothing makes of a rate of 0: in proportion to it, to its square or to
    // its cube root.
    static constexpr double vanishing = 1e-40;

    void evaluateOutputs(std::span<double> out);
    // outputs(), and behind them the multipliers.
    void outputsAndForces(std::vector<double>& out);
    // values() and the multipliers, by these weights of fields beside that of the base.
    void mixFields(std::span<const double> weights);
    [[nodiscard]] bool mix(std::span<const double> weights);
    void setColumn(const Column& column, bool isSet);
    [[nodiscard]] double rateOf(const Column& column, std::span<const double> rates);
    [[nodiscard]] bool weighWithDirections();
    [[nodiscard]] bool solveWithDirections();

    ModelFunctions& f_;
    const ComponentModel& model_;
    Mode& mode_;
    Multipliers multipliers_;
    bool isContradictory_ = false;
    std::vector<double> values_;
    std::vector<double> base_;                // fields on one side of surfaces, with multipliers
    std::vector<std::vector<double>> fields_; // on the other side of each
    std::optional<std::size_t> given_; // of what sticks, a direction whose units are not solved for
    double growth_ = 0, pull_ = 0;
};

// The shortest of several solutions.
[[nodiscard]] Eigen::VectorXd leastSolution(const Eigen::MatrixXd& matrix,
                                            const Eigen::VectorXd& wanted);

} // namespace solution
