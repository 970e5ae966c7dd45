// Polynomials in one variable and the first place where one becomes negative.
//
// Roots are isolated by Descartes' rule on Bernstein coefficients (they have at least as many
// changes of sign as the polynomial has roots), halving the interval until one change is left, and
// refined by Newton's method kept inside its bracket. No closed formulas: Ferrari's loses all
// quartic roots as the leading coefficient vanishes.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

namespace collision {

inline constexpr std::size_t maximumTerms = 17; // squares of degree 8

struct Polynomial {
    std::array<double, maximumTerms> terms{}; // of powers of s
    std::size_t count = 1;

    [[nodiscard]] double value(double s) const;
    [[nodiscard]] double derivative(double s) const;
};

// The first s in [0, length] such that the polynomial is negative just after s (and at s itself
// when it starts negative). `value`, when given, is the same function computed more accurately; the
// root is refined on it. A polynomial that only touches zero has no such s.
[[nodiscard]] std::optional<double>
firstDescent(const Polynomial& polynomial, double length,
             const std::function<double(double)>& value = nullptr);

} // namespace collision
