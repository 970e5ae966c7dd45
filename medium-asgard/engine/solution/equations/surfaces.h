// Where do the branches of switching expressions change?
//
// Comparisons, sign, abs, min and max with the same guard (up to its sign) change together: they
// are one surface g = 0, on whose sides the equations are smooth. floor and ceil are surfaces of
// their own. A step keeps all sides as they are until a guard changes its sign
// (dense/first_violation.h).
#pragma once

#include "expression/graph.h"
#include "expression/tape.h"

#include <array>
#include <cstdint>
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

} // namespace solution
