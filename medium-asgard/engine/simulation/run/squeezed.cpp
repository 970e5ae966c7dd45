#include "run/squeezed.h"

#include "events/sentences.h"
#include "run/stops.h"

#include <algorithm>
#include <set>
#include <vector>

namespace simulation {
namespace {

using Contact = ContactLog::Contact;

// Those in force at a time: the last entry of a body counts.
std::vector<const Contact*> inForceAt(const ContactLog& log, std::size_t bodies, double time) {
    std::vector<char> isTold(bodies, 0);
    std::vector<const Contact*> found;
    for (auto entry = log.entries().rbegin(); entry != log.entries().rend(); ++entry) {
        if ((*entry)->time > time)
            continue;
        for (const Contact& contact : (*entry)->contacts)
            if (isTold[contact.body] == 0 && isTold[contact.support] == 0)
                found.push_back(&contact);
        for (const std::size_t body : (*entry)->moving)
            isTold[body] = 1;
    }
    return found;
}

// Joints that drive the body with whatever force that takes.
std::set<std::string> drivesOf(const scene::Scene& scene, std::size_t body) {
    std::set<std::string> names;
    for (const scene::Joint* joint : drivenOf(scene, {body}))
        if (std::ranges::any_of(joint->coordinates, [](const scene::JointCoordinate& c) {
                return (c.speed || c.position) && !c.maxMotor;
            }))
            names.insert(joint->name);
    return names;
}

} // namespace

std::optional<std::string> squeezedAt(const Problem& problem, const ContactLog& contacts,
                                      const std::vector<std::size_t>& bodies, double time) {
    const scene::Scene& scene = problem.scene;
    std::set<std::size_t> reached(bodies.begin(), bodies.end()), pressed, between;
    const auto all = inForceAt(contacts, scene.bodies.size(), time);
    for (const Contact* contact : all)
        if (std::ranges::find(bodies, contact->body) != bodies.end() ||
            std::ranges::find(bodies, contact->support) != bodies.end())
            reached.insert({contact->body, contact->support});
    std::set<std::string> drives;
    bool isAnyLed = false;
    for (std::vector<std::size_t> next(reached.begin(), reached.end()); !next.empty();) {
        const std::size_t body = next.back();
        next.pop_back();
        const bool isHeld = std::ranges::find(scene.constraints, scene.bodies[body].name,
                                              &scene::Constraint::body) != scene.constraints.end();
        std::set<std::string> own = drivesOf(scene, body);
        isAnyLed = isAnyLed || isHeld || !own.empty();
        if (scene.bodies[body].fixed || isHeld || !own.empty()) {
            between.insert(body);
            drives.merge(own);
            continue;
        }
        pressed.insert(body);
        for (const Contact* contact : all)
            if (contact->body == body || contact->support == body)
                for (const std::size_t other : {contact->body, contact->support})
                    if (reached.insert(other).second)
                        next.push_back(other);
    }
    if (!isAnyLed || between.size() < 2)
        return std::nullopt;
    return sentences::crushed(scene, pressed, between, drives);
}

} // namespace simulation
