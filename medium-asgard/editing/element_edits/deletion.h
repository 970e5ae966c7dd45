// Elements taken out of a scene's text, with all that depends on them.
//
// A body takes the forces, links, joints and constraints that name it along, and every element
// whose expression reads it; a joint its gears and what reads it; a shape set its bodies; a
// trajectory and a parameter what uses them. Lines that go as a whole group take the empty line
// before it along. An element that a loop, a procedure called twice or a computed command makes
// cannot be taken out alone: then nothing is, and the reason names the command and its place.
#pragma once

#include "editing/element.h"
#include "text/edit.h"

#include <string>
#include <vector>

namespace editing {

struct Deletion {
    text::Edits edits;
    std::vector<Element> along; // what goes too, in the order in which it was found
    std::string reason;         // why nothing can go: one sentence
    scene::Range cause;
    [[nodiscard]] bool possible() const { return reason.empty(); }
};

[[nodiscard]] Deletion deletionOf(const std::string& text, const scene::Scene& scene,
                                  const std::vector<Element>& elements);

// The elements that name this one directly.
[[nodiscard]] std::vector<Element> dependents(const scene::Scene& scene, const Element& element);

} // namespace editing
