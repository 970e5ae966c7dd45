#include "physics/blame.h"

#include "expression/tape.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace physics {
namespace {

constexpr std::array<const char*, 3> axes = {"x", "y", "z"};

const std::array<scene::Expression, 3>* expressionsOf(const scene::Scene& scene,
                                                      const Contribution& c) {
    if (c.kind == Contribution::Kind::force) {
        const auto* given = std::get_if<scene::ComponentForce>(&scene.forces[c.element].kind);
        return given ? &given->components : nullptr;
    }
    const auto* given = std::get_if<scene::PointEnd>(&scene.links[c.element].second);
    return given ? &given->coordinates : nullptr;
}

// Of a long expression both ends.
std::string shortened(const std::string& expression) {
    constexpr std::size_t most = 72, tail = 16;
    std::string line = expression;
    std::ranges::replace_if(
        line, [](char c) { return c == '\n' || c == '\t' || c == '\r'; }, ' ');
    if (line.size() <= most)
        return line;
    const auto isInside = [&](std::size_t at) { // a character of several bytes
        return (static_cast<unsigned char>(line[at]) & 0xc0) == 0x80;
    };
    std::size_t end = most - tail - 5, begin = line.size() - tail;
    while (end > 0 && isInside(end))
        --end;
    while (begin < line.size() && isInside(begin))
        ++begin;
    return line.substr(0, end) + " ... " + line.substr(begin);
}

class Values {
public:
    Values(const EquationsOfMotion& equations, const Instant& now)
        : equations_(equations), values_(now.state.begin(), now.state.end()) {
        for (const expression::Unknown& unknown : equations.set.unknowns)
            inputs_.push_back(unknown.symbol);
        inputs_.push_back(equations.set.time);
        values_.push_back(now.time);
    }
    [[nodiscard]] std::array<double, 3> of(const NodeVector& nodes) {
        std::array<double, 3> value{};
        expression::Tape(equations_.set.graph, inputs_, nodes).evaluate(values_, value, scratch_);
        return value;
    }

private:
    const EquationsOfMotion& equations_;
    std::vector<Node> inputs_;
    std::vector<double> values_;
    expression::Tape::Scratch scratch_;
};

bool isAmong(std::size_t body, std::span<const std::size_t> bodies) {
    return bodies.empty() || std::ranges::find(bodies, body) != bodies.end();
}

} // namespace

std::vector<Blame> whatIsNotFinite(const EquationsOfMotion& equations, const Instant& now,
                                   std::span<const std::size_t> onBodies) {
    Values values(equations, now);
    std::vector<Blame> found;
    for (std::size_t i = 0; i < equations.contributions.size(); ++i) {
        const Contribution& c = equations.contributions[i];
        if (!isAmong(c.body, onBodies))
            continue;
        // What is written says more than what follows from it.
        for (const NodeVector& nodes : {c.written.value_or(c.force), c.force, c.torque}) {
            const auto value = values.of(nodes);
            const auto bad =
                std::ranges::find_if_not(value, [](double x) { return std::isfinite(x); });
            if (bad == value.end())
                continue;
            found.push_back({.contribution = i,
                             .axis = static_cast<std::size_t>(bad - value.begin()),
                             .isWritten = c.written && nodes == *c.written,
                             .value = *bad});
            break;
        }
    }
    return found;
}

std::optional<Blame> whatGrows(const EquationsOfMotion& equations, const Instant& before,
                               const Instant& now, std::span<const std::size_t> onBodies) {
    constexpr double much = 1000;
    Values valuesBefore(equations, before), valuesNow(equations, now);
    std::optional<Blame> largest;
    for (std::size_t i = 0; i < equations.contributions.size(); ++i) {
        const Contribution& c = equations.contributions[i];
        if (!isAmong(c.body, onBodies))
            continue;
        // A link's place is no force.
        const bool isWritten = c.written && c.kind == Contribution::Kind::force;
        const NodeVector& nodes = isWritten ? *c.written : c.force;
        const auto was = valuesBefore.of(nodes), is = valuesNow.of(nodes);
        for (std::size_t axis = 0; axis < is.size(); ++axis)
            if (std::abs(is[axis]) > much * std::abs(was[axis]) &&
                (!largest || std::abs(is[axis]) > std::abs(largest->value)))
                largest = Blame{i, axis, isWritten, is[axis]};
    }
    return largest;
}

std::string inWords(const scene::Scene& scene, const EquationsOfMotion& equations,
                    const Blame& blame) {
    const Contribution& c = equations.contributions[blame.contribution];
    const auto* texts = blame.isWritten ? expressionsOf(scene, c) : nullptr;
    const bool isFinite = std::isfinite(blame.value);
    std::string value = std::isnan(blame.value) ? "not a number" : "infinite";
    if (isFinite) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.2g", blame.value);
        value = digits;
    }
    return std::string("the ") + (c.kind == Contribution::Kind::force ? "force" : "link") +
           " on body \"" + scene.bodies[c.body].name + "\" " +
           (isFinite ? "grows without bound" : "is not finite") + ": its " + axes[blame.axis] +
           (texts ? ", \"" + shortened((*texts)[blame.axis]) + "\"," : "") + " is " + value;
}

std::string optionOf(const Blame& blame) {
    return blame.isWritten ? std::string("-") + axes[blame.axis] : std::string();
}

} // namespace physics
