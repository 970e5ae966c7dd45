#include "reports/explanation.h"

#include "equations/partition.h"
#include "equations/phases_text.h"
#include "run/run.h"

#include "expression/operation.h"
#include "scene/connections.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace simulation {
namespace {

using expression::Node;
using expression::Op;

// LIMIT: a longer list of pairs helps nobody; what is beyond it is left out.
constexpr std::size_t mostPairs = 10'000;
// LIMIT: an equation of more operations than this, each shared one counted where it is used, is
// told by what it reads.
constexpr double mostOperations = 2000;
// A number in front of a term that is less than this of the others' in its sum, and of 1, is what
// rounding left of a 0. LIMIT: an author's own number of that size is not told.
constexpr double noise = 1e-13;

std::string shortNumber(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

// Texts of the equations in force at a time, with a 0 in place of what stays 0.
class Equations {
public:
    Equations(const expression::EquationSet& set, const std::vector<std::size_t>& zero, double time)
        : set_(set), index_(set_), time_(time) {
        for (const std::size_t u : zero)
            zeros_.emplace(set_.unknowns[u].symbol.index, set_.graph.constant(0));
    }

    std::string textOf(std::size_t unknown) {
        const expression::Phase& phase = inForce(unknown);
        const Node right = rightOf(phase);
        std::string text = set_.unknowns[unknown].name + (phase.given ? " = " : "' = ");
        const double operations = operationsOf(right);
        if (operations > mostOperations)
            return text + "a long expression of " + readBy(right) + " (--expressions " +
                   set_.unknowns[unknown].name + " prints all that is in force at the end)";
        // What cancels may leave a -0.
        return text +
               (set_.graph.isConstant(right, 0) ? "0" : expression::print(set_.graph, right));
    }
    // Other laws that were in force from the start on, each once, with the time it ended last.
    std::vector<std::string> earlierTexts(std::size_t unknown, double start) {
        const auto& phases = set_.unknowns[unknown].phases;
        const std::string now = textOf(unknown);
        std::vector<std::pair<std::string, double>> ended;
        for (std::size_t i = 0; i + 1 < phases.size() && phases[i + 1].from <= time_; ++i) {
            if (phases[i + 1].from <= start)
                continue;
            const double whole = std::exchange(time_, phases[i].from);
            const std::string text = textOf(unknown);
            time_ = whole;
            const auto known =
                std::ranges::find(ended, text, [](const auto& e) { return e.first; });
            if (text != now && known == ended.end())
                ended.emplace_back(text, phases[i + 1].from);
            else if (text != now)
                known->second = phases[i + 1].from;
        }
        std::vector<std::string> texts;
        texts.reserve(ended.size());
        for (const auto& [text, until] : ended)
            texts.push_back(text + ", until t = " + shortNumber(until));
        return texts;
    }
    void addReads(std::size_t unknown, std::set<std::size_t>& reads) {
        const Node right = rightOf(inForce(unknown));
        for (const Node symbol : expression::symbolsOf(set_.graph, {&right, 1}))
            if (const auto read = index_.of(symbol))
                reads.insert(*read);
    }
    [[nodiscard]] const std::string& name(std::size_t unknown) const {
        return set_.unknowns[unknown].name;
    }

private:
    // "b.qw, b.qx and 3 more"
    std::string readBy(Node right) {
        constexpr std::size_t most = 6;
        std::vector<std::string> names;
        for (const Node symbol : expression::symbolsOf(set_.graph, {&right, 1}))
            if (const auto read = index_.of(symbol))
                names.push_back(set_.unknowns[*read].name);
        std::string list;
        for (std::size_t i = 0; i < names.size() && i < most; ++i)
            list += (i == 0 ? "" : ", ") + names[i];
        if (names.size() > most)
            list += " and " + std::to_string(names.size() - most) + " more";
        return names.empty() ? "time" : list;
    }
    const expression::Phase& inForce(std::size_t unknown) const {
        const auto& phases = set_.unknowns[unknown].phases;
        std::size_t i = 0;
        while (i + 1 < phases.size() && phases[i + 1].from <= time_)
            ++i;
        return phases[i];
    }
    Node rightOf(const expression::Phase& phase) {
        return withoutNoise(expression::substitute(
            set_.graph, phase.given ? *phase.given : phase.derivative, zeros_));
    }
    // The number in front of a term.
    [[nodiscard]] double factorOf(Node n) const {
        const expression::Graph& g = set_.graph;
        if (g.op(n) == Op::constant)
            return std::abs(g.value(n));
        double factor = 1;
        while (g.op(n) == Op::multiply || g.op(n) == Op::divide || g.op(n) == Op::negate) {
            const auto arguments = g.arguments(n);
            if (g.op(n) == Op::multiply && g.op(arguments[0]) == Op::constant) {
                factor *= std::abs(g.value(arguments[0]));
                n = arguments[1];
                continue;
            }
            if (g.op(n) == Op::divide && g.op(arguments[1]) == Op::constant)
                factor /= std::abs(g.value(arguments[1]));
            n = arguments[0];
            if (g.op(n) == Op::constant)
                return factor * std::abs(g.value(n));
        }
        return factor;
    }
    // Sums without terms whose numbers are what rounding leaves of the others'.
    Node withoutNoise(Node root) {
        expression::Graph& g = set_.graph;
        std::vector<Node> open{root};
        while (!open.empty()) {
            const Node n = open.back();
            const std::vector<Node> arguments(g.arguments(n).begin(), g.arguments(n).end());
            const auto unknown =
                std::ranges::find_if(arguments, [&](Node a) { return !quiet_.contains(a.index); });
            if (quiet_.contains(n.index)) {
                open.pop_back();
            } else if (unknown != arguments.end()) {
                open.push_back(*unknown);
            } else {
                quiet_.emplace(n.index, quietened(n, arguments));
                open.pop_back();
            }
        }
        return quiet_.at(root.index);
    }
    Node quietened(Node n, std::vector<Node> arguments) {
        expression::Graph& g = set_.graph;
        const Op op = g.op(n);
        if (arguments.empty())
            return n;
        for (Node& argument : arguments)
            argument = quiet_.at(argument.index);
        if (op == Op::add || op == Op::subtract) {
            const double first = factorOf(arguments[0]), second = factorOf(arguments[1]);
            if (second < noise * std::min(first, 1.0))
                return arguments[0];
            if (first < noise * std::min(second, 1.0))
                return op == Op::add ? arguments[1] : g.negate(arguments[1]);
        }
        return arguments.size() == 1   ? g.apply(op, arguments[0])
               : arguments.size() == 2 ? g.apply(op, arguments[0], arguments[1])
                                       : g.apply(op, arguments[0], arguments[1], arguments[2]);
    }
    double operationsOf(Node root) {
        std::vector<Node> open{root};
        while (!open.empty()) {
            const Node n = open.back();
            double sum = 1;
            bool ready = true;
            for (const Node argument : set_.graph.arguments(n)) {
                const auto known = sizes_.find(argument.index);
                if (known == sizes_.end()) {
                    open.push_back(argument);
                    ready = false;
                } else {
                    sum += known->second;
                }
            }
            if (ready) {
                sizes_[n.index] = sum;
                open.pop_back();
            }
        }
        return sizes_.at(root.index);
    }

    expression::EquationSet set_;
    solution::UnknownIndex index_;
    double time_;
    std::unordered_map<std::uint32_t, Node> zeros_, quiet_;
    std::unordered_map<std::uint32_t, double> sizes_;
};

Explanation::Component componentOf(Equations& equations, double start,
                                   const solution::ComponentStatistics& c) {
    Explanation::Component component{.unknowns = {},
                                     .reads = {},
                                     .equations = {},
                                     .earlier = {},
                                     .model = c.model,
                                     .method = c.method,
                                     .order = c.order,
                                     .steps = c.steps,
                                     .evaluations = c.evaluations,
                                     .why = c.why};
    std::set<std::size_t> reads;
    for (const std::size_t u : c.unknowns) {
        component.unknowns.push_back(equations.name(u));
        component.equations.push_back(equations.textOf(u));
        for (std::string& text : equations.earlierTexts(u, start))
            component.earlier.push_back(std::move(text));
        equations.addReads(u, reads);
    }
    for (const std::size_t u : reads)
        if (!std::ranges::binary_search(c.unknowns, u))
            component.reads.push_back(equations.name(u));
    return component;
}

bool belongsTo(const std::string& unknown, const std::string& asked) {
    return unknown == asked || (unknown.starts_with(asked) && unknown[asked.size()] == '.');
}

void addPhases(const Problem& problem, const Run& run, Explanation& explanation) {
    const auto& unknowns = run.equations->unknowns;
    for (const solution::ComponentStatistics& c : run.statistics.componentList) {
        if (!c.bound || std::ranges::none_of(c.unknowns, [&](std::size_t u) {
                return belongsTo(unknowns[u].name, problem.options.phasesOf);
            }))
            continue;
        Explanation::Phases phases;
        for (const std::size_t u : c.unknowns)
            phases.unknowns.push_back(unknowns[u].name);
        phases.text = solution::phasesText(*run.equations, c.unknowns, *c.bound);
        explanation.phases.push_back(std::move(phases));
    }
}

// Orientations that no motion reads, and that no meeting of bodies asked for.
std::vector<bool> seenOnly(const Problem& problem, const Run& run) {
    std::vector<std::size_t> asked;
    std::vector<bool> isNear(problem.bodies->size(), false);
    for (const auto& [a, b] : run.candidates)
        isNear[a] = isNear[b] = true;
    for (std::size_t b = 0; b < isNear.size(); ++b) {
        const BodyRecord& body = (*problem.bodies)[b];
        const std::size_t count = isNear[b] ? physics::bodyUnknowns : std::size_t{physics::qw};
        for (std::size_t i = 0; !body.isFixed && i < count; ++i)
            asked.push_back(body.firstUnknown + i);
    }
    return solution::unreadBy(asked, solution::readsOf(*run.equations, problem.start()));
}

void addZeroStates(const Problem& problem, const Run& run, Explanation& explanation) {
    const auto& zero = run.statistics.zeroStates;
    for (const physics::BodyMotion& body : problem.equations.bodies) {
        if (body.isFixed)
            continue;
        std::string names;
        for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
            if (std::ranges::binary_search(zero, body.firstUnknown + i))
                names += (names.empty() ? "" : ", ") +
                         problem.equations.set.unknowns[body.firstUnknown + i].name;
        if (!names.empty())
            explanation.notModelled.push_back(
                {names, "0 at the start, and nothing moves them from 0"});
    }
}

// Why pairs need not be looked at.
class WhyNever {
public:
    explicit WhyNever(const scene::Scene& scene) : scene_(scene) {
        scene::Released gears, joints;
        for (std::size_t g = 0; g < scene.gears.size(); ++g)
            gears.gears.insert(g);
        joints = gears;
        for (std::size_t j = 0; j < scene.joints.size(); ++j)
            joints.joints.insert(j);
        linked_ = scene::joinedBodies(scene, joints);
        joined_ = scene::joinedBodies(scene, gears);
        geared_ = scene::joinedBodies(scene);
    }
    // "": it must be.
    [[nodiscard]] std::string of(std::size_t a, std::size_t b) const {
        const scene::Body& first = scene_.bodies[a];
        const scene::Body& second = scene_.bodies[b];
        if (const auto* said = scene::findContact(scene_, first.name, second.name);
            said && said->collides)
            return *said->collides ? "" : "-collide 0";
        for (const auto& [joined, why] :
             {std::pair(&linked_, "linked"), std::pair(&joined_, "joined"),
              std::pair(&geared_, "geared")})
            if (std::ranges::find((*joined)[a], b) != (*joined)[a].end())
                return why;
        if (first.collisionGroup && second.collisionGroup &&
            *first.collisionGroup == *second.collisionGroup)
            return "same -ct";
        return "";
    }

private:
    const scene::Scene& scene_;
    // By body, those that it never meets for a link, a joint too, a gear too.
    std::vector<std::vector<std::size_t>> linked_, joined_, geared_;
};

void addPairs(const Problem& problem, const Run& run, Explanation& explanation) {
    const auto& bodies = problem.equations.bodies;
    std::size_t fixed = 0;
    for (const auto& body : bodies)
        fixed += body.isFixed ? 1 : 0;
    if (fixed > 0)
        explanation.notModelled.push_back(
            fixed == 1 ? Explanation::NotModelled{"1 fixed body", "it does not move"}
                       : Explanation::NotModelled{std::to_string(fixed) + " fixed bodies",
                                                  "they do not move, and never meet each other"});
    if (!problem.scene.simulator.collisions) {
        explanation.notModelled.push_back({"collisions", "the scene says -collisions 0"});
        return;
    }
    explanation.tested = run.pairTests;
    explanation.candidates = run.candidates.size();
    explanation.impacts = run.impacts.size();
    explanation.isAnyResting = !run.supports.empty();
    const WhyNever whyNever(problem.scene);
    for (std::size_t a = 0; a < bodies.size(); ++a)
        for (std::size_t b = a + 1; b < bodies.size(); ++b) {
            if (std::ranges::binary_search(run.candidates, std::pair(a, b)) ||
                (bodies[a].isFixed && bodies[b].isFixed))
                continue;
            if (explanation.never.size() == mostPairs) {
                ++explanation.neverLeftOut;
                continue;
            }
            std::string why = whyNever.of(a, b);
            if (why.empty())
                why = "their boxes never overlap";
            explanation.never.push_back({bodies[a].name, bodies[b].name, std::move(why)});
        }
}

} // namespace

Explanation explanationOf(const Problem& problem, const Run& run) {
    Explanation explanation;
    Equations equations(*run.equations, run.statistics.zeroStates, run.reached);
    const std::vector<bool> isSeenOnly = seenOnly(problem, run);
    for (const solution::ComponentStatistics& c : run.statistics.componentList) {
        explanation.components.push_back(componentOf(equations, problem.start(), c));
        if (std::ranges::all_of(c.unknowns, [&](std::size_t u) { return isSeenOnly[u]; }))
            explanation.components.back().why +=
                "; no motion depends on it, so it is solved apart, to be seen";
    }
    explanation.acting = actingOn(problem, run);
    addZeroStates(problem, run, explanation);
    addPairs(problem, run, explanation);
    if (!problem.options.phasesOf.empty())
        addPhases(problem, run, explanation);
    return explanation;
}

} // namespace simulation
