// What each type of joint leaves free, and what may be said of it.
//
// The signs of the coordinates, the axes that count for each type and the values at the start are
// in docs/scene-language.md, "Joints".
#pragma once

#include "scene/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace scene {

enum class CoordinateKind { angle, length };

struct JointTraits {
    std::string_view name;
    std::span<const CoordinateKind> coordinates; // q, or q1 q2 ...
    bool hasAxis = false;                        // -axis and -axis2
    bool isDefaultAxis = false;                  // -axis may be left out: {0 0 1}
    bool hasDrives = false;    // -limits, -motor, -stiffness and the like, for each coordinate
    bool startsAtZero = false; // its coordinates are 0 at the start, unless -from says otherwise
    bool hasFrom = false;      // -from, for each coordinate
};

[[nodiscard]] const JointTraits& traitsOf(JointType type);
// In the order of JointType.
[[nodiscard]] std::span<const std::string> jointTypeNames();

// A massless rod: its one coordinate never changes, since none of its options was written.
[[nodiscard]] bool isRigidDistance(const Joint& joint);

// "" for the one coordinate of a joint, "1", "2", ... for one of several.
[[nodiscard]] std::string coordinateSuffix(JointType type, std::size_t coordinate);

} // namespace scene
