#include "scene/contact_pairs.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <unordered_map>

namespace scene {

ContactPairs::ContactPairs(const Scene& scene) : scene_(scene) {
    if (scene.contacts.empty())
        return;
    std::unordered_map<std::string_view, std::size_t> bodies;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        bodies.try_emplace(scene.bodies[b].name, b);
    for (std::size_t c = 0; c < scene.contacts.size(); ++c) {
        const auto first = bodies.find(scene.contacts[c].body1);
        const auto second = bodies.find(scene.contacts[c].body2);
        if (first != bodies.end() && second != bodies.end())
            contacts_.try_emplace(std::minmax(first->second, second->second), c);
    }
}

const Contact* ContactPairs::find(std::size_t a, std::size_t b) const {
    if (contacts_.empty())
        return nullptr;
    const auto found = contacts_.find(std::minmax(a, b));
    return found == contacts_.end() ? nullptr : &scene_.contacts[found->second];
}

PairLaw ContactPairs::lawOf(std::size_t a, std::size_t b) const {
    const Body &one = scene_.bodies[a], &other = scene_.bodies[b];
    const auto mean = [](double first, double second) { // of equal ones the same, bit for bit
        return first == second ? first : std::sqrt(first * second);
    };
    PairLaw law{.sticking = mean(one.staticFriction.value_or(one.friction),
                                 other.staticFriction.value_or(other.friction)),
                .sliding = mean(one.friction, other.friction),
                .rolling = std::max(one.rollingFriction, other.rollingFriction),
                .restitution = restitutionOf(a, b)};
    if (const Contact* own = find(a, b)) {
        if (own->friction)
            law.sticking = law.sliding = *own->friction;
        law.sticking = own->staticFriction.value_or(law.sticking);
        law.rolling = own->rollingFriction.value_or(law.rolling);
    }
    return law;
}

double ContactPairs::restitutionOf(std::size_t a, std::size_t b) const {
    if (const Contact* own = find(a, b); own && own->restitution)
        return *own->restitution;
    return std::min(scene_.bodies[a].restitution, scene_.bodies[b].restitution);
}

std::optional<bool> ContactPairs::collides(std::size_t a, std::size_t b) const {
    const Contact* own = find(a, b);
    return own ? own->collides : std::nullopt;
}

} // namespace scene
