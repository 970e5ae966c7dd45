#include "meetings/may_meet.h"

#include "scene/contact_pairs.h"

#include <algorithm>
#include <utility>

namespace simulation {

MayMeet::MayMeet(const scene::Scene& scene) : joined_(scene::joinedBodies(scene)) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        isFixed_.push_back(scene.bodies[b].fixed);
        groups_.push_back(scene.bodies[b].collisionGroup);
        isChoosy_.push_back(groups_[b].has_value() || !joined_[b].empty());
    }
    const scene::ContactPairs pairs(scene);
    for (const auto& [pair, contact] : pairs.all())
        if (const auto collides = scene.contacts[contact].collides) {
            said_[pair] = *collides;
            isChoosy_[pair.first] = isChoosy_[pair.second] = 1;
        }
}

std::vector<std::size_t> MayMeet::release(const scene::Scene& scene,
                                          const scene::Released& released) {
    const auto before = std::exchange(joined_, scene::joinedBodies(scene, released));
    std::vector<std::size_t> bodies;
    for (std::size_t b = 0; b < before.size(); ++b)
        if (std::ranges::any_of(before[b], [&](std::size_t other) { return (*this)(b, other); }))
            bodies.push_back(b);
    return bodies;
}

bool MayMeet::mayChoosyMeet(std::size_t a, std::size_t b) const {
    if (const auto said = said_.find(std::minmax(a, b)); said != said_.end())
        return said->second;
    if (groups_[a] && groups_[b] && *groups_[a] == *groups_[b])
        return false;
    return std::ranges::find(joined_[a], b) == joined_[a].end();
}

bool MayMeet::isPassing(const Pair& pair, double time) const {
    return std::ranges::any_of(passing_,
                               [&](const Passing& p) { return p.pair == pair && p.until > time; });
}

} // namespace simulation
