// The equations of a component, without names and numbers: f of y' = f(t, y), h of held values,
// their switches and derivatives.
//
// A thousand alike pendulums are one model with a thousand sets of constants. A model is made from
// its key and nothing else: the code of its expressions over places,
//
//     time, states y0 y1 ..., inputs u0 u1 ... (unknowns of other components), constants c0 c1 ...,
//     multipliers m0 m1 ... (expression/equations.h, Condition)
//
// so that models are found again by content, in other components, in another run, after an edit.
// Constants that shape expressions (0, 1, -1 and exponents) are part of the key; equal constants of
// a component are one place. Terms of constants alone are computed when the constants are bound.
//
// A model never changes once it is made; what is derived when first asked for is guarded, so that
// any thread may ask.
#pragma once

#include "equations/directions.h"
#include "equations/elimination_order.h"
#include "equations/surfaces.h"
#include "expression/function.h"
#include "integrators/pattern.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace solution {

class ComponentModel {
public:
    using Key = std::vector<std::uint32_t>;
    explicit ComponentModel(Key key);

    [[nodiscard]] const Key& key() const { return key_; }
    [[nodiscard]] std::size_t states() const { return symbols_.states; }
    [[nodiscard]] std::size_t held() const { return outputs_.size() - symbols_.states; }
    [[nodiscard]] std::size_t inputs() const { return symbols_.inputs; }
    [[nodiscard]] std::size_t constants() const {
        return symbols_.all.size() - variables() - symbols_.multipliers;
    }
    [[nodiscard]] std::size_t multipliers() const { return symbols_.multipliers; }
    // Time, states and inputs: the symbols that stand before the constants.
    [[nodiscard]] std::size_t variables() const { return 1 + symbols_.states + symbols_.inputs; }

    [[nodiscard]] const expression::Graph& graph() const { return graph_; }
    [[nodiscard]] const std::vector<expression::Node>& symbols() const { return symbols_.all; }
    // Rates of states, then held values: what function() evaluates from symbols().
    [[nodiscard]] const std::vector<expression::Node>& outputs() const { return outputs_; }
    [[nodiscard]] const expression::Function& function() const { return function_; }
    [[nodiscard]] std::optional<std::size_t> placeOf(expression::Node symbol) const;
    [[nodiscard]] bool readsStates() const {
        return structure_.readsStates;
    } // other than in guards
    // Anything of it does: rates, held values, guards, conditions.
    [[nodiscard]] bool readsTime() const { return structure_.readsTime; }
    // peaks.h: with these constants.
    [[nodiscard]] bool canPeak(std::span<const double> values) const;
    // Where it can peak (peaks.h): values of causes, then their rates, from symbols() and the
    // rates of states and inputs; and what peaks there, from symbols().
    struct PeakFunctions {
        expression::Function causes, heights;
        std::vector<double> ratios;
        bool arePolynomials = true;
    };
    [[nodiscard]] const PeakFunctions& peaks() const { return peaks_; }
    // Those of the guards alone: what switches for a moment.
    [[nodiscard]] const PeakFunctions& guardPeaks() const { return guardPeaks_; }

    // Pairs of states (x, v) with x' = v, and the states that are positions or attitudes.
    [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& integrals() const {
        return structure_.integrals;
    }
    [[nodiscard]] const std::vector<std::size_t>& configuration() const {
        return structure_.configuration;
    }

    [[nodiscard]] const std::vector<expression::Node>& switches() const {
        return switching_.switches;
    }
    [[nodiscard]] const std::vector<Surface>& surfaces() const { return switching_.surfaces; }
    // Something of it switches, a condition too, or acts along a direction.
    [[nodiscard]] bool isSwitching() const;
    // Which of these the outputs read, on given branches.
    [[nodiscard]] const ReadSurfaces& readSurfaces() const { return switching_.read; }
    // Its guard reads a force, whose rate nothing here knows.
    [[nodiscard]] bool readsMultipliers(std::size_t surface) const {
        return switching_.readMultipliers[surface] != 0;
    }
    // Pairs of a surface and the state that is its guard.
    [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& ownGuards() const {
        return switching_.ownGuards;
    }

    // Derived expressions; their switches are those of the equations, or stand on their surfaces.
    struct Derived {
        expression::Function function;
        struct Source { // of each of its decisions
            std::optional<std::size_t> decision, surface;
            int orientation = 1;
        };
        std::vector<Source> sources;
    };
    struct Entry {
        std::uint32_t row, column;
    };
    struct Jacobian {
        Pattern pattern;
        // Of the pattern, with multipliers as they are; then d g''/d y of conditions and states;
        // then of the values of Conditions::gaps that friction reads: rates of conditions without a
        // gap, and levers.
        Derived entries;
        std::vector<Entry> ofConditions, ofGaps;
    };
    [[nodiscard]] const Jacobian& jacobian() const;
    struct Gradient {
        Derived derivatives;              // dg/dt, dg/dy, dg/dinputs; then g
        std::optional<std::size_t> state; // g is this state itself
    };
    [[nodiscard]] const Gradient& gradient(std::size_t surface) const;

    // Unit vectors a/|a| (directions.h) that act on what a is made of: friction in a plane, as a
    // rule. Their parts a_k are numbered through, one direction after the other.
    struct Directions {
        struct Range {
            std::size_t first, count; // of its parts
        };
        std::vector<Range> ranges;
        std::vector<expression::Node> lengths; // |a|, of each
        std::size_t parts = 0;
        Derived measures; // parts, then the weights of their squares, then lengths
        // Outputs with symbols in place of parts, and then of lengths, where these are divided by.
        // The symbols stand behind all others. Then what Conditions::second has, likewise.
        Derived outputs, second;
        std::vector<Gradient> gradients; // of each part
    };
    [[nodiscard]] const Directions& directions() const { return directions_; }

    // The conditions that multipliers keep: gaps g, their rates g', and their second rates, which
    // are linear in the multipliers m:  g'' = A m + b. Ties, conditions of first order, are kept
    // between steps alone: within them the rates of states agree with them, and their multipliers
    // are 0.
    struct Conditions {
        std::vector<Entry> matrix; // entries of A that are not 0, in the order of rows
        Derived second;            // these, then b
        std::vector<char> isTie;   // by multiplier
        // Of the multipliers of ties: their own rates and others' that are not 0.
        std::vector<Entry> ofTies;
        Derived ties; // these
        // g, then g', then what is not negative while contacts last, then the levers of friction.
        Derived gaps;
        // By multiplier, and one more: the first of those behind g'.
        std::vector<std::uint32_t> firstValid, firstLever;
        std::vector<Entry> pushes; // states and multipliers: dy'/dm that are not 0
        // Of places and attitudes, how they move when the states that multipliers push do so.
        std::vector<Entry> shifts;
        Derived moves; // entries of pushes, then of shifts
    };
    [[nodiscard]] const Conditions& conditions() const { return conditions_; }
    // How rates of places and attitudes change with states.
    struct Kinematics {
        std::vector<Entry> entries; // states: d y'(row) / d y(column) that are not 0
        Derived slopes;             // these
    };
    [[nodiscard]] const Kinematics& kinematics() const;
    // For modes in which all conditions but ties hold and nothing switches: outputs, multipliers,
    // and the checks that are positive where these keep the conditions (solved_conditions.h).
    struct Solved {
        expression::Function all;
        // Of rates of these conditions, one for each multiplier behind the symbols, the multipliers
        // that keep them; then the same checks.
        expression::Function given;
        std::size_t rows = 0, multiplications = 0;
    };
    // Null: they are not to be had so.
    [[nodiscard]] const Solved* solved() const;
    // g'' of one, a node of graph().
    [[nodiscard]] expression::Node secondRate(std::size_t multiplier) const {
        return conditionNodes_[3 * multiplier + 2];
    }

    // The equations as text, one per line: y0' = ..., then held values h0 = ...
    [[nodiscard]] std::string print() const;
    // The entries of the Jacobian that are not 0, one per line: dy0'/dy1 = ...
    [[nodiscard]] std::string printJacobian() const;

private:
    void readKey();
    void findStructure();
    [[nodiscard]] PeakFunctions peaksAmong(std::span<const expression::Node> nodes) const;
    [[nodiscard]] std::vector<expression::Node> attitudes() const;
    [[nodiscard]] std::unique_ptr<Jacobian> derivedJacobian() const;
    [[nodiscard]] std::unique_ptr<Kinematics> derivedKinematics() const;
    [[nodiscard]] Gradient gradientOf(expression::Node node) const;
    [[nodiscard]] std::optional<EliminationOrder> orderOfConditions() const;
    [[nodiscard]] std::unique_ptr<Solved> derivedSolution() const;
    [[nodiscard]] Derived derive(expression::Graph& graph, std::span<const expression::Node> nodes,
                                 std::span<const expression::Node> more = {}) const;
    struct FoundDirections {
        std::vector<Direction> all;
        std::vector<std::pair<expression::Node, std::size_t>> lengths; // and of which direction
    };
    // `graph` has the nodes of these.
    void deriveConditions(expression::Graph graph, const FoundDirections& directions);
    [[nodiscard]] std::span<const expression::Node> constantSymbols() const {
        return std::span(symbols_.all).subspan(variables(), constants());
    }
    // Their own nodes go into the graph.
    [[nodiscard]] FoundDirections foundDirections(expression::Graph& graph) const;
    void deriveDirections(expression::Graph graph, const FoundDirections& found);
    // The nodes with symbols in place of directions; and these symbols.
    [[nodiscard]] std::pair<std::vector<expression::Node>, std::vector<expression::Node>>
    withSymbols(expression::Graph& graph, const FoundDirections& found,
                std::span<const expression::Node> nodes) const;
    [[nodiscard]] bool actsOnItself(const Direction& direction) const;

    Key key_;
    expression::Graph graph_; // of the outputs and guards alone; derivatives go into copies
    struct Symbols {          // time, states, inputs, constants, multipliers
        std::size_t states = 0, inputs = 0, multipliers = 0;
        std::vector<expression::Node> all;
        std::unordered_map<std::uint32_t, std::size_t> places;
    };
    Symbols symbols_;
    std::vector<expression::Node> outputs_;
    expression::Function function_;
    struct Structure {
        bool readsStates = false, readsTime = false, canPeak = false;
        std::vector<std::pair<std::size_t, std::size_t>> integrals;
        std::vector<std::size_t> configuration;
    };
    Structure structure_;
    struct Switching {
        std::vector<expression::Node> switches;
        std::vector<Surface> surfaces;
        ReadSurfaces read;
        std::vector<char> readMultipliers; // by surface
        std::vector<std::pair<std::size_t, std::size_t>> ownGuards;
    };
    Switching switching_;
    // Of each multiplier g, g' and g''.
    std::vector<expression::Node> conditionNodes_;
    std::vector<expression::Node> besideNodes_; // what is valid of all multipliers, then levers
    Conditions conditions_;
    Directions directions_;
    PeakFunctions peaks_, guardPeaks_;

    struct Derivatives { // made when first asked for
        std::mutex making;
        std::unique_ptr<const Jacobian> jacobian;
        std::unique_ptr<const Kinematics> kinematics;
        std::vector<std::unique_ptr<const Gradient>> gradients;
        std::unique_ptr<const Solved> solved;
        bool isSolvedKnown = false;
    };
    mutable Derivatives derivatives_;
};

// Models by content. Any thread may ask; two that ask for the same get the same. A row of dominoes
// asks for a hundred models in each second of its motion: those that no component has any more are
// kept while all keys together have `room` words, and then the half of them that was asked for
// last. A model takes some 300 bytes for each word of its key, with its code and derivatives.
class ComponentModels {
public:
    static constexpr std::size_t usualRoom = 400'000; // some 120 MB
    explicit ComponentModels(std::size_t room = usualRoom) : room_(room) {}

    [[nodiscard]] std::shared_ptr<const ComponentModel> of(const ComponentModel::Key& key);
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] std::size_t made() const; // since the start, those that were forgotten too

private:
    void forgetUnused();

    struct Hash {
        std::size_t operator()(const ComponentModel::Key& key) const;
    };
    struct Known {
        std::shared_ptr<const ComponentModel> model;
        std::size_t asked = 0; // when last, of all that was asked
    };
    mutable std::mutex mutex_;
    std::unordered_map<ComponentModel::Key, Known, Hash> models_;
    std::size_t room_, words_ = 0; // of all keys
    std::size_t asked_ = 0, made_ = 0;
};

// Words of a key: counts of states, of held values and of multipliers, 1 or 0 for each state
// (configuration or not), then entries, then the entries that are outputs, three for the condition
// of each multiplier, and the number and the entries of what is valid of each, and so of levers. An
// entry is an operation with the entries that are its arguments, a literal (Op::constant and the
// two halves of its bits), or a leaf.
namespace key {
inline constexpr std::uint32_t time = 0x100, state = 0x101, input = 0x102, constant = 0x103,
                               outputs = 0x104, multiplier = 0x105;
} // namespace key

} // namespace solution
