#include "element_edits/units.h"

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
    if (element.kind == Kind::view || element.kind == Kind::parameter)
        return {};
    return found(generalUnits, option);
}

} // namespace editing
