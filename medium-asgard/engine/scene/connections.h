// Which elements does a body's motion follow from, as far as the text tells?
//
// An expression counts as reading whatever its words name, also where algebra would remove it: who
// relies on this does too much now and then, never too little. Collisions are not looked at.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace scene {

inline constexpr std::size_t noElement = std::numeric_limits<std::size_t>::max();

// Something that a force, link, joint or constraint of a body names.
struct Mention {
    enum class Kind : std::uint8_t { body, trajectory, parameter, joint, spring, rope, contact };
    std::size_t reader = 0; // the body
    Kind kind = Kind::body;
    std::size_t index = 0; // into the scene's list of that kind; of springs: links
};

// Indices into lists of a scene, by body.
class ByBody {
public:
    ByBody() = default;
    // owners: the body of each element; noElement: none.
    ByBody(std::size_t bodies, std::span<const std::size_t> owners);
    // Elements that are on several bodies: (body, element), the elements in order.
    ByBody(std::size_t bodies,
           std::span<const std::pair<std::size_t, std::size_t>> ownersAndElements);
    [[nodiscard]] std::span<const std::size_t> of(std::size_t body) const {
        return std::span(elements_).subspan(starts_[body], starts_[body + 1] - starts_[body]);
    }

private:
    std::vector<std::size_t> starts_, elements_;
};

struct Connections {
    explicit Connections(const Scene& scene);

    std::vector<std::size_t> shapes; // by body: index into Scene::shapeSets
    ByBody forces, constraints;      // on a body, in the scene's order
    ByBody firstEnds, secondEnds;    // links whose first or second end is on a body
    ByBody joints, gears, ropes;     // that are on a body; a gear is on the bodies of its joints
    ByBody contacts;                 // of a body that moves
    ByBody mentions;                 // indices into mentionList, by reader
    std::vector<Mention> mentionList;
    // Moving bodies whose equations read each other, directly or through others: the least of them.
    // A fixed body is by itself, whoever reads it.
    std::vector<std::size_t> group;
    // Some element is on a body, or says a shape or a trajectory, that there is not.
    bool isBroken = false;
};

// Indices of elements that a -release has ended.
struct Released {
    std::set<std::size_t> joints, links;
    std::set<std::size_t> forces = {}, gears = {}, ropes = {};
};

// The bodies that never collide with each other, by body, since a link, a joint or a gear joins
// them directly, or fixed joints alone join them. Both ways; in no order.
[[nodiscard]] std::vector<std::vector<std::size_t>> joinedBodies(const Scene& scene,
                                                                 const Released& released = {});

} // namespace scene
