// Closes the joints of a scene by the smallest movement of its free bodies.
//
// With the gaps g of joints, gears and ropes that are too short, as functions of the places of
// bodies, Newton's method with the least step,
//
//     dy = - W J' (J W J')^+ g,
//
// closes them; W counts a turn as an arc of the body's radius. Angles of joints and what drums have
// wound follow the bodies at no cost. From there the movement as a whole
// is made smaller along the directions that open no joint, as long as that shortens it. Bodies that
// are fixed, or that a trajectory holds at the start, stay. A joint whose -offset2 is not given
// stays as the text has it.
//
// LIMIT: a straight chain of rods that must become shorter has no first step, and stays open. A
// rope that is too short around a wheel stays so.
//
// Contract: docs/scene-language.md, "Joints".
#pragma once

#include "geometry/pose.h"
#include "scene/scene.h"

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace physics {

struct Assembly {
    struct Moved {
        std::size_t body = 0; // of the scene
        geometry::Pose pose;  // of its reference point, in the world
        double by = 0;        // m: the larger of the way of its centre and the arc of its turn
        bool turns = false;
    };
    std::vector<Moved> moved; // those that move at all
    std::string reason;       // why the joints do not close; "": they do
    bool cancelled = false;   // nothing was found out
};

// `cancelled` is asked before each step of Newton's method.
[[nodiscard]] Assembly assembled(const scene::Scene& scene,
                                 const std::function<bool()>& cancelled = nullptr);

// A fault's sentence tells of a joint that its bodies miss at the start.
inline constexpr const char* assembleAdvice =
    "place them so that the joint closes, or let the button Close It place them";
[[nodiscard]] inline bool asksToAssemble(std::string_view sentence) {
    return sentence.ends_with(assembleAdvice);
}

} // namespace physics
