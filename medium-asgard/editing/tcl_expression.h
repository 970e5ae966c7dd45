// Arithmetic of Tcl's expr on numbers and variables, with the places of its numbers.
//
// + - * / % ** and parentheses, integers and doubles apart as Tcl keeps them, and the functions of
// one number. An expression with anything else has no value here.
#pragma once

#include "scene/scene.h"

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

namespace editing {

struct TclNumber {
    double value = 0;
    bool integer = false;
};

// As written: "2" is an integer, "2.0" is not; nothing: no decimal number. An integer with a zero
// before it is none either, since Tcl reads it as octal ("010" is 8).
[[nodiscard]] std::optional<TclNumber> tclNumber(std::string_view text);

struct TclNames {
    std::function<std::optional<TclNumber>(std::string_view variable)> variable;
    // The value that a number of the expression, by its place in the text, is to count as.
    std::function<std::optional<TclNumber>(scene::Range literal)> literal;
};

[[nodiscard]] std::optional<TclNumber> tclValue(std::string_view text, scene::Range expression,
                                                const TclNames& names);
// Where its numbers stand, without their signs.
[[nodiscard]] std::vector<scene::Range> tclLiterals(std::string_view text, scene::Range expression);

} // namespace editing
