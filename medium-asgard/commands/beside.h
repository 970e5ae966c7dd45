// The values that stand beside what they are of in every picture of a scene: those of its plots
// with `-beside 1`.
#pragma once

#include "commands/quantities.h"
#include "editing/value_edit.h"

#include <memory>
#include <string>

namespace commands {

[[nodiscard]] bool isBeside(const scene::Scene& scene, const Quantity& quantity);

// It stands there from now on: a new plot has it, or one that has it alone gets the option. Or it
// does not any more: a plot as this one makes it goes, others lose the option.
[[nodiscard]] editing::Answer withBeside(const std::string& text,
                                         const std::shared_ptr<const scene::Scene>& scene,
                                         const Quantity& quantity);
// The step of undo: "Show Speed Beside It".
[[nodiscard]] std::string labelOfBeside(const scene::Scene& scene, const Quantity& quantity);

} // namespace commands
