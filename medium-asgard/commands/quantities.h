// The quantities of a scene that are worth a plot: of each element with a name, in words, and as
// the expressions that a `plot` has.
#pragma once

#include "editing/element.h"
#include "element_edits/creation.h"
#include "scene/scene.h"

#include <string>
#include <vector>

namespace commands {

struct Quantity {
    std::string label; // "&Angle": its key in a menu is behind the mark
    std::string expression;
    std::string unit = {};
    std::string name = {}; // of its curve, "angle of hinge1"; "": the expression tells it
};

// None of an element without a name, or of which nothing changes.
[[nodiscard]] std::vector<Quantity> quantitiesOf(const scene::Scene& scene,
                                                 const editing::Element& element);

struct Measured {
    editing::Element element;
    std::vector<Quantity> quantities; // not empty
};
// Its label and its unit, as a chart has them: "Angle about z, °".
[[nodiscard]] std::string worded(const Quantity& quantity);

// Of all bodies that can move, joints, springs, ropes and contacts, in this order.
[[nodiscard]] std::vector<Measured> quantitiesOf(const scene::Scene& scene);

// The plot of an expression, as a new element of the scene; `curve`: its label, "" without.
[[nodiscard]] editing::NewElement plotOf(const std::string& text, const scene::Scene& scene,
                                         const std::string& expression, const std::string& curve);

} // namespace commands
