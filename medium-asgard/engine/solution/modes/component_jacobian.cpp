// The Jacobian of a component; see component_equations.h.
#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Decision;

const Pattern& ComponentEquations::jacobianPattern() { return model_.jacobian().pattern; }

void ComponentEquations::evaluate(const ComponentModel::Derived& derived, std::span<double> out) {
    evaluate(derived, in_, out);
}

void ComponentEquations::evaluate(const ComponentModel::Derived& derived,
                                  std::span<const double> in, std::span<double> out) {
    derivedDecisions_.clear();
    for (const ComponentModel::Derived::Source& source : derived.sources)
        derivedDecisions_.push_back(source.decision  ? mode_.decisions[*source.decision]
                                    : source.surface ? Decision{mode_.sides[*source.surface]} *
                                                           source.orientation
                                                     : expression::noBranch);
    if (derivedDecisions_.empty())
        derived.function.evaluate(in, out, scratch_);
    else
        derived.function.evaluate(in, out, scratch_, derivedDecisions_);
}

bool ComponentEquations::jacobian(double t, std::span<const double> y, std::span<double> entries) {
    if (sliding())
        return differences(t, y, entries);
    fill(t, y);
    evaluate(model_.jacobian().entries, entries);
    return std::ranges::all_of(entries, [](double x) { return std::isfinite(x); }) ||
           differences(t, y, entries);
}

// While sliding f is a mixture whose weights depend on y too; few unknowns slide, so differences
// do, and where derivatives overflow (of 1/cosh(x)^2, far out) while rates do not. What stays on
// its surface exactly moves nothing, and may have no value beside it.
bool ComponentEquations::differences(double t, std::span<const double> y,
                                     std::span<double> entries) {
    std::vector<double> at(y.begin(), y.end()), low(states().size()), high(states().size());
    const Pattern& pattern = model_.jacobian().pattern;
    for (std::size_t column = 0; column < states().size(); ++column) {
        if (std::ranges::any_of(columns(),
                                [&](const Column& c) { return gradientOf(c).state == column; })) {
            for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k)
                entries[static_cast<std::size_t>(k)] = 0;
            continue;
        }
        const double step = 6e-6 * std::max(1e-3, std::abs(y[column]));
        at[column] = y[column] + step;
        if (!rates(t, at, high))
            return false;
        at[column] = y[column] - step;
        if (!rates(t, at, low))
            return false;
        at[column] = y[column];
        for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k) {
            const auto row = static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(k)]);
            entries[static_cast<std::size_t>(k)] = (high[row] - low[row]) / (2 * step);
        }
    }
    return true;
}

} // namespace solution
