// The words that may follow a scene command, for completion and for tips.
#pragma once

#include <span>
#include <string_view>

namespace editing {

// The kind of an option's value.
enum class Wants {
    number,
    integer,
    flag, // 0 or 1
    text,
    color,
    vector, // three numbers
    list,   // of points, parts, expressions
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
    std::string_view choices; // blanks between them; for Wants::choice
};

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
[[nodiscard]] const OptionHint* hintOf(const CommandHint& command, std::string_view option);

} // namespace editing
