// Closes the joints of a scene, and parts what overlaps, by the smallest movement of its free
// bodies.
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
// Then bodies part that overlap: with a gap  h < 0  along a normal for each pair of parts, with
// N = dh/dy and the movement m so far, the least movement m + dy that closes the joints and opens
// these gaps,
//
//     m + dy = J^+ (J m - g) + P N' f,   P = 1 - J^+ J,   h + N dy >= 0,  f >= 0,  f (h + N dy) =
//     0,
//
// again and again until it stays. A body that no joint holds is moved and not turned.
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
#include <optional>
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
    std::string reason;       // why joints do not close, or bodies do not part; "": they do
    bool cancelled = false;   // nothing was found out
};

// Two parts of bodies that must not overlap.
struct PartGap {
    std::size_t first = 0, second = 0;                   // bodies of the scene
    double gap = 0;                                      // negative: they overlap
    geometry::Vector normal = geometry::Vector::UnitX(); // unit, from the second towards the first
    geometry::Vector at = geometry::Vector::Zero();      // where they touch, in the world
    std::size_t firstPart = 0, secondPart = 0;           // of their shapes
};
// Of bodies whose centres of mass are at these poses, those that overlap, and all that it has told
// of before.
using PartGaps = std::function<std::vector<PartGap>(const std::vector<geometry::Pose>& poses)>;

// `cancelled` is asked before each step of Newton's method. Without `gaps` joints are closed alone.
[[nodiscard]] Assembly assembled(const scene::Scene& scene,
                                 const std::function<bool()>& cancelled = nullptr,
                                 const PartGaps& gaps = nullptr);

// A fault's sentence tells of a joint that its bodies miss at the start, or of bodies that overlap.
inline constexpr const char* closeButton = "the button Close It";
inline constexpr const char* partButton = "the button Move Apart";
[[nodiscard]] inline std::string closeAdvice() {
    return std::string("place them so that the joint closes, or let ") + closeButton +
           " place them";
}
[[nodiscard]] inline std::string partAdvice() {
    return std::string("place them apart, or let ") + partButton + " place them";
}
// 'line 4 makes "b0" and other bodies at once': that line is run for each of them, and a button
// that rewrote its numbers would move them all. None: each of these bodies that moves has its own
// line.
[[nodiscard]] std::optional<std::string> madeAtOnce(const scene::Scene& scene,
                                                    const std::vector<std::size_t>& bodies);
// For these bodies, all of which have to move: by the button where it can.
[[nodiscard]] std::string closeAdvice(const scene::Scene& scene,
                                      const std::vector<std::size_t>& bodies);
[[nodiscard]] std::string partAdvice(const scene::Scene& scene,
                                     const std::vector<std::size_t>& bodies);
[[nodiscard]] inline bool asksToClose(std::string_view sentence) {
    return sentence.find(closeAdvice()) != std::string_view::npos;
}
[[nodiscard]] inline bool asksToPart(std::string_view sentence) {
    return sentence.find(partButton) != std::string_view::npos;
}

} // namespace physics
