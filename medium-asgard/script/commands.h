// The commands of a scene's script, and the reasons why it has no others.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace script {

// body, force, ...: what makes elements. The list is in the order of the manual.
[[nodiscard]] std::span<const std::string_view> sceneCommands();
[[nodiscard]] bool isSceneCommand(std::string_view name);

// set, foreach, expr, ...: what of Tcl a script has.
[[nodiscard]] std::span<const std::string_view> tclCommands();
[[nodiscard]] bool isTclCommand(std::string_view name);

// Commands of Tcl that authors may expect, and why scenes do not have them.
struct Refusal {
    std::string_view command;
    std::string_view reason; // "a scene cannot read or write files"
};
[[nodiscard]] std::span<const Refusal> refusals();

} // namespace script
