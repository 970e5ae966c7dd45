// Which equations must be solved together, and in which order?
//
// Nodes are unknowns; an arc runs from each unknown that an equation reads to the one it computes
// (dissertation 5.2.1, Figure 5.8). Tarjan's algorithm (1972), iterative, gives the strongly
// connected components in an order in which each comes after all that it reads.
#pragma once

#include "equations/zero_states.h"
#include "expression/equations.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

namespace solution {

// Which unknown a symbol stands for, which quaternion an unknown belongs to, and which conditions
// read it.
class UnknownIndex {
public:
    explicit UnknownIndex(const expression::EquationSet& set);
    [[nodiscard]] std::optional<std::size_t> of(expression::Node symbol) const {
        if (symbol.index >= bySymbol_.size() || bySymbol_[symbol.index] == none)
            return std::nullopt;
        return bySymbol_[symbol.index];
    }
    [[nodiscard]] std::optional<std::size_t> quaternionOf(std::size_t unknown) const {
        return quaternions_[unknown] == none ? std::nullopt
                                             : std::optional<std::size_t>(quaternions_[unknown]);
    }
    // Those whose conditions read it, so that they may move it: in order.
    [[nodiscard]] std::span<const std::size_t> multipliersOf(std::size_t unknown) const;

    // Those that read this multiplier and must be found with it, whose history has no value: what
    // releases conditions, and what a multiplier moves that is a value (no gap, no rate).
    [[nodiscard]] std::span<const std::size_t> releasesBy(std::size_t multiplier) const;
    [[nodiscard]] bool isRelease(std::size_t unknown) const { return releases_.contains(unknown); }

    // The set has got this unknown, its last.
    void add(const expression::EquationSet& set, std::size_t unknown);
    // Its phases from that time on are others.
    void follow(const expression::EquationSet& set, std::size_t multiplier, double from);

    void followRelease(const expression::EquationSet& set, std::size_t release);

private:
    void findMoved(const expression::EquationSet& set, const expression::Condition& condition,
                   std::size_t multiplier);
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    std::vector<std::uint32_t> bySymbol_;    // by node
    std::vector<std::uint32_t> quaternions_; // by unknown
    std::unordered_map<std::size_t, std::vector<std::size_t>> multipliers_;
    std::set<std::size_t> releases_;
    std::unordered_map<std::size_t, std::vector<std::size_t>> releasesBy_;
};

// reads[i]: the unknowns that equation i reads, in order, each once; i itself may be among them.
using Reads = std::vector<std::vector<std::size_t>>;

// From all phases after `from` and the one in force then. The four of a quaternion read each other,
// since they are renormalised together; an unknown that a condition reads also reads its
// multiplier, which may move it, and a multiplier what must be found with it. An unknown that stays
// 0 reads nothing, and nothing reads it. Unknowns that a switch can hold where it is (sliding,
// component_equations.h) also read all others whose rates have the same switch: what it gives then
// is one number, which is theirs too.
[[nodiscard]] Reads readsOf(const expression::EquationSet& equations, const UnknownIndex& index,
                            double from, const ZeroStates& zero = {});
[[nodiscard]] Reads readsOf(const expression::EquationSet& equations, double from,
                            const ZeroStates& zero = {});
// Of these equations alone, beside `unknowns`, their switches aside.
[[nodiscard]] Reads readsOf(const expression::EquationSet& equations, const UnknownIndex& index,
                            std::span<const std::size_t> unknowns, double from,
                            const ZeroStates& zero);

// Adds what switches that are shared make these unknowns read; `reads` stand beside `unknowns`, and
// name places among them. Those of unknowns that are not listed are not asked.
void addSharedSwitches(const expression::EquationSet& equations, const UnknownIndex& index,
                       std::span<const std::size_t> unknowns, double from, const ZeroStates& zero,
                       Reads& reads);

struct Partition {
    // Unknowns of each component in order of index; components after those that they read.
    std::vector<std::vector<std::size_t>> components;
    std::vector<std::vector<std::size_t>>
        reads;                            // components that each reads directly, without itself
    std::vector<std::size_t> componentOf; // by unknown; noComponent: left out
};
inline constexpr std::size_t noComponent = static_cast<std::size_t>(-1);

// Without those that are left out (by unknown; none: all take part), which the reads of the others
// must not name.
[[nodiscard]] Partition partitionOf(const Reads& reads, const std::vector<bool>& leftOut = {});
// By unknown: none of `asked` is it, nor reads it, directly or through others.
[[nodiscard]] std::vector<bool> unreadBy(const std::vector<std::size_t>& asked, const Reads& reads);
// Everything in one component (the comparison of 5.2.4).
[[nodiscard]] Partition wholePartition(const Reads& reads);

} // namespace solution
