#include "events/crushed.h"

#include "events/sentences.h"

#include <algorithm>

namespace simulation {
namespace {

bool isDriven(const scene::Joint& joint) {
    return std::ranges::any_of(joint.coordinates, [](const scene::JointCoordinate& of) {
        return of.speed.has_value() || of.position.has_value();
    });
}

} // namespace

std::optional<Crushed> crushedIn(const Instant& instant, const ImpactCluster& cluster,
                                 std::span<const physics::ImpactContact> contacts,
                                 std::span<const physics::ImpactBody> before,
                                 physics::Sides sides) {
    const physics::Crushing found = physics::crushingOf(before, contacts, cluster.joints, sides);
    if (found.contacts.empty())
        return std::nullopt;
    const Colliders& world = instant.world;
    std::set<std::string> drives;
    for (const std::size_t row : found.joints)
        if (const auto multiplier = cluster.joints[row].multiplier) {
            const std::string& name = world.equations.set.unknowns[*multiplier].name;
            if (const scene::Joint* of = scene::findJoint(world.scene, name); of && isDriven(*of))
                drives.insert(name);
        }
    const auto inScene = [&](const std::vector<std::size_t>& places) {
        std::set<std::size_t> bodies;
        for (const std::size_t place : places)
            bodies.insert(cluster.bodies[place]);
        return bodies;
    };
    const auto pressed = inScene(found.pressed);
    return Crushed{sentences::crushed(world.scene, pressed, inScene(found.between), drives),
                   pressed};
}

} // namespace simulation
