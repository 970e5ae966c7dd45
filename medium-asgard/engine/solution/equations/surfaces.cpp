#include "equations/surfaces.h"

#include "expression/operation.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace solution {

using expression::Graph;
using expression::Node;
using expression::Op;

std::vector<Node> switchesOf(const Graph& graph, std::span<const Node> outputs) {
    std::vector<Node> found = expression::reachable(graph, outputs);
    std::erase_if(found, [&graph](Node n) { return !expression::isSwitch(graph.op(n)); });
    return found;
}

// One node for g and -g: differences in order of their terms, no leading minus.
Guard guardOf(Graph& graph, Node switching) {
    const auto arguments = graph.arguments(switching);
    Guard guard{arguments[0], 1};
    if (arguments.size() == 2)
        guard.node = graph.subtract(arguments[0], arguments[1]);
    for (;;) {
        const auto terms = graph.arguments(guard.node);
        if (graph.op(guard.node) == Op::negate)
            guard = {terms[0], -guard.orientation};
        else if (graph.op(guard.node) == Op::subtract && terms[1] < terms[0])
            guard = {graph.subtract(terms[1], terms[0]), -guard.orientation};
        else
            return guard;
    }
}

std::vector<Surface> surfacesOf(Graph& graph, std::span<const Node> outputs) {
    std::vector<Surface> surfaces;
    std::map<Node, std::size_t> byGuard;
    const std::vector<Node> switches = switchesOf(graph, outputs);
    for (std::size_t decision = 0; decision < switches.size(); ++decision) {
        const Op op = graph.op(switches[decision]);
        if (op == Op::floor || op == Op::ceil) {
            Surface whole;
            whole.whole = true;
            whole.ceiling = op == Op::ceil;
            whole.guard = graph.arguments(switches[decision])[0];
            whole.members.push_back({decision, 1});
            surfaces.push_back(whole);
            continue;
        }
        const Guard guard = guardOf(graph, switches[decision]);
        const auto [place, isNew] = byGuard.emplace(guard.node, surfaces.size());
        if (isNew) {
            surfaces.emplace_back();
            surfaces.back().guard = guard.node;
        }
        surfaces[place->second].members.push_back({decision, guard.orientation});
    }
    return surfaces;
}

ReadSurfaces::ReadSurfaces(const Graph& graph, std::span<const Node> outputs,
                           std::span<const Surface> surfaces)
    : surfaces_(surfaces.size()) {
    if (surfaces_ < 2) // no branch can leave out the only one
        return;
    std::map<Node, std::size_t> places;
    for (const Node n : expression::reachable(graph, outputs)) {
        Entry entry{.op = graph.op(n)};
        for (const Node argument : graph.arguments(n))
            entry.arguments[entry.count++] = places.at(argument);
        if (expression::isSwitch(entry.op)) {
            entry.decision = surfaceOf_.size();
            surfaceOf_.push_back(0);
        }
        if (entry.op == Op::constant)
            entry.value = graph.value(n);
        mayVary_ =
            mayVary_ || entry.op == Op::select ||
            (entry.op == Op::multiply && (expression::isTruth(entries_[entry.arguments[0]].op) ||
                                          expression::isTruth(entries_[entry.arguments[1]].op)));
        places.emplace(n, entries_.size());
        entries_.push_back(entry);
    }
    for (const Node n : outputs)
        outputs_.push_back(places.at(n));
    for (std::size_t s = 0; s < surfaces_; ++s)
        for (const Surface::Member& member : surfaces[s].members)
            surfaceOf_[member.decision] = s;
}

std::vector<bool> ReadSurfaces::on(std::span<const expression::Decision> branches) const {
    // Of conditions and what they are made of; none: not known from branches alone.
    std::vector<std::optional<bool>> truths(entries_.size());
    for (std::size_t i = 0; i < entries_.size(); ++i) {
        const Entry& e = entries_[i];
        if (e.value)
            truths[i] = *e.value != 0;
        else if (e.decision && expression::isTruth(e.op) &&
                 branches[*e.decision] != expression::noBranch)
            truths[i] = expression::onBranch(e.op, 0, 0, branches[*e.decision]) != 0;
        else if (e.op == Op::logicalNot && truths[e.arguments[0]])
            truths[i] = !*truths[e.arguments[0]];
        else if (e.op == Op::logicalAnd || e.op == Op::logicalOr) {
            const bool settling = e.op == Op::logicalOr; // the value that settles it alone
            const auto a = truths[e.arguments[0]], b = truths[e.arguments[1]];
            if (a == settling || b == settling)
                truths[i] = settling;
            else if (a && b)
                truths[i] = !settling;
        }
    }
    std::vector<bool> isRead(entries_.size());
    for (const std::size_t output : outputs_)
        isRead[output] = true;
    std::vector<bool> read(surfaces_);
    for (std::size_t i = entries_.size(); i-- > 0;) {
        const Entry& e = entries_[i];
        if (!isRead[i])
            continue;
        if (e.decision)
            read[surfaceOf_[*e.decision]] = true;
        const auto truthOf = [&](std::size_t k) { return truths[e.arguments[k]]; };
        for (std::size_t k = 0; k < e.count; ++k) {
            const bool isOut =
                (e.op == Op::select && k > 0 && truthOf(0) && *truthOf(0) != (k == 1)) ||
                (e.op == Op::multiply && truthOf(1 - k) == false);
            if (!isOut)
                isRead[e.arguments[k]] = true;
        }
    }
    return read;
}

} // namespace solution
