#include "reports/switch_instants.h"

#include "expression/tape.h"
#include "physics/equations_of_motion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <unordered_map>

namespace simulation {
namespace {

using expression::Node;

// Who reads the motion's value of a symbol.
struct Source {
    std::size_t body = 0, place = 0; // of its thirteen unknowns
    double otherwise = 0;            // where it is not solved
};

class Switches {
public:
    Switches(const physics::EquationsOfMotion& equations, const ComputedMotion& motion)
        : equations_(equations), motion_(motion) {
        for (std::size_t b = 0; b < equations.bodies.size(); ++b)
            for (std::size_t i = 0; i < physics::bodyUnknowns && !equations.bodies[b].isFixed;
                 ++i) {
                const auto& unknown = equations.set.unknowns[equations.bodies[b].firstUnknown + i];
                sources_.emplace(unknown.symbol.index, Source{b, i, unknown.initial});
            }
    }

    [[nodiscard]] std::vector<double> of(std::size_t body) {
        found_.clear();
        for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
            follow(body, equations_.set.unknowns[equations_.bodies[body].firstUnknown + i].phases);
        return std::move(found_);
    }

private:
    using Phases = std::vector<expression::Phase>;

    void follow(std::size_t body, const Phases& phases) {
        for (std::size_t p = 0; p < phases.size(); ++p) {
            const Node node = phases[p].given.value_or(phases[p].derivative);
            const std::vector<Node> symbols =
                expression::symbolsOf(equations_.set.graph, std::span(&node, 1));
            const expression::Tape tape(equations_.set.graph, symbols, std::span(&node, 1));
            if (tape.decisions() == 0)
                continue;
            const double until = p + 1 < phases.size() ? phases[p + 1].from : HUGE_VAL;
            compare(body, tape, symbols, std::max(phases[p].from, motion_.start()), until);
        }
    }

    // Of neighbouring steps.
    void compare(std::size_t body, const expression::Tape& tape, const std::vector<Node>& symbols,
                 double from, double until) {
        const auto [record, histories] = motion_.of(body);
        const double end = std::min(until, motion_.computed());
        std::vector<expression::Decision> before, now(tape.decisions());
        std::vector<double> guards(tape.decisions());
        for (double time = from; time < end;) {
            double next = end;
            for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
                if (const double at = histories.piece(record.firstUnknown + i, time).until;
                    at > time)
                    next = std::min(next, at);
            tape.decide(valuesAt(symbols, (time + next) / 2), now, guards, scratch_);
            if (!before.empty() && before != now)
                found_.push_back(time);
            before = now;
            time = next;
        }
    }

    // Of multipliers none: they decide nothing, and what reads them has no branch.
    [[nodiscard]] std::vector<double> valuesAt(const std::vector<Node>& symbols,
                                               double time) const {
        std::vector<double> values;
        for (const Node symbol : symbols) {
            if (symbol == equations_.set.time) {
                values.push_back(time);
                continue;
            }
            const auto source = sources_.find(symbol.index);
            values.push_back(source == sources_.end() ? std::nan("")
                                                      : valueAt(source->second, time));
        }
        return values;
    }

    [[nodiscard]] double valueAt(const Source& source, double time) const {
        const auto [record, histories] = motion_.of(source.body);
        const double value = histories.value(record.firstUnknown + source.place, time);
        return std::isnan(value) ? source.otherwise : value;
    }

    const physics::EquationsOfMotion& equations_;
    const ComputedMotion& motion_;
    std::unordered_map<std::uint32_t, Source> sources_; // by symbol
    std::vector<double> found_;
    expression::Tape::Scratch scratch_;
};

} // namespace

std::vector<std::pair<double, std::size_t>> switchInstants(const scene::Scene& scene,
                                                           const ComputedMotion& motion) {
    const physics::EquationsOfMotion equations(scene);
    std::vector<std::pair<double, std::size_t>> found;
    if (!equations.faults.empty())
        return found;
    Switches switches(equations, motion);
    for (std::size_t body = 0; body < equations.bodies.size(); ++body)
        if (!equations.bodies[body].isFixed)
            for (const double time : switches.of(body))
                found.emplace_back(time, body);
    return found;
}

} // namespace simulation
