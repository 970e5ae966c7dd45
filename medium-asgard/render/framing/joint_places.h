// Where the ends of a joint are: for its picture and its handles.
//
// LIMIT: a joint counts as released when its ends have come apart; the expression of -release is
// not read, so one whose bodies happen to stay together is still shown.
#pragma once

#include "motion/motion.h"
#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace render {

using geometry::Vector;

// One end, on a body or in the world.
struct JointEnd {
    std::optional<std::size_t> body; // none: the world
    geometry::Pose pose;             // of the body's shape, now
    geometry::Pose start;            // as the scene begins
    Vector offset = Vector::Zero();  // in the body's frame
    Vector point = Vector::Zero();   // world, now

    // A direction of the world at the start, as the body has turned it since.
    [[nodiscard]] Vector carried(const Vector& direction) const {
        return pose.attitude * (start.attitude.conjugate() * direction);
    }
};

struct JointPlace {
    std::array<JointEnd, 2> ends;    // of body 1, of body 2 or the world
    Vector axis = Vector::UnitZ();   // world at the start, of length 1
    Vector apart = Vector::Zero();   // world at the start: the first point less the second
    Vector towards = Vector::Zero(); // world at the start: from the joint to body 1's centre

    // Across the axis, of length 1, world at the start: where body 1's centre is before it turns.
    [[nodiscard]] Vector unturned() const;
};

class JointPlaces {
public:
    // Keeps both.
    JointPlaces(const scene::Scene& scene, const simulation::Motion* motion);

    // None: a body is missing.
    [[nodiscard]] std::optional<JointPlace> at(const scene::Joint& joint, double time) const;

private:
    [[nodiscard]] std::optional<JointEnd> endOn(const std::string& body, double time) const;
    [[nodiscard]] Vector centerOf(std::size_t body) const;

    const scene::Scene& scene_;
    const simulation::Motion* motion_;
    std::unordered_map<std::string, std::size_t> bodies_;
};

// Across n, of length 1: the world's axis that is the farthest from n, less its part along n.
[[nodiscard]] Vector acrossOf(const Vector& n);

// How far the ends have come apart along what the joint keeps together, against the start.
[[nodiscard]] double gapOf(const scene::Joint& joint, const JointPlace& place);

// The points of joints that stand in the world, as the scene begins.
[[nodiscard]] std::vector<Vector> jointAnchorsOf(const scene::Scene& scene,
                                                 const simulation::Motion* motion);

} // namespace render
