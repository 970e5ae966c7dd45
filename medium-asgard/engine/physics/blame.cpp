#include "physics/blame.h"

#include "expression/tape.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

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

std::string nameOf(const scene::Scene& scene, const Contribution& c) {
    using enum Contribution::Kind;
    if (c.kind == joint)
        return " \"" + scene.joints[c.element].name + "\"";
    return c.kind == rope ? " \"" + scene.ropes[c.element].name + "\"" : "";
}

// The author's expressions that drive a joint.
std::string drivesOf(const scene::Scene& scene, const Contribution& c) {
    std::string drives;
    if (c.kind == Contribution::Kind::joint)
        for (const scene::JointCoordinate& q : scene.joints[c.element].coordinates)
            for (const auto& [option, given] :
                 {std::pair("-motor", &q.motor), std::pair("-speed", &q.speed),
                  std::pair("-position", &q.position)})
                if (*given)
                    drives += std::string(", ") + option + " \"" + shortened(**given) + "\",";
    return drives;
}

} // namespace

Suspects::Suspects(const scene::Scene& scene, const EquationsOfMotion& equations)
    : scene_(scene), equations_(equations) {
    for (std::size_t u = 0; u < equations.set.unknowns.size(); ++u)
        unknownOf_.emplace(equations.set.unknowns[u].symbol.index, u);
    for (std::size_t i = 0; i < equations.contributions.size(); ++i)
        contributionsOn_[equations.contributions[i].body].push_back(i);
}

std::array<double, 3> Suspects::valueOf(const NodeVector& nodes, const Instant& now) const {
    const std::vector<Node> inputs = expression::symbolsOf(equations_.set.graph, nodes);
    std::vector<double> values;
    for (const Node symbol : inputs) {
        const auto unknown = unknownOf_.find(symbol.index);
        values.push_back(unknown == unknownOf_.end() ? now.time : now.value(unknown->second));
    }
    std::array<double, 3> value{};
    expression::Tape::Scratch scratch;
    expression::Tape(equations_.set.graph, inputs, nodes).evaluate(values, value, scratch);
    return value;
}

// In their order.
std::vector<std::size_t> Suspects::on(std::span<const std::size_t> bodies) const {
    std::vector<std::size_t> all;
    for (const std::size_t body : bodies)
        if (const auto found = contributionsOn_.find(body); found != contributionsOn_.end())
            all.insert(all.end(), found->second.begin(), found->second.end());
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

std::string Suspects::atWheel(const Contribution& of, const Instant& now) const {
    constexpr double near = 1e-3; // a motion ends a little before
    constexpr double inPlane = 1; // degrees
    for (const RopeLean& lean : equations_.ropeLeans) {
        if (of.kind != Contribution::Kind::rope || lean.rope != of.element)
            continue;
        const auto [out, way, none] = valueOf({lean.out, lean.way, lean.way}, now);
        const double within = std::sqrt(std::max(0.0, way * way - out * out));
        if (!(within <= (1 + near) * lean.least))
            continue;
        const double leans = std::abs(std::asin(std::clamp(out / way, -1.0, 1.0)));
        const double degrees = leans * 180 / std::numbers::pi;
        char text[200];
        if (degrees > inPlane)
            std::snprintf(text, sizeof text,
                          "\" leads %.3g degrees out of its plane and over its side, which is not "
                          "modelled",
                          degrees);
        else
            std::snprintf(text, sizeof text,
                          "\" comes as near as %.4g to its centre, from where a rope cannot leave "
                          "the wheel",
                          within);
        return "rope \"" + scene_.ropes[lean.rope].name + "\" at the wheel of body \"" +
               scene_.bodies[lean.body].name + text;
    }
    return "";
}

std::vector<Blame> Suspects::notFinite(const Instant& now,
                                       std::span<const std::size_t> onBodies) const {
    std::vector<Blame> found;
    for (const std::size_t i : on(onBodies)) {
        const Contribution& c = equations_.contributions[i];
        // What is written says more than what follows from it.
        for (const NodeVector& nodes : {c.written.value_or(c.force), c.force, c.torque}) {
            const auto value = valueOf(nodes, now);
            const auto bad =
                std::ranges::find_if_not(value, [](double x) { return std::isfinite(x); });
            if (bad == value.end())
                continue;
            found.push_back({.contribution = i,
                             .axis = static_cast<std::size_t>(bad - value.begin()),
                             .isWritten = c.written && nodes == *c.written,
                             .value = *bad,
                             .said = atWheel(c, now)});
            break;
        }
    }
    return found;
}

std::optional<Blame> Suspects::growing(const Instant& before, const Instant& now,
                                       std::span<const std::size_t> onBodies) const {
    constexpr double much = 1000, enormous = 1e100; // what no motion may reach
    std::optional<Blame> largest;
    for (const std::size_t i : on(onBodies)) {
        const Contribution& c = equations_.contributions[i];
        // A link's place is no force.
        const bool isWritten = c.written && c.kind == Contribution::Kind::force;
        const NodeVector& nodes = isWritten ? *c.written : c.force;
        const auto was = valueOf(nodes, before), is = valueOf(nodes, now);
        for (std::size_t axis = 0; axis < is.size(); ++axis)
            if (std::abs(is[axis]) > std::min(much * std::abs(was[axis]), enormous) &&
                (!largest || std::abs(is[axis]) > std::abs(largest->value)))
                largest = Blame{i, axis, isWritten, is[axis], atWheel(c, now)};
    }
    return largest;
}

std::string inWords(const scene::Scene& scene, const EquationsOfMotion& equations,
                    const Blame& blame) {
    if (!blame.said.empty())
        return blame.said;
    const Contribution& c = equations.contributions[blame.contribution];
    const auto* texts = blame.isWritten ? expressionsOf(scene, c) : nullptr;
    const bool isFinite = std::isfinite(blame.value);
    std::string value = std::isnan(blame.value) ? "not a number" : "infinite";
    if (isFinite) {
        char digits[40];
        std::snprintf(digits, sizeof digits, "%.2g", blame.value);
        value = digits;
    }
    static constexpr std::array<const char*, 5> kinds = {"force", "link", "joint", "gear", "rope"};
    const bool isSpring =
        c.kind == Contribution::Kind::link && scene.links[c.element].spring.has_value();
    return std::string("the ") + (isSpring ? "spring" : kinds[static_cast<std::size_t>(c.kind)]) +
           nameOf(scene, c) + " on body \"" + scene.bodies[c.body].name + "\"" +
           drivesOf(scene, c) + " " + (isFinite ? "grows without bound" : "is not finite") +
           ": its " + axes[blame.axis] +
           (texts ? ", \"" + shortened((*texts)[blame.axis]) + "\"," : "") + " is " + value;
}

bool hasExpression(const EquationsOfMotion& equations, const Blame& blame) {
    using enum Contribution::Kind;
    const auto kind = equations.contributions[blame.contribution].kind;
    return kind == force || kind == link || kind == joint;
}

std::string optionOf(const Blame& blame) {
    return blame.isWritten ? std::string("-") + axes[blame.axis] : std::string();
}

} // namespace physics
