// An explanation as people read it and as programs do.
#pragma once

#include "reports/explanation.h"

#include <optional>
#include <string>

namespace batch {

// Long equations and lists are cut, which says how to see them whole; or nothing is.
enum class Detail { usual, all };

// The forces and contacts of each body; a paragraph for each kind of component: those with the same
// model, method, reason and kinds of unknowns, with each of their laws; then what is not modelled,
// then the pairs.
[[nodiscard]] std::string explanationText(const simulation::Explanation& explanation,
                                          Detail detail = Detail::usual);
// The phases that were asked for of something with this name, a section for each component.
[[nodiscard]] std::string phasesText(const simulation::Explanation& explanation,
                                     const std::string& name);
// The accuracy that was asked, and the estimate of the motion's error; none: not estimated.
[[nodiscard]] std::string accuracyText(const simulation::Explanation& explanation, double accuracy,
                                       std::optional<double> estimate);
[[nodiscard]] std::string explanationJson(const simulation::Explanation& explanation);

} // namespace batch
