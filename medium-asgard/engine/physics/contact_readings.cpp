#include "physics/contact_readings.h"

#include "physics/contact_rows.h"
#include "scene/contact_pairs.h"

#include <algorithm>
#include <unordered_map>

namespace physics {
namespace {

constexpr std::array<const char*, ContactForces::count> names{
    "n", "fx", "fy", "fz", "cx", "cy", "cz", "mx", "my", "mz", "sx", "sy", "sz"};

NodeVector vectorAt(std::span<const Node> nodes, std::size_t i) {
    return {nodes[i], nodes[i + 1], nodes[i + 2]};
}

} // namespace

ContactForces::Nodes ContactForces::nodes() const {
    Nodes all{normal};
    std::size_t i = 1;
    for (const NodeVector* vector : {&force, &couple, &moment, &slip})
        for (const Node node : *vector)
            all[i++] = node;
    return all;
}

// Of two dots, which no name in an expression has.
void addContactReadings(expression::EquationSet& set, const scene::Scene& scene, Scope& scope) {
    std::vector<std::optional<ContactNodes>> nodes(scene.contacts.size());
    const scene::ContactPairs pairs(scene);
    for (const auto& [pair, contact] : pairs.all()) {
        const scene::Contact& of = scene.contacts[contact];
        if (of.name.empty())
            continue;
        ContactForces::Nodes symbols;
        for (std::size_t i = 0; i < symbols.size(); ++i) {
            symbols[i] = set.graph.symbol(of.name + ".contact." + names[i]);
            set.readings.push_back({symbols[i], {{.node = set.graph.constant(0)}}});
        }
        const bool isFirst = !scene.bodies[pair.first].fixed;
        nodes[contact] = ContactNodes{.normal = symbols[0],
                                      .force = vectorAt(symbols, 1),
                                      .couple = vectorAt(symbols, 4),
                                      .moment = vectorAt(symbols, 7),
                                      .slip = vectorAt(symbols, 10),
                                      .moving = isFirst ? pair.first : pair.second,
                                      .other = isFirst ? pair.second : pair.first};
    }
    scope.setContacts(std::move(nodes));
}

std::vector<ContactReader> withoutContacts(expression::EquationSet& set) {
    std::vector<ContactReader> readers;
    if (set.readings.empty())
        return readers;
    std::unordered_map<std::uint32_t, Node> none;
    for (const expression::Reading& reading : set.readings)
        none.emplace(reading.symbol.index, set.graph.constant(0));
    for (std::size_t u = 0; u < set.unknowns.size(); ++u)
        for (expression::Phase& phase : set.unknowns[u].phases) {
            if (!phase.given)
                continue;
            const Node without = substitute(set.graph, *phase.given, none);
            if (without == *phase.given)
                continue;
            readers.push_back({u, *phase.given});
            phase.given = without;
        }
    return readers;
}

std::size_t firstReadingOf(const expression::EquationSet& set, const ContactNodes& contact) {
    const auto found =
        std::ranges::find(set.readings, contact.normal, &expression::Reading::symbol);
    return static_cast<std::size_t>(found - set.readings.begin());
}

// The rates of conditions say how they push: by their derivatives by velocities.
ContactForces ContactRows::forcesOf(const ContactPlace& place, std::span<const Node> multipliers,
                                    std::size_t on) {
    owner_ = multipliers[0];
    const NodeVector none = constant(g_, Vector::Zero());
    ContactForces forces{g_.constant(0), none, none, none, none};
    const BodySymbols& s = symbols(on);
    for (const Row& row : rows_) {
        if (std::ranges::find(multipliers, row.multiplier) == multipliers.end())
            continue;
        for (const auto& [body, by] : row.by) {
            if (body != on)
                continue;
            const NodeVector couple = s.isSpinInWorldAxes ? by.angular : s.toWorld(g_, by.angular);
            forces.force = add(g_, forces.force, scaled(g_, row.multiplier, by.linear));
            forces.couple = add(g_, forces.couple, scaled(g_, row.multiplier, couple));
        }
    }
    for (std::size_t k = 0; k < place.points.size(); ++k) {
        const NodeVector arm = meetingOf(place, place.points[k].gap).arms[on == place.body ? 0 : 1];
        forces.normal = g_.add(forces.normal, multipliers[k]);
        forces.moment = add(g_, forces.moment, scaled(g_, multipliers[k], arm));
    }
    const Frame frame = frameOf(place);
    const NodeVector speed = slipOf(place, frame);
    for (const NodeVector& along : frame.along)
        forces.slip = add(g_, forces.slip, scaled(g_, dot(g_, along, speed), along));
    return forces;
}

} // namespace physics
