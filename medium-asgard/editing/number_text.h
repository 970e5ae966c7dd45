// Numbers that gestures write.
#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace editing {

[[nodiscard]] constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }

// The shortest decimal that means `value` to the gesture, with as many decimals as the author wrote
// before: "-5" dragged to -4.3712 by hundredths is "-4.37", "1.50" dragged to 2 is "2.00". Reads
// back as a number within half of `resolution` of `value`; 0: exactly, but for what rounding adds
// to a number that was worked out (0.1 + 0.2 is "0.3").
[[nodiscard]] std::string numberText(double value, double resolution, std::string_view before = "");

// The decimal number that this byte of a text belongs to or follows, its sign included; none in
// names and colours ("b1", "#102030").
[[nodiscard]] std::optional<scene::Range> numberAt(std::string_view text, std::size_t place);

// The largest power of ten that is not above `length`, up to rounding: what a gesture that tells so
// much apart writes. 0 for 0: exactly.
[[nodiscard]] double decimalStep(double length);
// The multiple of `step` next to the value, as few decimals give it; 0: the value.
[[nodiscard]] double roundedTo(double value, double step);
// In so many digits, without zeros at the end.
[[nodiscard]] std::string inDigits(double value, int digits);

} // namespace editing
