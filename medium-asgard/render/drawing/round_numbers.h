// Numbers that people read easily.
#pragma once

namespace render {

// The power of ten that is not above x > 0.
[[nodiscard]] double powerBelow(double x);

// The least of 1, 2, 5 times a power of ten that is not below x > 0; the greatest not above.
[[nodiscard]] double roundAbove(double x);
[[nodiscard]] double roundBelow(double x);

} // namespace render
