#include "physics/ropes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace physics {

RopeReader::RopeReader(Graph& g, const scene::Scene& scene, Scope& scope,
                       std::span<const BodyMotion> bodies, JointMultipliers& multipliers,
                       std::vector<std::string>& faults)
    : g_(g), scene_(scene), scope_(scope), bodies_(bodies), paths_(g, scene, scope, bodies, faults),
      multipliers_(multipliers) {
    for (std::size_t r = 0; r < paths_.size() && faults.empty(); ++r) {
        const RopePath& path = paths_[r];
        for (std::size_t k = 0; k < path.spans.size(); ++k)
            for (const std::size_t end : {0U, 1U}) {
                const RopeSpan& span = path.spans[k];
                const RopePoint& wheel = path.points[end == 0 ? span.from : span.to];
                const Node angle = span.ends[end].angle;
                if (wheel.radius != 0 && g_.op(angle) == Op::symbol)
                    multipliers_.addAngle(angle, paths_.angle(r, k, end, {}).rate,
                                          std::abs(wheel.radius), path.moving.front());
            }
        for (std::size_t s = 0; s < path.stretches.size(); ++s)
            if (const auto& slid = paths_.slidBefore(r, s))
                multipliers_.addAngle(*slid, paths_.slidRate(r, s), 1, path.moving.front());
        nodes_.push_back(
            {paths_.length(r), std::vector<Node>(path.stretches.size(), g_.constant(0))});
    }
    if (faults.empty())
        scope_.setRopes(nodes_);
}

std::vector<RopeWrap> RopeReader::wraps(const expression::EquationSet& set) const {
    std::vector<RopeWrap> found;
    const auto unknownOf = [&](Node angle) {
        const auto at = std::ranges::find(set.unknowns, angle, &expression::Unknown::symbol);
        return at == set.unknowns.end()
                   ? std::nullopt
                   : std::optional(static_cast<std::size_t>(at - set.unknowns.begin()));
    };
    for (std::size_t r = 0; r < paths_.size(); ++r)
        for (const RopePoint& point : paths_[r].points) {
            if (!point.in || !point.out || point.slid)
                continue;
            const RopeWrap wrap{.rope = scene_.ropes[r].name,
                                .body = point.body ? bodies_[*point.body].name : "",
                                .in = unknownOf(*point.in),
                                .out = unknownOf(*point.out),
                                .start = point.wrapped,
                                .sign = point.radius < 0 ? -1.0 : 1.0};
            if (wrap.in || wrap.out)
                found.push_back(wrap);
        }
    return found;
}

std::vector<RopeLean> RopeReader::leans() {
    std::vector<RopeLean> found;
    for (std::size_t r = 0; r < paths_.size(); ++r)
        for (std::size_t k = 0; k < paths_[r].spans.size(); ++k)
            for (const std::size_t end : {0U, 1U})
                if (auto lean = paths_.lean(r, k, end))
                    found.push_back(*lean);
    return found;
}

void RopeReader::contribute(std::vector<Contribution>& contributions) {
    for (std::size_t r = 0; r < paths_.size(); ++r)
        if (!paths_[r].moving.empty())
            contribute(r, contributions);
    scope_.setRopes(nodes_);
}

// Angles that are unknowns of their own are kept with the places.
void RopeReader::tieAngles(std::size_t rope, std::span<const double> material) {
    for (std::size_t k = 0; k < paths_[rope].spans.size(); ++k)
        for (const std::size_t end : {0U, 1U}) {
            const Node angle = paths_[rope].spans[k].ends[end].angle;
            if (!multipliers_.needsTie(angle))
                continue;
            const Node multiplier = multipliers_.add([this, rope, k, end](const Along& along) {
                return JointCondition{paths_.tie(rope, k, end, along),
                                      JointCondition::Order::first};
            });
            multipliers_.tie(angle, multiplier);
            paths_.setTie(angle, multiplier);
        }
    for (std::size_t s = 0; s < paths_[rope].stretches.size(); ++s) {
        const auto slid = paths_.slidBefore(rope, s);
        if (!slid || !multipliers_.needsTie(*slid))
            continue;
        const Node multiplier = multipliers_.add([this, rope, s,
                                                  of = material[s]](const Along& along) {
            return JointCondition{paths_.slidTie(rope, s, of, along), JointCondition::Order::first};
        });
        multipliers_.tie(*slid, multiplier);
        paths_.setTie(*slid, multiplier);
    }
}

// A span that is slack at the start is so in the first stretch.
void RopeReader::contribute(std::size_t rope, std::vector<Contribution>& contributions) {
    const scene::Rope& said = scene_.ropes[rope];
    const RopePath& path = paths_[rope];
    multipliers_.begin({said.name, path.moving, path.size, "rope"}, said.release);
    std::vector<double> material;
    double measured = 0;
    for (std::size_t s = 0; s < path.stretches.size(); ++s) {
        material.push_back(paths_.startOf(rope, s));
        measured += material.back();
    }
    for (const RopePoint& point : path.points)
        measured += std::abs(point.radius) * point.wrapped;
    if (said.length)
        material.front() += *said.length - measured;
    tieAngles(rope, material);
    Contribution from;
    from.kind = Contribution::Kind::rope;
    from.element = rope;
    for (std::size_t s = 0; s < path.stretches.size(); ++s) {
        const auto gap = [this, rope, s, material](const Along& along) {
            return paths_.gap(rope, s, material, along);
        };
        const Node tension = multipliers_.add(
            [gap](const Along& along) { return JointCondition{.jet = gap(along)}; },
            {0, std::numeric_limits<double>::infinity(), said.restitution});
        multipliers_.keepThroughBlows(gap({}));
        nodes_[rope].tension[s] = tension;
        multipliers_.push(contributions, from, gap({}).rate, tension);
    }
    nameTensions(rope);
}

// Past a wheel that is off the tension is that before it. A stretch between what is fixed is pulled
// as the one behind it.
void RopeReader::nameTensions(std::size_t rope) {
    std::vector<Node>& tension = nodes_[rope].tension;
    for (std::size_t s = tension.size() - 1; s-- > 0;)
        if (paths_.isStill(rope, s)) {
            const Node isOff = paths_.isOffBefore(rope, s + 1);
            tension[s] = g_.apply(Op::select, isOff, tension[s], tension[s + 1]);
        }
    for (std::size_t s = 1; s < tension.size(); ++s)
        tension[s] = g_.apply(Op::select, paths_.isOffBefore(rope, s), tension[s - 1], tension[s]);
}

} // namespace physics
