// How a component's steps become pieces of its history; see component.h.
#include "solution/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

void Component::append(std::span<const Coefficients> states, double scale, double until) {
    history_->dropAnchor();
    appendPart(states, time_, scale, until, 0);
}

// Held values follow the states by polynomials of their own; where one does not fit, the step is
// kept in halves.
void Component::appendPart(std::span<const Coefficients> states, double origin, double scale,
                           double until, int depth) {
    constexpr int deepest = 10;
    if (equations_->held().empty()) {
        appendRow(states, {}, origin, scale, until);
        return;
    }
    std::vector<Coefficients> held(equations_->held().size());
    if (!held.empty() && !fitHeld(states, origin, scale, until, heldPart, held) &&
        depth < deepest) {
        const double middle = origin + 0.5 * (until - origin);
        appendPart(states, origin, scale, middle, depth + 1);
        std::vector<Coefficients> second;
        for (const Coefficients& column : states)
            second.push_back(reparametrize(column, (middle - origin) / scale, 1));
        appendPart(second, middle, scale, until, depth + 1);
        return;
    }
    if (!held.empty() && until - origin != scale) { // one scale for all
        std::vector<Coefficients> rescaled;
        for (const Coefficients& column : states)
            rescaled.push_back(reparametrize(column, 0, (until - origin) / scale));
        appendRow(rescaled, held, origin, until - origin, until);
        return;
    }
    appendRow(states, held, origin, scale, until);
}

// Polynomials of (t - origin)/(until - origin). False: they do not fit, by more than this part of
// the tolerance of what they span, and by more than rounding, of time too, makes of them.
bool Component::fitHeld(std::span<const Coefficients> states, double origin, double scale,
                        double until, double part, std::span<Coefficients> held) {
    const auto& points = interpolationPoints();
    std::vector<double> y(states.size()), out(held.size());
    std::vector<std::array<double, maximumCoefficients>> samples(held.size());
    const auto valuesAt = [&](double t) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(states[i], (t - origin) / scale);
        return equations_->heldValues(t, y, out);
    };
    const double length = until - origin;
    const double latest = std::max(std::abs(origin), std::abs(until));
    const double late = 16 * std::numeric_limits<double>::epsilon() * latest / length;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!valuesAt(p == maximumDegree ? until : origin + points[p] * length))
            return false;
        for (std::size_t k = 0; k < held.size(); ++k)
            samples[k][p] = out[k];
    }
    for (std::size_t k = 0; k < held.size(); ++k)
        held[k] = interpolate(samples[k]);
    std::vector<double> checks = {0.13, 0.31, 0.6, 0.93};
    for (const double t : centresIn(states, origin, scale, until))
        checks.push_back((t - origin) / length);
    for (const double s : checks) {
        if (!valuesAt(origin + s * length))
            return false;
        for (std::size_t k = 0; k < held.size(); ++k) {
            const auto [low, high] = std::minmax_element(samples[k].begin(), samples[k].end());
            const double size = std::max(std::abs(*low), std::abs(*high));
            const double spanned = *high - *low;
            const double allowed =
                std::max({part * tolerance_ * spanned, late * spanned, 1e-13 * size});
            if (!(std::abs(evaluate(held[k], s) - out[k]) <= allowed))
                return false;
        }
    }
    return true;
}

void Component::appendRow(std::span<const Coefficients> states, std::span<const Coefficients> held,
                          double origin, double scale, double until) {
    std::size_t count = 1;
    for (const auto& list : {states, held})
        for (const Coefficients& column : list)
            for (std::size_t k = maximumDegree; k >= count; --k)
                if (column[k] != 0) {
                    count = k + 1;
                    break;
                }
    const std::span<double> rows =
        history_->append({origin, until, scale, fresh_, static_cast<std::uint8_t>(count), 0});
    const auto place = [&](std::size_t unknown, const Coefficients& column) {
        double* row = rows.data() + unknown * count;
        for (std::size_t k = 0; k < count; ++k)
            row[k] = column[k];
    };
    for (std::size_t i = 0; i < states.size(); ++i)
        place(equations_->states()[i], states[i]);
    for (std::size_t i = 0; i < held.size(); ++i)
        place(equations_->held()[i], held[i]);
    fresh_ = false;
}

} // namespace solution
