#include "exact/plain_motion.h"

#include <algorithm>
#include <cmath>

namespace solution {

std::optional<PlainRate> plainRateOf(ComponentEquations& equations) {
    if (equations.states().size() != 1 || equations.watches() > 0 ||
        !equations.multipliers().empty())
        return std::nullopt;
    const expression::Node rate = equations.outputs()[0];
    if (equations.graph().op(rate) == expression::Op::constant)
        return PlainRate{equations.graph().value(rate), {}};
    if (const auto constant = equations.functions().constantOf(rate))
        return PlainRate{*constant, {}};
    if (const auto input = equations.functions().inputOf(rate))
        return PlainRate{0, equations.inputs().unknowns()[*input]};
    return std::nullopt;
}

std::optional<PlainPiece> plainPiece(const PlainRate& rate, const Histories& histories, double t,
                                     double value) {
    PlainPiece piece;
    auto& [row, count, scale] = piece;
    row[0] = value;
    row[1] = rate.constant;
    if (rate.unknown) {
        const Piece read = histories.piece(*rate.unknown, t);
        count = read.coefficients.size() + 1;
        if (read.until != infinity || read.origin > t || count > row.size())
            return std::nullopt;
        scale = read.scale;
        Coefficients shifted;
        std::span<const double> c = read.coefficients;
        if (read.origin != t)
            c = shifted = reparametrize(c, (t - read.origin) / scale, 1);
        for (std::size_t k = 0; k + 1 < count; ++k)
            row[k + 1] = c[k] * scale / static_cast<double>(k + 1);
    }
    while (count > 1 && row[count - 1] == 0)
        --count;
    if (!std::all_of(row.begin(), row.end(), [](double c) { return std::isfinite(c); }))
        return std::nullopt;
    return piece;
}

} // namespace solution
