// Surfaces that lie in the same place, and switch together; see component_equations.h.
#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Decision;

// Of floor and ceil, on a side of the whole number that is their level.
Decision ComponentEquations::decisionBeside(std::size_t surface, int side) const {
    const Decision above = model_.surfaces()[surface].ceiling ? 1 : 0;
    return mode_.levels[surface] + above - (side > 0 ? 0 : 1);
}

// Nothing has moved it from the side on which it was put.
bool ComponentEquations::isOnSide(std::size_t surface) const {
    return !model_.surfaces()[surface].whole ||
           mode_.decisions[model_.surfaces()[surface].members[0].decision] ==
               decisionBeside(surface, mode_.sides[surface]);
}

// From the surface; of floor and ceil from their level.
double ComponentEquations::distance(std::size_t surface) {
    const bool isWhole = model_.surfaces()[surface].whole;
    return valueOf(surface) - (isWhole ? static_cast<double>(mode_.levels[surface]) : 0);
}

// The whole number nearest to the argument of floor or ceil, and the side on which it is. False:
// there is none so near that it could be passed here, beside the branch in force.
bool ComponentEquations::takeLevel(std::size_t surface) {
    field();
    const std::vector<double> now = out_;
    const Slope slope = guardRate(surface, now);
    const Decision taken = mode_.decisions[model_.surfaces()[surface].members[0].decision];
    const double nearest = std::round(slope.value);
    constexpr double largest = 9e15;
    if (taken == expression::noBranch || slope.still || !(std::abs(nearest) < largest) ||
        !(std::abs(slope.value - nearest) <= slope.near))
        return false;
    mode_.levels[surface] = static_cast<Decision>(nearest);
    for (const int side : {-1, +1})
        if (taken == decisionBeside(surface, side)) {
            mode_.sides[surface] = side;
            return true;
        }
    return false;
}

// Here, and at three points around, on the branches in force.
ComponentEquations::Distances ComponentEquations::distancesAround(std::size_t surface) {
    constexpr double size = 1e-3;
    const std::size_t variables = model_.variables();
    const std::vector<double> here(in_.begin(),
                                   in_.begin() + static_cast<std::ptrdiff_t>(variables));
    const bool isWhole = model_.surfaces()[surface].whole;
    const double level = isWhole ? static_cast<double>(mode_.levels[surface]) : 0;
    std::vector<double> values(variables + 1);
    Distances distances{};
    for (std::size_t k = 0; k < distances.size(); ++k) {
        for (std::size_t i = 0; k > 0 && i < variables; ++i) {
            const double way = static_cast<double>(((i + 1) << k) % 7) - 3.25;
            in_[i] = here[i] + size * way * (1 + std::abs(here[i]));
        }
        evaluate(model_.gradient(surface).derivatives, values);
        distances[k] = values.back() - level;
    }
    std::ranges::copy(here, in_.begin());
    return distances;
}

namespace {

// The factor that makes these of those, if there is one.
template <class Values> double factorBetween(const Values& these, const Values& those) {
    constexpr double alike = 1e-9;
    const auto isLess = [](double a, double b) { return std::abs(a) < std::abs(b); };
    const double one = *std::ranges::max_element(these, isLess);
    const auto largest = std::ranges::max_element(those, isLess);
    const double factor = these[static_cast<std::size_t>(largest - those.begin())] / *largest;
    for (std::size_t k = 0; k < these.size(); ++k)
        if (!(std::abs(these[k] - factor * those[k]) <= alike * std::abs(one)))
            return 0;
    return std::isfinite(factor) ? factor : 0;
}

} // namespace

// `mine` with the surface on either side: the other lies in the same place only where both say so,
// since it may itself read what switches there.
std::optional<int> ComponentEquations::orientationBeside(std::size_t surface,
                                                         std::span<const Distances, 2> mine,
                                                         std::size_t other) {
    const int before = mode_.sides[surface];
    double factors[2];
    for (const int side : {-1, +1}) {
        setOwnSide(surface, side);
        const std::size_t k = side < 0 ? 0 : 1;
        factors[k] = factorBetween(distancesAround(other), mine[k]);
    }
    setOwnSide(surface, before);
    if (factors[0] * factors[1] > 0)
        return factors[0] > 0 ? +1 : -1;
    return std::nullopt;
}

// With all that lies in the same place.
void ComponentEquations::join(std::size_t surface) {
    mode_.coincident[surface].clear();
    if (model_.surfaces().size() == 1)
        return;
    constexpr double near = 1e-2;
    std::optional<std::array<Distances, 2>> mine;
    const int before = mode_.sides[surface];
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        const bool slides = mode_.slidesOn(s);
        if (s == surface || slides || mode_.isCoincident(s) ||
            mode_.decisions[model_.surfaces()[s].members[0].decision] == expression::noBranch)
            continue;
        if (model_.surfaces()[s].whole)
            mode_.levels[s] = std::llround(valueOf(s));
        if (!(std::abs(distance(s)) <= near))
            continue;
        if (!mine) {
            mine.emplace();
            for (const int side : {-1, +1}) {
                setOwnSide(surface, side);
                (*mine)[side < 0 ? 0 : 1] = distancesAround(surface);
            }
            setOwnSide(surface, before);
        }
        if (const auto orientation = orientationBeside(surface, *mine, s))
            mode_.coincident[surface].push_back({s, *orientation});
    }
}

} // namespace solution
