#include "resimulation/kept_motion.h"

#include "collision/broad_phase.h"
#include "motion/groups.h"

#include <algorithm>
#include <map>

namespace simulation {
namespace {

constexpr double touching = 1e-5; // of a body's radius: nearer than that it may touch

geometry::Box grown(geometry::Box box, double room) {
    const Vector all = Vector::Constant(room);
    box.extend(Vector(box.min() - all));
    box.extend(Vector(box.max() + all));
    return box;
}

// By body of the part: the least one of its unit. Fixed bodies stand alone.
std::vector<std::size_t> rootsOf(const SolvedPart& part, const Solved& solved,
                                 const std::vector<std::size_t>& bodies,
                                 const std::vector<std::size_t>& group) {
    const auto& records = *part.motion.bodies;
    Groups groups(records.size());
    std::map<std::size_t, std::size_t> first; // place by group
    std::optional<std::size_t> noted;
    for (std::size_t p = 0; p < records.size(); ++p) {
        if (records[p].isFixed)
            continue;
        if (bodies[p] != scene::noElement)
            groups.join(p, first.try_emplace(group[bodies[p]], p).first->second);
        // LIMIT: a note does not say whose it is, so that bodies of one stay together.
        if (!solved.run.notes.empty())
            groups.join(p, noted ? *noted : *(noted = p));
    }
    for (const auto& [a, b] : solved.near)
        if (!records[a].isFixed && !records[b].isFixed)
            groups.join(a, b);
    return groups.roots();
}

void addMembers(std::vector<Unit>& units, const std::vector<std::size_t>& unitOf,
                const SolvedPart& part, const Solved& solved,
                const std::vector<std::size_t>& bodies) {
    const auto& records = *part.motion.bodies;
    std::vector<std::vector<std::size_t>> members(units.size());
    for (std::size_t p = 0; p < records.size(); ++p)
        if (!records[p].isFixed)
            members[unitOf[p]].push_back(p);
    for (const auto& [a, b] : solved.near)
        if (records[a].isFixed != records[b].isFixed)
            members[unitOf[records[a].isFixed ? b : a]].push_back(records[a].isFixed ? a : b);
    for (std::size_t u = 0; u < units.size(); ++u) {
        std::ranges::sort(members[u]);
        members[u].erase(std::unique(members[u].begin(), members[u].end()), members[u].end());
        for (const std::size_t p : members[u]) {
            units[u].places.push_back(p);
            units[u].bodies.push_back(bodies[p]);
            units[u].isFixed.push_back(records[p].isFixed);
        }
    }
}

void addErrors(std::vector<Unit>& units, const std::vector<std::size_t>& unitOf,
               const SolvedPart& part, const Solved& solved) {
    for (std::size_t p = 0; solved.isEstimated && p < solved.errors.size(); ++p) {
        if ((*part.motion.bodies)[p].isFixed)
            continue;
        std::optional<BodyError>& error = units[unitOf[p]].error;
        if (!error)
            error.emplace();
        *error = worse(*error, solved.errors[p]);
    }
}

void addComponents(std::vector<Unit>& units, const std::vector<std::size_t>& unitOf,
                   const SolvedPart& part, const Solved& solved) {
    for (const solution::ComponentStatistics& c : solved.run.statistics.componentList) {
        Unit& unit = units[unitOf[part.owners[c.unknowns[0]]]];
        ++unit.components;
        unit.largestComponent = std::max(unit.largestComponent, c.unknowns.size());
    }
}

} // namespace

SolvedPart::SolvedPart(const Problem& problem, const Solved& solved)
    : motion(partOf(problem, solved.run)), owners(problem.equations.owners),
      keptBytes(solved.keptBytes), isFull(solved.isFull) {
    const auto& records = *motion.bodies;
    bodies.reserve(records.size());
    for (std::size_t p = 0; p < records.size(); ++p) {
        bodies.emplace_back(records[p], problem.shapes[p]);
        until.push_back(problem.finish());
        if (const auto stop = solved.run.stops.find(p); stop != solved.run.stops.end())
            until.back() = std::min(until.back(), stop->second.time);
        if (motion.histories)
            bodies.back().read(*motion.histories);
        reach.push_back(grown(collision::boundsDuring(bodies.back(), problem.start(), until.back()),
                              touching * records[p].radius));
    }
}

std::size_t Unit::bodyAt(std::size_t place) const {
    return bodies[static_cast<std::size_t>(std::ranges::lower_bound(places, place) -
                                           places.begin())];
}

std::vector<UnitPointer> unitsOf(const PartPointer& part, const Solved& solved,
                                 const std::vector<std::size_t>& bodies,
                                 const std::vector<std::size_t>& group) {
    const auto& records = *part->motion.bodies;
    const std::vector<std::size_t> roots = rootsOf(*part, solved, bodies, group);
    std::vector<Unit> units;
    std::vector<std::size_t> unitOf(records.size(), scene::noElement);
    for (std::size_t p = 0; p < records.size(); ++p) {
        if (records[p].isFixed)
            continue;
        if (roots[p] == p) {
            unitOf[p] = units.size();
            units.emplace_back().part = part;
        }
        unitOf[p] = unitOf[roots[p]];
    }
    addMembers(units, unitOf, *part, solved, bodies);
    addErrors(units, unitOf, *part, solved);
    addComponents(units, unitOf, *part, solved);
    for (const Impact& impact : solved.run.impacts)
        units[unitOf[records[impact.first].isFixed ? impact.second : impact.first]]
            .impacts.push_back(impact);
    for (const auto& [place, stop] : solved.run.stops)
        units[unitOf[place]].stops.emplace_back(place, stop);
    if (!units.empty())
        units[0].notes = solved.run.notes;
    std::vector<UnitPointer> made;
    made.reserve(units.size());
    for (Unit& unit : units)
        made.push_back(std::make_shared<const Unit>(std::move(unit)));
    return made;
}

void KnownMotion::index() {
    unitOf.assign(version->scene->bodies.size(), scene::noElement);
    for (std::size_t u = 0; u < units.size(); ++u)
        for (std::size_t i = 0; i < units[u]->bodies.size(); ++i)
            if (!units[u]->isFixed[i])
                unitOf[units[u]->bodies[i]] = u;
}

// Runs from scratch are ahead of the time that all is known to by a little.
bool KnownMotion::mayBeFull(std::size_t most) const {
    std::size_t sum = 0;
    for (const PlacedPart& placed : parts) {
        if (placed.part->isFull)
            return true;
        sum += placed.part->keptBytes;
    }
    return sum > most - most / 10;
}

namespace {

struct Mover { // one that stands where it is then
    const MovingBody& body;
    double until = 0;

    [[nodiscard]] geometry::Box bounds(double from, double to) const {
        return collision::boundsDuring(body, std::min(from, until), std::min(to, until));
    }
};

// Boxes that still overlap over the shortest times: the bodies touch, or only just do not.
bool boxesMeet(const Mover& a, const Mover& b, double from, double to, double room, int halvings) {
    if (!grown(a.bounds(from, to), room).intersects(b.bounds(from, to)))
        return false;
    const double middle = from + (to - from) / 2;
    if (halvings == 0 || !(from < middle && middle < to))
        return true;
    return boxesMeet(a, b, from, middle, room, halvings - 1) ||
           boxesMeet(a, b, middle, to, room, halvings - 1);
}

} // namespace

bool mayMeet(const scene::Scene& scene, std::size_t a, std::size_t b) {
    const scene::Contact* said =
        scene::findContact(scene, scene.bodies[a].name, scene.bodies[b].name);
    if (said && said->collides)
        return *said->collides;
    const auto& one = scene.bodies[a].collisionGroup;
    const auto& other = scene.bodies[b].collisionGroup;
    return !(one && other && *one == *other);
}

// Those that touch without pressing count too: they take part in each other's impacts.
bool meet(const SolvedPart& one, std::size_t first, const SolvedPart& other, std::size_t second) {
    constexpr int halvings = 16;
    if (!one.reach[first].intersects(other.reach[second]))
        return false;
    const double start =
        one.motion.histories ? one.motion.histories->start() : other.motion.histories->start();
    const double until = std::max(one.until[first], other.until[second]);
    const double room =
        touching * ((*one.motion.bodies)[first].radius + (*other.motion.bodies)[second].radius);
    return boxesMeet({one.bodies[first], one.until[first]},
                     {other.bodies[second], other.until[second]}, start, until, room, halvings);
}

} // namespace simulation
