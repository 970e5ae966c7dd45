// The handles of a picture: what each moves, and where it stands.
#pragma once

#include "geometry/pose.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace render {

using geometry::Vector;

enum class HandleKind : std::uint8_t {
    position,
    orientation, // on the body's x axis (part 0) or its y axis (1)
    velocity,
    spin, // angular velocity
    forceBase,
    forceHead,
    torqueBase,
    torqueHead,
    linkEnd, // part: 0 or 1
    jointAxis,
    jointPoint, // part: 0; 1: of a distance, its second
    // Of a hinge or a slider; part: 0 the lower, 1 the upper. In its frame q is 0 along x and the
    // axis is z.
    jointLimit,
    // How long a rope is. In its frame z is 0 where the rope is taut at the start, and the slack
    // beyond.
    ropeLength,
    lightPlace,
    lightDirection,
    // part: which of -points, or of -bezier's control points (editing/). Of a trajectory that only
    // a force or torque follows: the head of an arrow, as forces have them.
    trajectoryPoint,
};

// A handle in any set of its scene's.
struct HandleName {
    HandleKind kind = HandleKind::position;
    std::size_t element = 0, part = 0;
    bool operator==(const HandleName&) const = default;
};

struct Handle {
    HandleKind kind = HandleKind::position;
    std::size_t element = 0; // in the scene's list of what it belongs to
    std::size_t part = 0;
    Vector base = Vector::Zero();  // world: foot of the arrow; the same as `place` for mere places
    Vector place = Vector::Zero(); // world
    double perUnit = 1;            // length of the arrow for a value of 1
    // In which the text gives places and directions; of a trajectory's point its position is the
    // place of the value 0.
    geometry::Pose frame = {};
    bool movable = true;    // false: only shown
    std::string label = {}; // what stands beside it
    double clear = 0;       // world: how far its own body reaches about it, which does not hide it
    Eigen::Vector2d aside = Eigen::Vector2d::Zero(); // pixels: where it stands beside its place
    bool cut = false;                                // its arrow is shortened
    bool folded = false; // of a crowd that is not open: it is neither drawn nor taken
    [[nodiscard]] HandleName name() const { return {kind, element, part}; }
    [[nodiscard]] bool isArrow() const { return base != place; }
    // Of a trajectory's point: the head of an arrow, and no place of a path.
    [[nodiscard]] bool isValue() const { return perUnit != 1 || isArrow(); }
    // Of a trajectory's point: its value, and the place of one.
    [[nodiscard]] Vector valueAt(const Vector& world) const {
        return (world - frame.position) / perUnit;
    }
    [[nodiscard]] Vector placeOf(const Vector& value) const {
        return frame.position + perUnit * value;
    }
};

// A line that belongs to handles: a link, a trajectory.
struct HandleLine {
    HandleKind kind = HandleKind::linkEnd;
    std::size_t element = 0;
    std::vector<Vector> points;
};

// Handles that cover each other, some of which are folded unless the display opens it.
struct Crowd {
    HandleName largest;                               // by it one tells it from others
    Eigen::Vector2d middle = Eigen::Vector2d::Zero(); // pixels
    double reach = 0;                                 // pixels: of what is shown of it
    bool isOpen = false;
};

struct HandleSet {
    std::vector<Handle> handles;
    std::vector<HandleLine> lines;
    std::vector<Crowd> crowds = {};
};

} // namespace render
