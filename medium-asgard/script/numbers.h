// Numbers as scenes write them: decimal and finite.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace script {

// The whole text, blanks around it aside; nothing for hexadecimal, nan, inf, or what overflows.
[[nodiscard]] std::optional<double> decimalNumber(std::string_view text);

// The shortest decimal that reads back as the same number. `whole`: as an integer where it is one,
// else always with a point or an exponent, so that Tcl divides it as a number with a fraction.
[[nodiscard]] std::string numberText(double value, bool whole);

} // namespace script
