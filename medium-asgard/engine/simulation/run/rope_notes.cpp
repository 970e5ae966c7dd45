#include "run/rope_notes.h"

#include "expression/tape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <optional>
#include <set>

namespace simulation {
namespace {

// The first time at which it is so, to rounding, of samples; none: at none of them.
std::optional<double> firstTime(double from, double until,
                                const std::function<bool(double)>& isSo) {
    constexpr int samples = 500, halvings = 40;
    const double step = (until - from) / samples;
    int i = 0;
    while (i <= samples && !isSo(from + i * step))
        ++i;
    if (i > samples)
        return std::nullopt;
    double before = from + std::max(i - 1, 0) * step, after = from + i * step;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (before + after);
        (isSo(middle) ? after : before) = middle;
    }
    return after;
}

std::string atTime(double t) {
    char text[40];
    std::snprintf(text, sizeof text, " at t = %.4g", t);
    return text;
}

// LIMIT: a rope that is wrapped by less than nothing is kept on its wheel; that is told.
void addLiftOffs(const Problem& problem, const solution::Histories& histories, double until,
                 std::vector<std::string>& notes) {
    constexpr double none = -1e-6; // radians
    for (const physics::RopeWrap& wrap : problem.equations.ropeWraps) {
        const auto valueOf = [&](std::optional<std::size_t> angle, double t) {
            return angle ? histories.value(*angle, t) : 0;
        };
        const auto off = firstTime(problem.start(), until, [&](double t) {
            return wrap.start + wrap.sign * (valueOf(wrap.out, t) - valueOf(wrap.in, t)) < none;
        });
        if (off)
            notes.push_back("rope \"" + wrap.rope + "\": it would lift off the wheel of body \"" +
                            wrap.body + "\"" + atTime(*off) +
                            ", which is not modelled: it goes on as if it were wrapped backwards");
    }
}

// The sine of the angle by which a span leads out of the plane of its wheel.
class Lean {
public:
    Lean(const Problem& problem, const physics::RopeLean& of)
        : nodes_{of.out, of.way}, set_(problem.equations.set),
          inputs_(expression::symbolsOf(set_.graph, nodes_)), tape_(set_.graph, inputs_, nodes_) {
        for (const expression::Node symbol : inputs_) {
            const auto at = std::ranges::find(set_.unknowns, symbol, &expression::Unknown::symbol);
            if (at != set_.unknowns.end())
                unknowns_.emplace_back(at - set_.unknowns.begin());
            else
                unknowns_.emplace_back(); // the time
        }
        in_.resize(inputs_.size());
    }

    double sine(const solution::Histories& histories, double t) {
        for (std::size_t i = 0; i < in_.size(); ++i)
            in_[i] = unknowns_[i] ? histories.value(*unknowns_[i], t) : t;
        std::array<double, 2> out{};
        tape_.evaluate(in_, out, scratch_);
        return std::abs(out[0]) / out[1];
    }

private:
    std::array<expression::Node, 2> nodes_;
    const expression::EquationSet& set_;
    std::vector<expression::Node> inputs_;
    expression::Tape tape_;
    std::vector<std::optional<std::size_t>> unknowns_;
    std::vector<double> in_;
    expression::Tape::Scratch scratch_;
};

// LIMIT: a rope that leaves the plane of its wheel does so as if a groove led it; that is told.
void addLeans(const Problem& problem, const solution::Histories& histories, double until,
              std::vector<std::string>& notes) {
    constexpr double most = 0.1; // radians
    std::set<std::pair<std::size_t, std::size_t>> told;
    for (const physics::RopeLean& of : problem.equations.ropeLeans) {
        if (told.contains({of.rope, of.body}))
            continue;
        Lean lean(problem, of);
        const auto out = firstTime(problem.start(), until, [&](double t) {
            return lean.sine(histories, t) > std::sin(most);
        });
        if (!out)
            continue;
        told.emplace(of.rope, of.body);
        char text[40];
        std::snprintf(text, sizeof text, "%.2g", most * 180 / std::numbers::pi);
        notes.push_back("rope \"" + problem.scene.ropes[of.rope].name + "\": it leads more than " +
                        text + " degrees out of the plane of the wheel of body \"" +
                        problem.scene.bodies[of.body].name + "\"" + atTime(*out) +
                        "; it goes on as if a groove of that wheel led it there");
    }
}

} // namespace

void addRopeNotes(const Problem& problem, const solution::Histories& histories, double until,
                  std::vector<std::string>& notes) {
    addLiftOffs(problem, histories, until, notes);
    addLeans(problem, histories, until, notes);
}

} // namespace simulation
