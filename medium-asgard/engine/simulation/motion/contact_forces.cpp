#include "motion/contact_forces.h"

#include "motion/computed_motion.h"

#include <algorithm>
#include <map>
#include <set>
#include <span>

namespace simulation {
namespace {

using Part = ComputedMotion::Part;

// The log says of some bodies at a time which contacts they have from then on: of each body its
// last word counts.
std::vector<const ContactLog::Contact*> contactsAt(const ContactLog& log, double time) {
    const auto& entries = log.entries();
    auto after = std::ranges::upper_bound(entries, time, {}, &ContactLog::Entry::time);
    std::set<std::size_t> told;
    std::vector<const ContactLog::Contact*> found;
    while (after != entries.begin()) {
        const ContactLog::Entry& entry = *--after;
        for (const ContactLog::Contact& contact : entry.contacts)
            if (!told.contains(contact.body) && !told.contains(contact.support))
                found.push_back(&contact);
        told.insert(entry.moving.begin(), entry.moving.end());
    }
    std::ranges::reverse(found);
    return found;
}

std::vector<double> multipliersOf(const Part& part, std::span<const std::size_t> rows,
                                  double time) {
    std::vector<double> values;
    for (const std::size_t row : rows) {
        double value = 0;
        if (!part.conditions->values(row, time, std::span(&value, 1)))
            value = 0;
        values.push_back(value);
    }
    return values;
}

physics::SurfacePose poseOf(const BodyState& state) {
    return {state.position, state.attitude.toRotationMatrix()};
}

void addForces(const ComputedMotion& motion, std::size_t index, double time,
               std::vector<ContactForce>& forces) {
    const Part& part = motion.contents().parts[index];
    if (!part.conditions || part.contacts.entries().empty())
        return;
    std::map<std::size_t, std::size_t> shown; // body of the scene, by the part's
    const auto& places = motion.contents().places;
    for (std::size_t b = 0; b < places.size(); ++b)
        if (places[b].part == index)
            shown.emplace(places[b].body, b);
    // Fixed bodies stand in each part, and are shown from one of them.
    const auto stateAt = [&](std::size_t body) -> std::optional<BodyState> {
        const BodyRecord& record = (*part.bodies)[body];
        if (record.isFixed)
            return BodyState{.position = record.start.position, .attitude = record.start.attitude};
        const auto at = shown.find(body);
        return at == shown.end() ? std::nullopt : std::optional(motion.at(at->second, time));
    };
    for (const ContactLog::Contact* contact : contactsAt(part.contacts, time)) {
        const auto body = stateAt(contact->body), support = stateAt(contact->support);
        if (!body || !support)
            continue;
        const physics::ContactForce force =
            physics::forceOf(*contact->surfaces, poseOf(*body), poseOf(*support),
                             multipliersOf(part, contact->normals, time),
                             multipliersOf(part, contact->friction, time));
        if (force.force.isZero(0) || !force.force.allFinite() || !force.point.allFinite())
            continue;
        const auto [lesser, greater] = contact->bodies;
        const std::size_t on = (*part.bodies)[lesser].isFixed ? greater : lesser;
        const double side = on == contact->body ? 1 : -1;
        forces.push_back({.on = shown.at(on),
                          .point = force.point,
                          .force = side * force.force,
                          .normal = side * force.normal,
                          .friction = contact->surfaces->friction});
    }
}

} // namespace

std::vector<ContactForce> contactForcesAt(const Motion& motion, double time) {
    std::vector<ContactForce> forces;
    if (const auto* computed = dynamic_cast<const ComputedMotion*>(&motion))
        for (std::size_t part = 0; part < computed->contents().parts.size(); ++part)
            addForces(*computed, part, time, forces);
    return forces;
}

} // namespace simulation
