// The colours that have a name in SVG 1.1 (section 4.4).
#pragma once

#include "scene/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace script {

[[nodiscard]] std::optional<scene::Color> namedColor(std::string_view name); // any case
[[nodiscard]] std::span<const std::string> colorNames();

} // namespace script
