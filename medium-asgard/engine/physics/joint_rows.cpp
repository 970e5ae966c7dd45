#include "physics/joint_rows.h"

#include "expression/tape.h"

#include <algorithm>

namespace physics {

JointRows::JointRows(const EquationsOfMotion& equations)
    : equations_(equations), neighbours_(equations.bodies.size()), rows_(equations.bodies.size()) {
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

std::vector<ImpactRow>
JointRows::rowsAt(std::span<const std::size_t> bodies, double time,
                  const std::function<BodyValues(std::size_t body)>& stateOf,
                  const std::function<bool(std::size_t multiplier)>& isReleased) const {
    std::vector<std::size_t> rows;
    for (const std::size_t body : bodies)
        rows.insert(rows.end(), rows_[body].begin(), rows_[body].end());
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    std::erase_if(rows,
                  [&](std::size_t r) { return isReleased(equations_.jointRows[r].multiplier); });
    if (rows.empty())
        return {};
    const expression::Graph& g = equations_.set.graph;
    std::vector<Node> outputs, inputs{equations_.set.time};
    for (const std::size_t r : rows)
        for (const JointPush& push : equations_.jointRows[r].pushes) {
            outputs.insert(outputs.end(), push.linear.begin(), push.linear.end());
            outputs.insert(outputs.end(), push.angular.begin(), push.angular.end());
        }
    const std::vector<Node> symbols = expression::symbolsOf(g, outputs);
    std::vector<double> values{time};
    for (const std::size_t body : bodies) {
        const BodyMotion& motion = equations_.bodies[body];
        if (motion.isFixed)
            continue;
        const auto unknowns = motion.unknownsOf(stateOf(body));
        for (std::size_t i = 0; i < bodyUnknowns; ++i)
            if (const Node symbol = equations_.set.unknowns[motion.firstUnknown + i].symbol;
                std::ranges::binary_search(symbols, symbol)) {
                inputs.push_back(symbol);
                values.push_back(unknowns[i]);
            }
    }
    std::vector<double> found(outputs.size());
    expression::Tape::Scratch scratch;
    expression::Tape(g, inputs, outputs).evaluate(values, found, scratch);
    std::vector<ImpactRow> made;
    const double* next = found.data();
    for (const std::size_t r : rows) {
        ImpactRow row;
        for (const JointPush& push : equations_.jointRows[r].pushes) {
            const auto place = std::ranges::find(bodies, push.body) - bodies.begin();
            row.parts.push_back({.body = static_cast<std::size_t>(place),
                                 .linear = Vector(next[0], next[1], next[2]),
                                 .angular = Vector(next[3], next[4], next[5])});
            next += 6;
        }
        made.push_back(std::move(row));
    }
    return made;
}

} // namespace physics
