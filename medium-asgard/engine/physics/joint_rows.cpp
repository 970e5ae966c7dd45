#include "physics/joint_rows.h"

#include "expression/tape.h"

#include <algorithm>
#include <set>

namespace physics {

JointRows::JointRows(const EquationsOfMotion& equations)
    : equations_(equations), neighbours_(equations.bodies.size()),
      isMoved_(equations.bodies.size(), 0), rows_(equations.bodies.size()) {
    findMoved();
    for (std::size_t r = 0; r < equations.jointRows.size(); ++r)
        for (const JointPush& push : equations.jointRows[r].pushes) {
            rows_[push.body].push_back(r);
            for (const JointPush& other : equations.jointRows[r].pushes) {
                std::vector<std::size_t>& known = neighbours_[push.body];
                if (other.body != push.body && std::ranges::find(known, other.body) == known.end())
                    known.push_back(other.body);
            }
        }
}

// Bodies whose velocities read a multiplier.
void JointRows::findMoved() {
    const expression::EquationSet& set = equations_.set;
    std::set<Node> multipliers;
    for (const expression::Unknown& unknown : set.unknowns)
        if (unknown.phases.front().condition)
            multipliers.insert(unknown.symbol);
    for (std::size_t b = 0; b < equations_.bodies.size() && !multipliers.empty(); ++b) {
        if (equations_.bodies[b].isFixed)
            continue;
        std::vector<Node> rates;
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            for (const expression::Phase& phase :
                 set.unknowns[equations_.bodies[b].firstUnknown + i].phases)
                rates.push_back(phase.derivative);
        isMoved_[b] = std::ranges::any_of(expression::symbolsOf(set.graph, rates),
                                          [&](Node n) { return multipliers.contains(n); });
    }
}

// That are not gone, each once.
std::vector<std::size_t> JointRows::rowsOf(std::span<const std::size_t> bodies,
                                           const Motion& motion) const {
    std::vector<std::size_t> rows;
    for (const std::size_t body : bodies)
        rows.insert(rows.end(), rows_[body].begin(), rows_[body].end());
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::erase_if(rows, [&](std::size_t r) {
        return motion.multiplierOf(equations_.jointRows[r].multiplier) == State::gone;
    });
    return rows;
}

std::vector<double> JointRows::evaluated(std::span<const Node> outputs,
                                         std::span<const std::size_t> bodies, double time,
                                         const Motion& motion) const {
    const expression::Graph& g = equations_.set.graph;
    const std::vector<Node> symbols = expression::symbolsOf(g, outputs);
    std::vector<Node> inputs{equations_.set.time};
    std::vector<double> values{time};
    const auto take = [&](std::size_t unknown, const std::function<double()>& value) {
        const Node symbol = equations_.set.unknowns[unknown].symbol;
        if (!std::ranges::binary_search(symbols, symbol))
            return;
        inputs.push_back(symbol);
        values.push_back(value());
    };
    for (const std::size_t body : bodies) {
        const BodyMotion& of = equations_.bodies[body];
        if (of.isFixed)
            continue;
        const auto unknowns = of.unknownsOf(motion.stateOf(body));
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            take(of.firstUnknown + i, [&] { return unknowns[i]; });
    }
    std::size_t behind = 0; // bodies' unknowns
    for (const BodyMotion& of : equations_.bodies)
        behind = of.isFixed ? behind : std::max(behind, of.firstUnknown + bodyUnknowns);
    for (std::size_t u = behind; u < equations_.set.unknowns.size(); ++u)
        take(u, [&] { return motion.valueOf(u); });
    std::vector<double> found(outputs.size());
    expression::Tape::Scratch scratch;
    expression::Tape(g, inputs, outputs).evaluate(values, found, scratch);
    return found;
}

std::vector<ImpactRow> JointRows::rowsAt(std::span<const std::size_t> bodies, double time,
                                         const Motion& motion) const {
    const std::vector<std::size_t> rows = rowsOf(bodies, motion);
    if (rows.empty())
        return {};
    std::vector<Node> outputs;
    for (const std::size_t r : rows) {
        outputs.push_back(equations_.jointRows[r].gap.value_or(equations_.set.time));
        for (const JointPush& push : equations_.jointRows[r].pushes) {
            outputs.insert(outputs.end(), push.linear.begin(), push.linear.end());
            outputs.insert(outputs.end(), push.angular.begin(), push.angular.end());
        }
    }
    const std::vector<double> found = evaluated(outputs, bodies, time, motion);
    std::vector<ImpactRow> made;
    const double* next = found.data();
    for (const std::size_t r : rows) {
        const JointRow& of = equations_.jointRows[r];
        const double gap = *next++;
        ImpactRow row{.parts = {}, .isStop = of.gap.has_value(), .multiplier = of.multiplier};
        for (const JointPush& push : of.pushes) {
            const auto place = std::ranges::find(bodies, push.body) - bodies.begin();
            row.parts.push_back({.body = static_cast<std::size_t>(place),
                                 .linear = Vector(next[0], next[1], next[2]),
                                 .angular = Vector(next[3], next[4], next[5])});
            next += 6;
        }
        if (!of.gap || gap <= of.resolution || motion.multiplierOf(of.multiplier) == State::held)
            made.push_back(std::move(row));
    }
    return made;
}

} // namespace physics
