// A scene's text with marks before its commands, so that evaluation knows where it is.
//
// Two forms of the mark M, a command whose name no text can hold by accident:
//     M 120;set x 1            notes that the command at byte 120 runs (Tcl's own commands, which
//                              stay compiled)
//     M 120 body b1 rod ...    notes it and runs it (scene commands, procedures, computed names):
//                              after the words' own substitutions, so that the place is still right
// Tcl's own commands in brackets get none: the command around them is place enough while they run,
// and Tcl's trace tells them apart when they fail. No line is added or removed. Marks never show:
// withoutMarks() takes them out of what Tcl reports.
#pragma once

#include "script/structure.h"

#include <string>
#include <string_view>

namespace script {

// A character of Unicode's private area that the text does not have.
[[nodiscard]] std::string markFor(std::string_view text);

[[nodiscard]] std::string instrumented(std::string_view text, const Structure& structure,
                                       std::string_view mark);

[[nodiscard]] std::string withoutMarks(std::string_view text, std::string_view mark);

// The text with "\<carriage return><newline>" made "\<newline><blank>": Tcl continues lines only at
// a bare newline. Nothing else moves.
[[nodiscard]] std::string withPlainContinuations(std::string_view text);

} // namespace script
