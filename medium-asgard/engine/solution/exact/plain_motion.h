// A single unknown whose rate is a constant, or another unknown, as the place of a body in free
// flight: it goes on for ever in one piece, bit for bit as closed_form.h would have it.
#pragma once

#include "modes/component_equations.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>

namespace solution {

struct PlainRate {
    double constant = 0;
    std::optional<std::size_t> unknown; // it is that one
};
// None: there are several states, switches, or another rate.
[[nodiscard]] std::optional<PlainRate> plainRateOf(ComponentEquations& equations);

struct PlainPiece {
    std::array<double, maximumCoefficients> row{};
    std::size_t count = 2;
    double scale = 1;
    [[nodiscard]] History::Step stepFrom(double t) const {
        return {t, infinity, scale, true, static_cast<std::uint8_t>(count)};
    }
    [[nodiscard]] std::span<const double> numbers() const { return std::span(row).first(count); }
};
// From t on for ever, when its rate goes on so too.
[[nodiscard]] std::optional<PlainPiece>
plainPiece(const PlainRate& rate, const Histories& histories, double t, double value);

} // namespace solution
