// The signs that have a name, what they are, and how they are said.
#pragma once

#include "formulas/formula.h"

#include <optional>

namespace formulas {

struct Symbol {
    std::string_view name{}; // without the backslash
    char32_t code = 0;
    Atom atom = Atom::ordinary;
    std::string_view spoken{}; // empty: its name
    Limits limits = Limits::never;
};

// A function's name, set in upright letters: sin, lim.
struct Function {
    std::string_view name{};
    std::string_view shown{};
    std::string_view spoken{};
    bool limits = false;
};

[[nodiscard]] const Symbol* symbolNamed(std::string_view name);
[[nodiscard]] const Symbol* symbolOf(char32_t code); // the first one with that code
[[nodiscard]] const Function* functionNamed(std::string_view name);
// The sign that a diacritical command puts over its base; 0 for no such command.
[[nodiscard]] char32_t accentNamed(std::string_view name);
[[nodiscard]] std::string_view spokenAccent(char32_t code);
// Of "(", "\lbrace", "\|" and so on, the delimiter; 0 for no delimiter; '.' for none at all.
[[nodiscard]] char32_t delimiterNamed(std::string_view token);
// The sign with a stroke through it, as in ≠; 0: there is none.
[[nodiscard]] char32_t negated(char32_t code);
// The command that is most like this one; empty: none is.
[[nodiscard]] std::string_view alike(std::string_view name);

// The code point of a letter or digit in an alphabet, or itself.
[[nodiscard]] char32_t styled(char32_t letter, Alphabet alphabet);

// Of ² and ₂, the digit or sign that is raised or lowered; 0 for others.
[[nodiscard]] char32_t raisedBy(char32_t code);
[[nodiscard]] char32_t loweredBy(char32_t code);
// The other way about; 0: Unicode has none.
[[nodiscard]] char32_t raised(char32_t code);
[[nodiscard]] char32_t lowered(char32_t code);

void append(std::string& text, char32_t code); // as UTF-8

} // namespace formulas
