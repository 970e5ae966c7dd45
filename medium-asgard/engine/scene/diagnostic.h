// A fault of a scene's text, in the author's words and at its place.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace scene {

enum class Severity { error, warning };

struct Diagnostic {
    Severity severity = Severity::error;
    Range range;     // what to underline; may be empty
    int line = 0;    // from 1; 0: no place is known
    int column = 0;  // from 1, in characters
    int endLine = 0; // end of the range, exclusive
    int endColumn = 0;
    std::string message;             // one sentence, the caret and suggestion not included
    std::string suggestion;          // "did you mean ...", or ""
    std::optional<double> time = {}; // of a motion's fault: when it comes
    bool operator==(const Diagnostic&) const = default;
};

// Ordered by place; those without one come last.
void sortByPlace(std::vector<Diagnostic>& diagnostics);

// "file:line:column: error: message", then the line, then the caret line with the suggestion:
//     swing.al:7:17: error: body "bob": no shape set named "spere"
//         body bob -shape spere -init_pos {1 0 0}
//                         ^~~~~ did you mean "sphere"? (shape sets here: rod, sphere)
[[nodiscard]] std::string formatted(const Diagnostic& diagnostic, const std::string& file,
                                    const std::string& text);

} // namespace scene
