#include "element_edits/units.h"

#include "scene/joint_types.h"

#include <algorithm>
#include <array>
#include <utility>

namespace editing {

namespace {

using Unit = std::pair<std::string_view, std::string_view>; // of an option

constexpr std::array generalUnits{Unit{"-start", "s"},
                                  Unit{"-finish", "s"},
                                  Unit{"-step", "s"},
                                  Unit{"-from", "s"},
                                  Unit{"-to", "s"},
                                  Unit{"-init_pos", "m"},
                                  Unit{"-init_rot", "rad"},
                                  Unit{"-init_dpos", "m/s"},
                                  Unit{"-init_drot", "rad/s"},
                                  Unit{"-mass", "kg"},
                                  Unit{"-inertia", "kg m²"},
                                  Unit{"-center", "m"},
                                  Unit{"-density", "kg/m³"},
                                  Unit{"-rolling_friction", "m"},
                                  Unit{"-surface_velocity", "m/s"},
                                  Unit{"-offset", "m"},
                                  Unit{"-offset1", "m"},
                                  Unit{"-offset2", "m"},
                                  Unit{"-gravitational", "m/s²"},
                                  Unit{"-tightness", "N/m"},
                                  Unit{"-length", "m"},
                                  Unit{"-pitch", "m"}};

constexpr std::array springUnits{Unit{"-stiffness", "N/m"}, Unit{"-damping", "N s/m"},
                                 Unit{"-rest", "m"},        Unit{"-x", "m"},
                                 Unit{"-y", "m"},           Unit{"-z", "m"}};

// Of a joint's coordinate, where it is a length and where it is an angle.
struct CoordinateUnit {
    std::string_view option, length, angle;
};
constexpr std::array coordinateUnits{
    CoordinateUnit{"-limits", "m", "rad"},    CoordinateUnit{"-motor", "N", "N m"},
    CoordinateUnit{"-speed", "m/s", "rad/s"}, CoordinateUnit{"-position", "m", "rad"},
    CoordinateUnit{"-max_motor", "N", "N m"}, CoordinateUnit{"-stiffness", "N/m", "N m/rad"},
    CoordinateUnit{"-rest", "m", "rad"},      CoordinateUnit{"-damping", "N s/m", "N m s/rad"},
    CoordinateUnit{"-friction", "N", "N m"},  CoordinateUnit{"-from", "m", "rad"}};

std::string_view ofCoordinate(scene::JointType type, std::string_view option) {
    const auto kinds = scene::traitsOf(type).coordinates;
    for (std::size_t k = 0; k < kinds.size(); ++k)
        for (const CoordinateUnit& unit : coordinateUnits)
            if (option == std::string(unit.option) + scene::coordinateSuffix(type, k))
                return kinds[k] == scene::CoordinateKind::angle ? unit.angle : unit.length;
    return {};
}

template <std::size_t count>
std::string_view found(const std::array<Unit, count>& units, std::string_view option) {
    const auto* unit = std::ranges::find(units, option, &Unit::first);
    return unit == units.end() ? std::string_view() : unit->second;
}

} // namespace

std::string_view unitOf(const scene::Scene& scene, const Element& element,
                        std::string_view option) {
    const bool isComponent = option == "-x" || option == "-y" || option == "-z";
    if (element.kind == Kind::force && isComponent)
        return scene.forces[element.index].couple ? "N m" : "N";
    if (element.kind == Kind::link)
        if (const std::string_view unit = found(springUnits, option); !unit.empty())
            return unit;
    if (element.kind == Kind::joint)
        if (const auto unit = ofCoordinate(scene.joints[element.index].type, option); !unit.empty())
            return unit;
    if (element.kind == Kind::view || element.kind == Kind::parameter)
        return {};
    return found(generalUnits, option);
}

} // namespace editing
