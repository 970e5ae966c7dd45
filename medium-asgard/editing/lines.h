// The lines of a script that hold a command: where another one can be put, what goes when it goes.
#pragma once

#include "script/structure.h"

#include <string>
#include <string_view>

namespace editing {

// The end of the line on which `offset` lies, its line break included, where no command, comment
// or continued line (a backslash before the break) goes on; the text's end at the latest.
[[nodiscard]] std::size_t afterLine(std::string_view text, const script::Structure& structure,
                                    std::size_t offset);

// A backslash before the line break at that place, or the text's end there, goes on to the next.
[[nodiscard]] bool isContinued(std::string_view text, std::size_t lineBreak);

// The bytes that go with that command: its line or lines, with the comment behind it, when nothing
// else stands there; otherwise the command, with the semicolon behind it.
[[nodiscard]] scene::Range wholeOf(std::string_view text, const script::Structure& structure,
                                   const script::Command& command);

// The command of the text's outermost script that holds this one.
[[nodiscard]] const script::Command& outermost(const script::Structure& structure,
                                               const script::Command& command);

// Blanks before the command on its line; "" when something else stands there.
[[nodiscard]] std::string indentOf(std::string_view text, const script::Command& command);

// "\n", or "\r\n" where the text's lines end so.
[[nodiscard]] std::string lineBreakOf(std::string_view text);

} // namespace editing
