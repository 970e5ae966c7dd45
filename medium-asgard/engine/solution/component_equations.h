// The equations of one component while no phase of its unknowns begins or ends: y' = f(t, y), held
// values h(t, y), and the branches of switching expressions that are in force.
//
// Held values are put into the derivatives symbolically, so that f reads time, the differential
// unknowns (states) and other components only. The Jacobian is derived symbolically.
//
// Sides of surfaces (switching.h). A surface is passed when the field behind it leads away from it.
// When it leads back, motion slides on the surface (Filippov 1988): with f- and f+ the fields of
// both sides,
//
//     f = f- + w (f+ - f-),   w such that grad g . f + dg/dt = 0,
//
// until w leaves [0, 1]; several such surfaces at once give a linear system for their weights. This
// is how a block that friction stops stays where it is. Where a state is itself the guard, its rate
// is set to 0, so that it stays exactly.
//
// LIMIT: with several surfaces at once f is taken as affine in the weights, which holds unless
// switching terms multiply each other or stand in each other's guards. On floor and ceil nothing
// slides. Such motion ends with a reason when it cannot go on.
#pragma once

#include "expression/equations.h"
#include "expression/tape.h"
#include "solution/inputs.h"
#include "solution/partition.h"
#include "solution/switching.h"
#include "solution/system.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace solution {

class ComponentEquations final : public System {
public:
    // `phases[i]` is the phase of unknowns[i] that is in force. What stays 0 is put in as a 0.
    ComponentEquations(const expression::EquationSet& set, const UnknownIndex& index,
                       const Histories& histories, const ZeroStates& zero,
                       std::vector<std::size_t> unknowns, std::span<const std::size_t> phases);

    // Places in `unknowns` of the differential ones and of the held ones, in order of evaluation.
    [[nodiscard]] const std::vector<std::size_t>& states() const { return states_; }
    [[nodiscard]] const std::vector<std::size_t>& held() const { return held_; }
    // Held unknowns that are defined by each other; then nothing else may be asked.
    [[nodiscard]] const std::vector<std::size_t>& loop() const { return loop_; }
    [[nodiscard]] Inputs& inputs() { return inputs_; }

    // System, for the integrators.
    [[nodiscard]] std::size_t size() const override { return states_.size(); }
    [[nodiscard]] bool rates(double t, std::span<const double> y, std::span<double> out) override;
    [[nodiscard]] const Pattern& jacobianPattern() override;
    [[nodiscard]] bool jacobian(double t, std::span<const double> y,
                                std::span<double> entries) override;
    [[nodiscard]] std::span<const std::pair<std::size_t, std::size_t>> integrals() const override {
        return integrals_;
    }
    [[nodiscard]] std::span<const std::size_t> configuration() const override {
        return configuration_;
    }

    // Values of the held unknowns. False: not finite.
    [[nodiscard]] bool heldValues(double t, std::span<const double> y, std::span<double> out);
    // Sliding had no solution when rates() was asked last: then that is why it failed.
    [[nodiscard]] bool slidingFailed() const { return slidingFailed_; }
    // Places in `unknowns` of those whose rate or value is not finite.
    [[nodiscard]] std::vector<std::size_t> notFinite(double t, std::span<const double> y);

    // What the outputs are, for models in closed form: rates of states, then held values. All nodes
    // are of this graph, which holds nothing else: its bits depend on the component alone.
    [[nodiscard]] const expression::Graph& graph() const { return graph_; }
    [[nodiscard]] expression::Node time() const { return symbols_[0]; }
    [[nodiscard]] std::span<const expression::Node> outputs() const { return outputs_; }
    [[nodiscard]] std::optional<expression::Decision> decisionOf(expression::Node switching) const;
    [[nodiscard]] std::optional<std::size_t> inputOf(expression::Node symbol) const;
    [[nodiscard]] bool readsStates() const { return readsStates_; } // other than in guards

    // Branches. decide() is from the values alone, with what the fields say on a surface itself.
    void decide(double t, std::span<double> y);
    [[nodiscard]] std::size_t watches() const { return watches_.size(); }
    void watch(double t, std::span<const double> y, std::span<double> values);
    enum class Crossing { done, impossible };
    // Passes the surfaces of those watches, or slides on them; y is put onto surfaces of sliding.
    [[nodiscard]] Crossing cross(const Violation& violation, double t, std::span<double> y,
                                 bool insist);
    [[nodiscard]] bool sliding() const { return !sliding_.empty(); }
    // Unknowns (places) that the guards of these watches read.
    [[nodiscard]] std::vector<std::size_t> unknownsOf(const std::vector<std::size_t>& watches);

private:
    struct Watch {
        enum class Kind { side, least, most } kind; // least, most: of a weight
        std::size_t surface;
    };
    // A tape of derived expressions, on the branches that are in force for the equations.
    struct Derived {
        expression::Tape tape;
        struct Source { // of each of its decisions
            std::optional<std::size_t> decision, surface;
            int orientation = 1;
        };
        std::vector<Source> sources;
        std::vector<expression::Decision> decisions;
        expression::Tape::Scratch scratch;
    };
    struct Gradient {
        Derived derivatives;              // dg/dt, dg/dy, dg/dinputs; then g
        std::optional<std::size_t> state; // g is this state itself
    };
    static constexpr int onSurface = 0;

    void orderHeld(const ZeroStates& zero, std::span<const std::size_t> phases);
    void makeOutputs(const ZeroStates& zero, std::span<const std::size_t> phases);
    void makeTape();
    void findIntegrals();
    void findConfiguration();
    void fill(double t, std::span<const double> y);
    void evaluate(std::span<double> out);
    void setSide(std::size_t surface, int side);
    void refreshWatches();
    [[nodiscard]] Gradient& gradient(std::size_t surface);
    struct Slope {
        double rate;
        double noise; // what rounding may make of a rate of 0
        double near;  // and of a guard of 0, where its root was located
        double value; // the guard
    };
    [[nodiscard]] Derived derive(expression::Graph& graph, std::span<const expression::Node> nodes);
    void evaluate(Derived& derived, std::span<double> out) const;
    [[nodiscard]] Slope guardRate(std::size_t surface, std::span<const double> rates);
    [[nodiscard]] bool weigh(); // weights_ and rates of sliding at what fill() was given
    void settleOn(std::size_t surface);
    void field(); // rates into out_, whether sliding or not
    [[nodiscard]] double guard(std::size_t surface) const; // after evaluating guards_
    [[nodiscard]] bool isRight(std::size_t surface);
    [[nodiscard]] expression::Decision wholeBranch(std::size_t surface,
                                                   std::span<const double> rates);
    void follow(const std::vector<std::size_t>& passed);
    void pass(const Watch& watch, bool insist, std::vector<std::size_t>& passed);
    [[nodiscard]] bool settleWeights(double t, std::span<const double> y);
    void project(double t, std::span<double> y);
    void makeJacobian();
    [[nodiscard]] bool differences(double t, std::span<const double> y, std::span<double> entries);

    const expression::EquationSet& set_;
    expression::Graph graph_; // of the outputs and guards alone; derivatives go into copies
    std::vector<std::size_t> unknowns_, states_, held_, loop_;
    std::vector<expression::Node> outputs_, symbols_; // symbols: time, states, inputs
    std::vector<std::pair<std::size_t, std::size_t>> integrals_;
    std::vector<std::size_t> configuration_;
    bool readsStates_ = false;
    Inputs inputs_;
    expression::Tape tape_;
    expression::Tape::Scratch scratch_;
    std::vector<double> in_, out_, base_, other_, guards_;

    std::vector<expression::Node> switches_;
    std::vector<Surface> surfaces_;
    std::vector<std::pair<std::size_t, std::size_t>> ownGuards_; // surface, the state that it is
    std::vector<int> sides_;                                     // -1, 0, 1; of sliding surfaces -1
    std::vector<expression::Decision> decisions_;
    std::vector<std::size_t> sliding_; // surfaces
    std::vector<double> weights_;
    bool slidingFailed_ = false;
    std::vector<Watch> watches_;
    std::vector<std::unique_ptr<Gradient>> gradients_;

    struct Jacobian {
        Pattern pattern;
        Derived entries;
    };
    std::unique_ptr<Jacobian> jacobian_;
};

} // namespace solution
