// Values as words of Tcl.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace editing {

// The value as one word of a command: as it is where that is one word already ("2", "$h",
// "{1 2 3}", "[expr {2 * $h}]"), else in braces, or in quotes where it reads variables
// ("1 $h 0"). None: no word has that value, as its braces do not match.
[[nodiscard]] std::optional<std::string> wordFor(std::string_view value);

[[nodiscard]] inline std::string slice(const std::string& text, scene::Range range) {
    return text.substr(range.from, range.to - range.from);
}

// Without the blanks around it.
[[nodiscard]] inline std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \t\r\n");
    return from == std::string::npos
               ? ""
               : text.substr(from, text.find_last_not_of(" \t\r\n") + 1 - from);
}

} // namespace editing
