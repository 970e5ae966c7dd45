// Expressions as straight-line code over slots, evaluated many times.
//
// The tape is the reference evaluator. It evaluates shared subexpressions once. Where an expression
// switches (comparisons, ?:, abs, sign, min, max, floor, ceil), the tape can be told which branch
// to take, so that an integrator sees a smooth function across one step and locates the switch as
// a root of that switch's guard instead of stepping over a kink.
//
//   guard of a < b, a <= b, a == b, min(a,b), max(a,b):  a - b
//   guard of abs(x), sign(x):                            x
//   guard of floor(x), ceil(x):                          distance of x to the integers of its
//   branch
//
// A decision is the branch taken: the sign of the guard (-1, 0, +1), or the integer that floor or
// ceil gave. On branch 0 abs, min and max follow from their values (both sides meet there). Logical
// operators and ?: have no guard of their own: they follow from comparisons.
#pragma once

#include "expression/graph.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace expression {

using Decision = std::int64_t;

// The values imply no branch: they are not numbers, or so large that every double is whole. The
// operation then follows from its values even when decisions are given.
inline constexpr Decision noBranch = std::numeric_limits<Decision>::min();

// The dependencies of the operations, without any number: slots are the inputs, then the constants,
// then one for each result (SSA). Tapes with equal sequences can share machine code (kernel.h).
struct Sequence {
    struct Instruction {
        Op op;
        std::uint32_t result, a, b, c;
        std::int32_t decision; // index, or -1
        bool operator==(const Instruction&) const = default;
    };
    std::vector<Instruction> instructions;
    std::vector<std::uint32_t> outputs; // slots; may be an input's or a constant's
    std::uint32_t inputs = 0, constants = 0, decisions = 0;

    [[nodiscard]] std::uint32_t slots() const {
        return inputs + constants + static_cast<std::uint32_t>(instructions.size());
    }
    bool operator==(const Sequence&) const = default;
    [[nodiscard]] std::size_t hash() const;
};

// The value of an operation on a branch that its values may not imply, and its guard.
[[nodiscard]] double onBranch(Op op, double a, double b, Decision taken);
[[nodiscard]] double guardOf(Op op, double a, double b, Decision taken);

class Tape {
public:
    Tape() = default;
    // Evaluates `outputs` as functions of `inputs` (symbols; every symbol read must be among them).
    Tape(const Graph& graph, std::span<const Node> inputs, std::span<const Node> outputs);

    [[nodiscard]] std::size_t inputs() const { return sequence_.inputs; }
    [[nodiscard]] std::size_t outputs() const { return sequence_.outputs.size(); }
    [[nodiscard]] std::size_t decisions() const { return sequence_.decisions; }
    [[nodiscard]] std::size_t operations() const { return sequence_.instructions.size(); }
    [[nodiscard]] const Sequence& sequence() const { return sequence_; }
    [[nodiscard]] std::span<const double> constants() const { return constants_; }

    // Scratch that one thread gives to every call; sized by the first.
    using Scratch = std::vector<double>;

    // Branches follow from the values.
    void evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch) const;
    // Branches are as given, guards are written (decisions() of each; `guards` may be empty).
    void evaluate(std::span<const double> in, std::span<double> out, Scratch& scratch,
                  std::span<const Decision> decisions, std::span<double> guards) const;
    // The branches that the values imply, and the guards.
    void decide(std::span<const double> in, std::span<Decision> decisions, std::span<double> guards,
                Scratch& scratch) const;

    // One line per operation, for tests and `explain`.
    [[nodiscard]] std::string print() const;

private:
    using Instruction = Sequence::Instruction;
    std::uint32_t emit(Op op, std::uint32_t a, std::uint32_t b = 0, std::uint32_t c = 0);
    std::uint32_t emitShortPower(std::uint32_t base, double exponent);
    // Runs all instructions; `atSwitch(instruction, a, b)` gives the values of those that decide.
    template <class Switch>
    void run(std::span<const double> in, Scratch& scratch, const Switch& atSwitch) const;
    void copyOutputs(const Scratch& scratch, std::span<double> out) const;

    Sequence sequence_;
    std::vector<double> constants_; // initial contents of the slots after the inputs
};

} // namespace expression
