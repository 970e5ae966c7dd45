// Which unknowns are 0 and stay 0? A planar scene has many: out of its plane nothing is, and
// nothing acts. They are not integrated, and other equations read a 0 in their place.
//
//     the greatest set of unknowns that are 0, have no phase ahead that holds or resets them, and
//     whose rates are 0 when all of the set are
//
// Of a multiplier the rates are those of its condition.
//
// A rate counts as 0 by its expression alone (a product with a 0, a sum of zeros, ...). So the
// answer is exact, and the set changes at events only: a jump or new equations wake some of it.
// None that is awake falls asleep again, so that an event elsewhere changes nobody's numbers. An
// event looks at what depends on those that it wakes, and at nothing else of the scene.
#pragma once

#include "expression/equations.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace solution {

class ZeroStates {
    // Lists of numbers, one for each key, which grow; all in one table.
    class GrowingLists {
    public:
        void add(std::uint32_t key, std::uint32_t number) {
            if (key >= newest_.size())
                newest_.resize(std::size_t{key} + 1, 0);
            links_.push_back({.number = number, .before = newest_[key]});
            newest_[key] = static_cast<std::uint32_t>(links_.size());
        }
        // The newest first.
        template <class Visit> void each(std::uint32_t key, const Visit& visit) const {
            for (std::uint32_t at = key < newest_.size() ? newest_[key] : 0; at != 0;
                 at = links_[at - 1].before)
                visit(links_[at - 1].number);
        }

    private:
        struct Link {
            std::uint32_t number, before;
        };
        std::vector<std::uint32_t> newest_; // by key: how many links there were with it; 0: none
        std::vector<Link> links_;
    };

public:
    ZeroStates() = default; // none
    ZeroStates(const expression::EquationSet& set, double from, std::span<const double> values);

    [[nodiscard]] bool contains(std::size_t unknown) const {
        return unknown < zero_.size() && zero_[unknown];
    }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    // The expression is 0 while these are 0, as far as its form tells; complete as symbolsLeft().
    [[nodiscard]] bool isZero(expression::Node n) const {
        return n.index < nodeZero_.size() && nodeZero_[n.index];
    }
    // In order.
    [[nodiscard]] std::vector<std::size_t> unknowns() const;

    // `roused` are no longer 0, and the equations of `changed` are others from this time on.
    // Answers with all that wake, in order. The graph may have grown, all else is as it was.
    [[nodiscard]] std::vector<std::size_t> wake(const expression::EquationSet& set, double from,
                                                std::span<const std::size_t> roused,
                                                std::span<const std::size_t> changed);
    // The last unknown of the set is new. It sleeps until wake() is told of its equations, as
    // others do; where nothing sleeps it is awake.
    void add(const expression::EquationSet& set);
    // Unknowns whose equations read one of these in some phase, and perhaps some that did before
    // an event; in order.
    [[nodiscard]] std::vector<std::size_t> readersOf(const expression::EquationSet& set,
                                                     std::span<const std::size_t> unknowns);
    // Nodes that wake() and readersOf() looked at so far.
    [[nodiscard]] std::size_t looks() const { return looks_; }

    // The symbols that are left of these nodes; the same number means the same node. Complete for
    // nodes that the graph had at the last construction or wake().
    [[nodiscard]] std::vector<expression::Node>
    symbolsLeft(const expression::Graph& graph, std::span<const expression::Node> nodes) const;

private:
    struct Readers;
    template <class Visit> void eachReader(std::uint32_t node, const Visit& visit) const;
    template <class Visit> void eachUnknown(std::uint32_t node, const Visit& visit) const;
    void grow(const expression::Graph& graph, std::uint32_t until);
    void learn(const expression::Unknown& unknown, double from, std::size_t u);
    [[nodiscard]] std::vector<std::size_t> spread(const expression::EquationSet& set, double from,
                                                  std::vector<std::size_t> awake);

    std::vector<bool> zero_;     // by unknown
    std::vector<bool> nodeZero_; // by node
    std::size_t count_ = 0, looks_ = 0;
    // The readers of a node, and the unknowns that have it as a rate or value: of the equations
    // that there were at first, which copies share, and of those that came later.
    std::shared_ptr<const Readers> readers_;
    GrowingLists lateReaders_, lateUnknowns_;
};

} // namespace solution
