#include "resimulation/edit.h"

#include <algorithm>

namespace simulation {

using scene::noElement;

Edit::Edit(const KnownMotion& known, const scene::Version& now)
    : known_(known), now_(now), scene_(*now.scene),
      difference_(scene::differenceBetween(*known.version, now)),
      members_(scene_.bodies.size(), now.connections.group), again_(scene_.bodies.size()),
      isDropped_(known.units.size()) {
    for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
        if (!difference_.changed[b])
            continue;
        if (scene_.bodies[b].fixed)
            addFixed(b);
        else
            mark(b);
    }
    dropUnits();
}

bool Edit::isChangedFixed(std::size_t body) const {
    return std::ranges::binary_search(changedFixed_, body);
}

std::vector<std::size_t> Edit::chosen() const {
    std::vector<std::size_t> bodies;
    for (std::size_t b = 0; b < again_.size(); ++b)
        if (again_[b] || scene_.bodies[b].fixed)
            bodies.push_back(b);
    return bodies;
}

void Edit::addFixed(std::size_t body) {
    changedFixed_.push_back(body);
    // What acts on it moves nothing, but may be wrong.
    const scene::Connections& c = now_.connections;
    possible_ = possible_ && c.forces.of(body).empty() && c.constraints.of(body).empty();
}

void Edit::mark(std::size_t body) {
    std::vector<std::size_t> open{body};
    while (!open.empty()) {
        const std::size_t b = open.back();
        open.pop_back();
        if (scene_.bodies[b].fixed || again_[b])
            continue;
        again_[b] = marked_ = true;
        const auto group = members_.of(now_.connections.group[b]);
        open.insert(open.end(), group.begin(), group.end());
        if (const std::size_t was = difference_.before[b]; was != noElement)
            if (const std::size_t unit = known_.unitOf[was]; unit != noElement)
                drop(unit, open);
    }
}

void Edit::drop(std::size_t unit, std::vector<std::size_t>& open) {
    if (isDropped_[unit])
        return;
    isDropped_[unit] = true;
    for (const std::size_t was : known_.units[unit]->bodies)
        if (const std::size_t b = difference_.after[was]; b != noElement)
            open.push_back(b);
}

// Units that something is gone of, or that are told differently now.
void Edit::dropUnits() {
    for (std::size_t u = 0; u < known_.units.size(); ++u) {
        if (isDropped_[u] || !hasChanged(*known_.units[u]))
            continue;
        std::vector<std::size_t> open;
        drop(u, open);
        for (const std::size_t b : open)
            mark(b);
    }
}

bool Edit::hasChanged(const Unit& unit) const {
    std::size_t last = 0;
    for (std::size_t i = 0; i < unit.bodies.size(); ++i) {
        const std::size_t b = difference_.after[unit.bodies[i]];
        if (b == noElement || difference_.changed[b] || (i > 0 && b < last))
            return true;
        if (!unit.stops.empty() && difference_.moved[b]) // its sentence names lines
            return true;
        last = b;
    }
    return false;
}

bool Edit::markWhoComesNear(const SolvedPart& part, const std::vector<std::size_t>& bodies) {
    std::vector<std::size_t> near;
    for (std::size_t p = 0; p < bodies.size(); ++p) {
        if (scene_.bodies[bodies[p]].fixed && !isChangedFixed(bodies[p]))
            continue;
        for (std::size_t was = 0; was < known_.homes.size(); ++was) {
            const std::size_t unit = known_.unitOf[was];
            if (unit == noElement || !isKept(unit))
                continue;
            const Home& home = known_.homes[was];
            const std::size_t other = difference_.after[was];
            if (mayMeet(scene_, bodies[p], other) && meet(part, p, *home.part, home.place))
                near.push_back(other);
        }
    }
    for (const std::size_t body : near)
        mark(body);
    return !near.empty();
}

} // namespace simulation
