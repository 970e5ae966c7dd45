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
    // A thing that has conditions, as a model. Its states are those of the component that it reads
    // or pushes, its multipliers those of its conditions, its inputs what it reads of other
    // components, and the rates of its states with all forces. Its rates are what its multipliers
    // push, its held values `motion`, and its second rates  steady + by * (rates of its states).
    struct Block {
        std::shared_ptr<const ComponentModel> model;
        std::vector<double> constants;
        struct Symbol {
            std::uint32_t place, of;
        };
        std::vector<Symbol> read;          // symbols of the component
        std::vector<Symbol> rates;         // rates of states of the component
        std::vector<std::uint32_t> states; // of the component
        std::vector<std::uint32_t> rows;   // of the component, by its multiplier
        std::vector<std::uint32_t> gaps;   // where its Conditions::gaps stand in the component's
    };
    std::vector<Block> blocks;

    // As of a model, but for the functions.
    ComponentModel::Conditions conditions;
    // Values are numbered through the outputs of all blocks.
    struct Steady { // the value that is the steady rate of a row
        std::uint32_t row, value;
    };
    std::vector<Steady> steady; // those that are not 0
    struct Term {               // a value, of a row and a state
        std::uint32_t row, state, value;
    };
    std::vector<Term> by, pushes;
    struct Product { // factor * push, added to an entry
        std::uint32_t into, factor, push;
    };
    std::vector<Product> matrix; // entries of A; factors are values of `by`
    std::vector<Product> shifts; // entries of shifts; factors are slopes of Kinematics
    std::size_t values = 0;
    Pattern jacobian; // full
};

// From how many multipliers on the conditions of a component are composed: fewer are one
// expression, whose code is the fastest where it stays.
inline constexpr std::size_t leastComposed = 8;

class Composer {
public:
    struct Row {
        const expression::Condition* condition;
        std::span<const expression::Node> levers;
    };
    // None: a symbol of another component.
    using StateOf = std::function<std::optional<std::uint32_t>(expression::Node)>;
    // False: these conditions are not composed of parts, or switch.
    [[nodiscard]] bool compose(const expression::EquationSet& set, const UnknownIndex& index,
                               const ZeroStates& zero, std::span<const Row> rows,
                               const StateOf& stateOf, ComponentModels& models);
    // Of other components: those that blocks read.
    [[nodiscard]] const std::vector<expression::Node>& symbols() const { return symbols_; }
    // With the model of all else, which has these symbols at these places.
    [[nodiscard]] Composition
    finish(const ComponentModel& model,
           const std::function<std::uint32_t(expression::Node)>& placeOf) &&;

private:
    class Writer;
    [[nodiscard]] bool write(Writer& writer, const Row& row, std::size_t place);
    void number(Composition::Block& block) const;
    void multiply(const ComponentModel& model);

    Composition made_;
    std::vector<expression::Node> symbols_;
    std::vector<std::vector<std::pair<std::uint32_t, expression::Node>>> inputs_; // by block
};

} // namespace solution
