// Where do the branches of switching expressions change?
//
// Comparisons, sign, abs, min and max with the same guard (up to its sign) change together: they
// are one surface g = 0, on whose sides the equations are smooth. floor and ceil are surfaces of
// their own. A step keeps all sides as they are; watches, functions that are at least 0 while that
// is right, are followed on its dense output, and the first to fall below 0 ends the step.
#pragma once

#include "expression/graph.h"
#include "expression/tape.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace solution {

struct Surface {
    struct Member {
        std::size_t decision; // of the tape
        int orientation;      // its guard is this times g
    };
    bool whole = false;     // floor or ceil: members has one entry and g is its own guard
    bool ceiling = false;   // of the two, ceil
    expression::Node guard; // g; for floor and ceil their argument
    std::vector<Member> members;
};

// The surfaces of the tape that evaluates `outputs`. New nodes go into the graph.
[[nodiscard]] std::vector<Surface> surfacesOf(expression::Graph& graph,
                                              std::span<const expression::Node> outputs);

// Switching nodes among what `outputs` read, in the order in which a tape numbers its decisions.
[[nodiscard]] std::vector<expression::Node> switchesOf(const expression::Graph& graph,
                                                       std::span<const expression::Node> outputs);

// Which surfaces do outputs read, on given branches? `d > 0 ? max(0, f) : 0` reads no max() while
// d <= 0, nor does a product with a comparison that is 0 there: passing such a surface changes
// nothing, so that it is none, however often its guard changes its sign.
class ReadSurfaces {
public:
    ReadSurfaces() = default;
    ReadSurfaces(const expression::Graph& graph, std::span<const expression::Node> outputs,
                 std::span<const Surface> surfaces);
    // Some branches read less than all surfaces.
    [[nodiscard]] bool mayVary() const { return mayVary_; }
    // By surface.
    [[nodiscard]] std::vector<bool> on(std::span<const expression::Decision> branches) const;

private:
    struct Entry { // in an order in which arguments come first
        expression::Op op;
        std::array<std::size_t, 3> arguments{};
        std::size_t count = 0;
        std::optional<std::size_t> decision = {};
        std::optional<double> value = {}; // of a constant
    };
    std::vector<Entry> entries_;
    std::vector<std::size_t> outputs_;   // entries
    std::vector<std::size_t> surfaceOf_; // by decision
    std::size_t surfaces_ = 0;
    bool mayVary_ = false;
};

// The guard of a switching node of surfaces with two sides, and its orientation.
struct Guard {
    expression::Node node;
    int orientation;
};
[[nodiscard]] Guard guardOf(expression::Graph& graph, expression::Node switching);

struct Violation {
    double time = 0;
    std::vector<std::size_t> watches; // those that are no longer above 0 at `time`
};

// The first time in [from, to] at which a watch falls to 0 or below, to the last bit: it is above 0
// at the double before. A watch that starts at or below 0 (by rounding, after an event) is followed
// from where it rises above; if it only falls, the violation is at `from`.
//
// On pieces of the interval, halved until a polynomial of degree 8 agrees with the watches, its
// Bernstein form isolates the first root; bisection on the watches themselves finishes.
//
// A graze: a watch that starts at 0, rises for less than the samples see and falls is followed to
// the end of that rise, down to a 2^-40th of the interval.
//
// LIMIT: a watch that falls below 0 and rises again between samples that a polynomial of degree 8
// explains otherwise is not seen; nor is a touch, nor surely what needs more pieces than 500, or
// 50,000 with great care. A kink, as that of hypot(x, 0), is followed down to a 2^-24th of the
// interval.
enum class Care {
    some, // 500 pieces, and no touch is followed to its minimum: what is sought shows elsewhere too
    great
};
[[nodiscard]] std::optional<Violation>
firstViolation(std::size_t watches,
               const std::function<void(double t, std::span<double> values)>& evaluate, double from,
               double to, Care care = Care::great);

} // namespace solution
