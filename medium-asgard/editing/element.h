// An element of a scene, as gestures mean it.
#pragma once

#include "scene/scene.h"

#include <compare>
#include <cstddef>
#include <string>

namespace editing {

enum class Kind {
    simulator,
    shapeSet,
    body,
    force,
    link,
    joint,
    gear,
    rope,
    contact,
    trajectory,
    constraint,
    light,
    view,
    parameter,
    plot
};

// By its kind and its place in the scene's list of that kind.
struct Element {
    Kind kind = Kind::body;
    std::size_t index = 0;
    auto operator<=>(const Element&) const = default;
};

// Where it comes from; null: there is none.
[[nodiscard]] const scene::Source* sourceOf(const scene::Scene& scene, const Element& element);
[[nodiscard]] std::string nameOf(const scene::Scene& scene, const Element& element); // "": unnamed
[[nodiscard]] std::string wordOf(Kind kind);                                         // "body"
// The command that makes it: "lightsource"; "spring" for a link that is one.
[[nodiscard]] std::string commandOf(Kind kind);
[[nodiscard]] std::string commandOf(const scene::Scene& scene, const Element& element);
// "body \"b1\"", "the force of line 7".
[[nodiscard]] std::string describe(const scene::Scene& scene, const Element& element);

// The elements of that kind; of the simulator those that the text has: 0 or 1.
[[nodiscard]] std::size_t countOf(const scene::Scene& scene, Kind kind);

} // namespace editing
