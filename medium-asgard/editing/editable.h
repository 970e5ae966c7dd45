// Which stretches of a text can gestures in pictures change, and what are they?
#pragma once

#include "editing/value_edit.h"

namespace editing {

struct Editable {
    Element element;
    std::string option; // "-init_pos"
    scene::Range range; // the whole word when it is the value, else one number that it comes from
    bool operator==(const Editable&) const = default;
};

// In the order of the elements. What a loop or a procedure makes is none, nor is an expression.
[[nodiscard]] std::vector<Editable> editablesOf(const std::string& text,
                                                const std::shared_ptr<const scene::Scene>& scene);

} // namespace editing
