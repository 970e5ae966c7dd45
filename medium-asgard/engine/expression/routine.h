// A tape's operations, each with the register or the place in memory of what it reads and writes:
// the last form before machine code, and one that can be read.
//
// The code is straight, so the uses of every value are known: when registers run out, the value
// whose next use is furthest away gives up its own (Belady 1966), and is stored unless memory has
// it already. Inputs and constants are read where they stand; an output is stored where it belongs.
// Elementary functions are calls, and a call leaves no register as it was.
//
// Time and memory are linear in the number of operations: a routine may be a Jacobian of 10^5.
#pragma once

#include "expression/tape.h"

#include <cstdint>
#include <string>
#include <vector>

namespace expression {

// The use of a routine. `guards` computes the guards on the branches given, and nothing else.
enum class Purpose : std::uint8_t { values, valuesOnBranches, guards };

struct Place {
    enum class Kind : std::uint8_t { none, reg, input, constant, output, spill };
    Kind kind = Kind::none;
    std::uint32_t index = 0;
    bool operator==(const Place&) const = default;
};

struct Step {
    // frozen: the value on the branch given; guard: the guard there.
    enum class Kind : std::uint8_t { load, store, operate, frozen, guard };
    Kind kind = Kind::operate;
    Op op = Op::constant;
    bool isCall = false;
    std::int32_t decision = -1;
    Place to, a, b, c;
};

struct Routine {
    static constexpr unsigned registers = 14; // that values may take; two more are for the emitter
    std::vector<Step> steps;
    std::uint32_t spills = 0;
    bool hasCalls = false;

    [[nodiscard]] std::string print() const; // one line per step
};

[[nodiscard]] std::string print(const Step& step);

// The operations that the processor does itself; all others are calls.
struct Ability {
    bool rounds = false;   // floor and ceil
    bool branches = false; // frozen values and guards: one instance at a time does, lanes do not
};

[[nodiscard]] Routine makeRoutine(const Sequence& sequence, Purpose purpose, Ability ability);

} // namespace expression
