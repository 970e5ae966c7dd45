#include "scene/joint_types.h"

#include <array>
#include <vector>

namespace scene {
namespace {

constexpr CoordinateKind angle[] = {CoordinateKind::angle};
constexpr CoordinateKind length[] = {CoordinateKind::length};
constexpr CoordinateKind angleLength[] = {CoordinateKind::angle, CoordinateKind::length};
constexpr CoordinateKind twoAngles[] = {CoordinateKind::angle, CoordinateKind::angle};
constexpr CoordinateKind inPlane[] = {CoordinateKind::length, CoordinateKind::length,
                                      CoordinateKind::angle};

// name, coordinates, axis, default axis, drives, 0 at the start, -from
constexpr std::array<JointTraits, 9> traits = {{
    {"fixed", {}, false, false, false, true, false},
    {"hinge", angle, true, true, true, true, true},
    {"slider", length, true, false, true, true, true},
    {"cylindrical", angleLength, true, false, true, true, true},
    {"universal", twoAngles, true, false, true, true, true},
    {"ball", angle, false, false, false, true, false},
    {"planar", inPlane, true, true, false, true, true},
    {"distance", length, false, false, true, false, false},
    {"screw", angle, true, false, true, true, true},
}};

} // namespace

const JointTraits& traitsOf(JointType type) { return traits[static_cast<std::size_t>(type)]; }

std::span<const std::string> jointTypeNames() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> made;
        made.reserve(traits.size());
        for (const JointTraits& type : traits)
            made.emplace_back(type.name);
        return made;
    }();
    return names;
}

bool isRigidDistance(const Joint& joint) {
    return joint.type == JointType::distance && !joint.coordinates[0].isGiven;
}

std::string coordinateSuffix(JointType type, std::size_t coordinate) {
    return traitsOf(type).coordinates.size() > 1 ? std::to_string(coordinate + 1) : "";
}

} // namespace scene
