#include "events/crushed.h"

#include "events/sentences.h"

#include <algorithm>

namespace simulation {
namespace {

// With whatever force that takes.
bool isDriven(const scene::Joint& joint) {
    return std::ranges::any_of(joint.coordinates, [](const scene::JointCoordinate& of) {
        return (of.speed || of.position) && !of.maxMotor;
    });
}

} // namespace

Crushed crushedBy(const scene::Scene& scene, const physics::EquationsOfMotion& equations,
                  const physics::Crushing& found, std::span<const std::size_t> bodies,
                  std::span<const physics::ImpactRow> joints) {
    std::set<std::string> drives;
    for (const std::size_t row : found.joints)
        if (const auto multiplier = joints[row].multiplier) {
            const std::string& name = equations.set.unknowns[*multiplier].name;
            if (const scene::Joint* of = scene::findJoint(scene, name); of && isDriven(*of))
                drives.insert(name);
        }
    const auto inScene = [&](const std::vector<std::size_t>& places) {
        std::set<std::size_t> all;
        for (const std::size_t place : places)
            all.insert(bodies[place]);
        return all;
    };
    const auto pressed = inScene(found.pressed);
    return {sentences::crushed(scene, pressed, inScene(found.between), drives), pressed};
}

std::optional<Crushed> crushedIn(const Instant& instant, const ImpactCluster& cluster,
                                 std::span<const physics::ImpactContact> contacts,
                                 std::span<const physics::ImpactBody> before,
                                 physics::Sides sides) {
    const physics::Crushing found = physics::crushingOf(before, contacts, cluster.joints, sides);
    if (found.contacts.empty())
        return std::nullopt;
    return crushedBy(instant.world.scene, instant.world.equations, found, cluster.bodies,
                     cluster.joints);
}

} // namespace simulation
