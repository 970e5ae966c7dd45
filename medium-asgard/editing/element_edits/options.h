// The words that may follow a scene command, for completion and for tips.
#pragma once

#include "editing/element.h"

#include <span>
#include <string>
#include <string_view>

namespace editing {

// The kind of an option's value.
enum class Wants {
    number,
    integer,
    flag, // 0 or 1
    text,
    color,
    vector,      // three numbers
    list,        // of numbers, points, parts, texts
    expressions, // a list of them, or of names and places
    expression,
    shapeSet, // a name
    body,
    trajectory,
    joint,
    choice // of words
};

struct OptionHint {
    std::string_view name;
    Wants wants;
    std::string_view words;   // "three numbers: where it starts"
    std::string_view choices; // blanks between them; of a flag: what it is by default, if known
    std::string_view caption = {}; // in a form; "": its name says it
};
// "Velocity", "Static friction".
[[nodiscard]] std::string captionOf(const OptionHint& option);

struct CommandHint {
    std::string_view name;
    std::string_view usage; // "body NAME SHAPE ?options?"
    std::string_view words; // one sentence
    Wants second;           // what the first word after the name is, of those that are names
    bool named;             // a new name follows the command
    std::span<const OptionHint> options;
};

// In the order of the manual; `instance` is `body`.
[[nodiscard]] std::span<const CommandHint> commandHints();
[[nodiscard]] const CommandHint* hintOf(std::string_view command); // or null
[[nodiscard]] const CommandHint& hintOf(const scene::Scene& scene, const Element& element);
[[nodiscard]] const OptionHint* hintOf(const CommandHint& command, std::string_view option);

} // namespace editing
