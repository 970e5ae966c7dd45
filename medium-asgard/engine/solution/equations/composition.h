// The conditions of a component with many of them, put together from blocks: one block for each
// thing, as a contact, that has conditions of its own (expression/equations.h, ConditionParts).
//
// A pile of bricks has hundreds of sets of contacts in a second. One expression for all second
// rates would have to be derived anew for each set; a block is the same model, and the same machine
// code, for all contacts of its kind. With J the factors `by` and P the pushes:
//
//     A = J P      b = steady + J f      rates = f + P m
//
// f being the rates without multipliers, which the component's model has.
#pragma once

#include "equations/component_model.h"
#include "equations/zero_states.h"
#include "expression/equations.h"
#include "integrators/pattern.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace solution {

class UnknownIndex;

struct Composition {
    struct Values { // of a block, from few symbols of the component and constants of its own
        std::shared_ptr<const ComponentModel> model; // held values, from inputs
        std::vector<double> constants;
        std::vector<std::uint32_t> in; // places of the inputs among the component's symbols
    };
    std::vector<Values> motion;          // steady rates, factors and pushes, block by block
    std::vector<Values> places;          // gaps, rates, what is valid, levers
    std::vector<std::uint32_t> ofPlaces; // where each of these stands in Conditions::gaps

    // As of a model, but for the functions.
    ComponentModel::Conditions conditions;
    struct Steady { // the value of motion that is the steady rate of a row
        std::uint32_t row, value;
    };
    std::vector<Steady> steady; // those that are not 0
    struct Term {               // a value of motion, of a row and a state
        std::uint32_t row, state, value;
    };
    std::vector<Term> by, pushes;
    struct Product { // factor * push, added to an entry
        std::uint32_t into, factor, push;
    };
    std::vector<Product> matrix; // entries of A; factors are values of `by`
    std::vector<Product> shifts; // entries of shifts; factors are slopes of Kinematics
    std::size_t motionValues = 0;
    Pattern jacobian; // full
};

// From how many multipliers on the conditions of a component without friction are composed: fewer
// are one expression, whose code is the fastest where it stays.
inline constexpr std::size_t leastComposed = 20;

class Composer {
public:
    struct Row {
        const expression::Condition* condition;
        std::span<const expression::Node> levers;
    };
    using StateOf = std::function<std::optional<std::uint32_t>(expression::Node)>;
    // False: these conditions are not composed of parts, or switch.
    [[nodiscard]] bool compose(const expression::EquationSet& set, const UnknownIndex& index,
                               const ZeroStates& zero, std::span<const Row> rows,
                               const StateOf& stateOf, ComponentModels& models);
    // Symbols that blocks read.
    [[nodiscard]] const std::vector<expression::Node>& symbols() const { return symbols_; }
    // With the model of all else, which has these symbols at these places.
    [[nodiscard]] Composition
    finish(const ComponentModel& model,
           const std::function<std::uint32_t(expression::Node)>& placeOf) &&;

private:
    class Writer;
    void writePlaces(Writer& writer, std::span<const Row> rows, std::size_t row);
    [[nodiscard]] bool writeMotion(Writer& writer, const expression::ConditionParts& parts,
                                   std::size_t row, const StateOf& stateOf);
    void multiply(const ComponentModel& model);

    Composition made_;
    std::vector<expression::Node> symbols_;
    std::vector<std::vector<expression::Node>> read_; // by block: of motion, then of places
};

} // namespace solution
