// An element's meaning as a text: two elements have the same fingerprint when they differ in
// nothing but their place.
#pragma once

#include "editing/value_edit.h"

namespace editing {

[[nodiscard]] std::string fingerprintOf(const scene::Scene& scene, const Element& element);
// The bodies that it is about, "" where it is about none.
[[nodiscard]] std::string bodiesOf(const scene::Scene& scene, const Element& element);

} // namespace editing
