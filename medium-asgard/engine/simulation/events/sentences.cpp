#include "events/sentences.h"

#include <cctype>
#include <cstdio>

namespace simulation::sentences {

std::string quoted(const Colliders& world, std::size_t body) {
    return "\"" + world.name(body) + "\"";
}

std::string bodies(const Colliders& world, const Pair& pair) {
    return "bodies " + quoted(world, pair.first) + " and " + quoted(world, pair.second);
}

std::string capital(std::string sentence) {
    sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
    return sentence;
}

std::string leaning(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) +
           " come to rest on each other, which is modelled only where one of them is fixed or held";
}

std::string lost(const Colliders& world, const Pair& pair, bool bothGiveWay) {
    return bodies(world, pair) +
           (bothGiveWay ? " go on touching while they turn, which is modelled only where one of "
                          "them is fixed or held and the other is pushed onto it"
                        : " go on touching while they turn, and no force presses them together; "
                          "the time of their next impact cannot be told. Leave a little room "
                          "between them, or add a force that presses them together");
}

std::string withoutEnd(const Colliders& world, const Pair& pair, bool isBetweenSeveral) {
    return bodies(world, pair) + " meet again and again in ever shorter time; " +
           (isBetweenSeveral ? "leave more room between them"
                             : "they meet no other body in between, and their motion in contact is "
                               "not modelled");
}

std::string onlyEdges(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) +
           " rest on each other with an ellipsoid, the side of a cone, edges or "
           "rims along each other, or vertices, which is not modelled";
}

std::string onRim(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) + " come to rest on each other with an edge or a side across the "
                                 "rim of a hollow, which is not modelled";
}

std::string throughWall(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) + " lie on each other where one is hollow, and another edge, side "
                                 "or vertex meets its wall or its rim, which is not modelled";
}

std::string wideBall(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) + " meet along a circle: a ball that is as wide as a hollow, or "
                                 "wider, is not modelled on the rim of the hollow";
}

std::string closedMouth(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) + " meet at the mouth of a hollow: only balls, capsules, boxes and "
                                 "polyhedra go into a hollow";
}

std::string meetsEnded(const Colliders& world, std::size_t body, std::size_t ended, double time) {
    char when[40];
    std::snprintf(when, sizeof when, "%.6g", time);
    return "body " + quoted(world, body) + " meets " + quoted(world, ended) +
           ", whose motion stopped at t = " + when + "; what happens then is not known";
}

std::string missed(const Colliders& world, const Pair& pair) {
    return bodies(world, pair) + " overlap after they have met, since the search missed an impact; "
                                 "another accuracy may find it";
}

std::string restless(const Colliders& world, std::size_t body) {
    return "body " + quoted(world, body) +
           " lifts off its support and comes back again and again within next to no time: no "
           "position is found in which it rests there; turn or move it a little, or hold it there "
           "(constrain, link)";
}

std::string passThrough(const Colliders& world, const Pair& pair) {
    return capital(bodies(world, pair)) +
           " are both held where they meet, so they pass through each other.";
}

std::string overlap(const Colliders& world, const Pair& pair) {
    return capital(bodies(world, pair)) +
           " overlap without having met; they can collide once they are apart.";
}

std::string noRoom(const Colliders& world, std::size_t body, const std::set<std::size_t>& between) {
    std::string others;
    for (const std::size_t other : between)
        others += (others.empty() ? "" : " and ") + quoted(world, other);
    return "Body " + quoted(world, body) + " has no room between " + others +
           ": it would bounce between them without end at one instant, and loses its speed there.";
}

std::string unsolved(const Colliders& world, const Pair& pair) {
    return "the impulses of the blow between " + quoted(world, pair.first) + " and " +
           quoted(world, pair.second) + " were not found";
}

std::string crushed(const scene::Scene& scene, const std::set<std::size_t>& pressed,
                    const std::set<std::size_t>& between, const std::set<std::string>& drives) {
    const auto all = [&](const std::set<std::size_t>& of) {
        std::string text;
        for (const std::size_t body : of)
            text += (text.empty() ? "\"" : " and \"") + scene.bodies[body].name + "\"";
        return text;
    };
    std::set<std::size_t> told = pressed, firm = between;
    if (pressed.empty()) {
        firm.clear();
        for (const std::size_t body : between)
            (scene.bodies[body].fixed ? firm : told).insert(body);
    }
    const bool areMany = told.size() > 1;
    const std::size_t others = firm.empty() ? told.size() : firm.size();
    const std::string none = others == 1   ? "which does not give way"
                             : others == 2 ? "neither of which gives way"
                                           : "none of which gives way";
    std::string text = (areMany ? "bodies " : "body ") + all(told) + (areMany ? " are" : " is") +
                       " pressed " +
                       (firm.empty()       ? "together"
                        : firm.size() == 1 ? "against " + all(firm)
                                           : "between " + all(firm)) +
                       ", " + none;
    if (!pressed.empty())
        text += std::string(": ") + (areMany ? "they" : "it") + " would be crushed";
    if (drives.empty())
        return text;
    std::string joints;
    for (const std::string& joint : drives)
        joints += (joints.empty() ? "\"" : " and \"") + joint + "\"";
    const bool isOne = drives.size() == 1;
    return text + (pressed.empty() ? ": " : "; ") + (isOne ? "joint " : "joints ") + joints +
           (isOne
                ? " drives on with whatever force it takes: let it stop before, or give it "
                : " drive on with whatever force they take: let them stop before, or give them ") +
           "-max_motor";
}

std::string noHinge(const Colliders& world, std::size_t body) {
    return "Body " + quoted(world, body) +
           " is held at a place beside its centre of mass, which makes no hinge: what hits it or "
           "rests on it does not turn it. A joint of type hinge turns.";
}

} // namespace simulation::sentences
