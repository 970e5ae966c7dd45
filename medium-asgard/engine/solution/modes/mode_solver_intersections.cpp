// Surfaces that lie in the same place or meet, and motion that is held on them; see mode_solver.h.
#include "modes/mode_solver.h"

#include <algorithm>
#include <cmath>

namespace solution {

using expression::Decision;

// Surfaces whose weight lies outside [0, 1] are left; false when that does not settle.
bool ModeSolver::settleWeights(double t, std::span<const double> y) {
    const std::size_t most = 2 * mode_.sliding.size();
    f_.fill(t, y);
    for (std::size_t round = 0; round <= most; ++round) {
        if (mode_.sliding.empty())
            return true;
        if (!field_.weigh())
            return false;
        const auto outside = std::find_if(f_.weights().begin(), f_.weights().end(),
                                          [](double w) { return w < -1e-12 || w > 1 + 1e-12; });
        if (outside == f_.weights().end())
            return true;
        const auto place = outside - f_.weights().begin();
        const std::size_t s = mode_.sliding[static_cast<std::size_t>(place)];
        const int side = *outside < 0 ? -1 : +1;
        mode_.sliding.erase(mode_.sliding.begin() + place);
        mode_.setSide(s, side);
    }
    return false;
}

// Onto the surfaces of sliding, along the difference of their fields; exactly where the guard is a
// state.
void ModeSolver::project(double t, std::span<double> y) {
    std::vector<double> above(field_.size()), below(above);
    for (const std::size_t s : mode_.sliding) {
        const ComponentModel::Gradient& g = model_.gradient(s);
        const double level = model_.surfaces()[s].whole ? static_cast<double>(mode_.levels[s]) : 0;
        if (g.state) {
            y[*g.state] = level;
            continue;
        }
        f_.fill(t, y);
        const double off = f_.valueOf(s) - level;
        mode_.setSide(s, +1);
        field_.outputs(above);
        mode_.setSide(s, -1);
        field_.outputs(below);
        std::vector<double> direction(f_.states().size());
        for (std::size_t i = 0; i < direction.size(); ++i)
            direction[i] = above[i] - below[i];
        const double along = f_.guardRate(s, above).rate - f_.guardRate(s, below).rate;
        if (along != 0 && std::isfinite(off / along))
            for (std::size_t i = 0; i < direction.size(); ++i)
                y[i] -= off / along * direction[i];
    }
}

// From the surfaces of sliding, by surface.
std::vector<double> ModeSolver::distancesOfSliding() {
    std::vector<double> distances(model_.surfaces().size());
    if (!mode_.sliding.empty())
        field_.find();
    for (const std::size_t s : mode_.sliding)
        distances[s] = f_.distance(s);
    return distances;
}

// Where the guard itself has jumped since, as that of a belt's friction when the belt turns back,
// the motion is not on the surface any more: the value says on which side it is. True: it left one.
bool ModeSolver::leaveWhereJumped(std::span<const double> before) {
    const std::vector<std::size_t> slid = mode_.sliding;
    for (const std::size_t s : slid) {
        const std::vector<double> now = field_.here();
        const double near = f_.guardRate(s, now).near + std::abs(before[s]);
        const double off = f_.distance(s);
        if (!(std::abs(off - before[s]) > near))
            continue;
        std::erase(mode_.sliding, s);
        mode_.coincident[s].clear();
        if (model_.surfaces()[s].whole)
            mode_.decisions[model_.surfaces()[s].members[0].decision] = wholeBranch(s, now);
        else
            mode_.setOwnSide(s, off > 0 ? +1 : -1);
        return true;
    }
    return false;
}

bool ModeSolver::standsOn(const std::vector<std::size_t>& surfaces, double t,
                          std::span<const double> y) {
    f_.fill(t, y);
    return std::ranges::all_of(surfaces, [this](std::size_t s) {
        const double value = f_.valueOf(s);
        const double level = model_.surfaces()[s].whole ? std::round(value) : 0;
        return std::abs(value - level) <= 2 * ModelFunctions::standing;
    });
}

// On those that are left for one of their sides it stays too.
bool ModeSolver::holdsOn(const std::vector<std::size_t>& surfaces) {
    const std::vector<double> rates = field_.here();
    return std::ranges::all_of(surfaces, [&](std::size_t s) {
        const GuardSlope slope = f_.guardRate(s, rates);
        return mode_.slidesOn(s) || std::abs(slope.rate) <= slope.noise;
    });
}

bool ModeSolver::holdOn(const std::vector<std::size_t>& surfaces, double t,
                        std::span<const double> reach, std::span<double> y) {
    const Mode before = mode_;
    f_.fill(t, y);
    for (const std::size_t s : surfaces) {
        if (mode_.slidesOn(s) || mode_.isCoincident(s))
            continue;
        if (model_.surfaces()[s].whole)
            mode_.levels[s] = std::llround(f_.valueOf(s));
        join(s);
        mode_.sliding.push_back(s);
    }
    std::vector<double> at(y.begin(), y.end());
    project(t, at);
    bool isHeld = settleWeights(t, at) && holdsOn(surfaces);
    for (std::size_t i = 0; i < at.size(); ++i)
        isHeld = isHeld && std::abs(at[i] - y[i]) <= reach[i];
    if (!isHeld) {
        mode_ = before;
        return false;
    }
    std::ranges::copy(at, y.begin());
    guards_.refresh();
    return true;
}

// The whole number nearest to the argument of floor or ceil, and the side on which it is. False:
// there is none so near that it could be passed here, beside the branch in force.
bool ModeSolver::takeLevel(std::size_t surface) {
    const std::vector<double> now = field_.here();
    const GuardSlope slope = f_.guardRate(surface, now);
    const Decision taken = mode_.decisions[model_.surfaces()[surface].members[0].decision];
    const double nearest = std::round(slope.value);
    constexpr double largest = 9e15;
    if (taken == expression::noBranch || slope.still || !(std::abs(nearest) < largest) ||
        !(std::abs(slope.value - nearest) <= slope.near))
        return false;
    mode_.levels[surface] = static_cast<Decision>(nearest);
    for (const int side : {-1, +1})
        if (taken == mode_.decisionBeside(surface, side)) {
            mode_.sides[surface] = side;
            return true;
        }
    return false;
}

// Here, and at three points around, on the branches in force.
ModeSolver::Distances ModeSolver::distancesAround(std::size_t surface) {
    constexpr double size = 1e-3;
    const std::size_t variables = model_.variables();
    const std::vector<double> here(f_.in().begin(),
                                   f_.in().begin() + static_cast<std::ptrdiff_t>(variables));
    const bool isWhole = model_.surfaces()[surface].whole;
    const double level = isWhole ? static_cast<double>(mode_.levels[surface]) : 0;
    std::vector<double> values(variables + 1);
    Distances distances{};
    for (std::size_t k = 0; k < distances.size(); ++k) {
        for (std::size_t i = 0; k > 0 && i < variables; ++i) {
            const double way = static_cast<double>(((i + 1) << k) % 7) - 3.25;
            f_.in()[i] = here[i] + size * way * (1 + std::abs(here[i]));
        }
        f_.evaluate(model_.gradient(surface).derivatives, values);
        distances[k] = values.back() - level;
    }
    std::ranges::copy(here, f_.in().begin());
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
std::optional<int> ModeSolver::orientationBeside(std::size_t surface,
                                                 std::span<const Distances, 2> mine,
                                                 std::size_t other) {
    const int before = mode_.sides[surface];
    double factors[2];
    for (const int side : {-1, +1}) {
        mode_.setOwnSide(surface, side);
        const std::size_t k = side < 0 ? 0 : 1;
        factors[k] = factorBetween(distancesAround(other), mine[k]);
    }
    mode_.setOwnSide(surface, before);
    if (factors[0] * factors[1] > 0)
        return factors[0] > 0 ? +1 : -1;
    return std::nullopt;
}

// With all that lies in the same place.
void ModeSolver::join(std::size_t surface) {
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
            mode_.levels[s] = std::llround(f_.valueOf(s));
        if (!(std::abs(f_.distance(s)) <= near))
            continue;
        if (!mine) {
            mine.emplace();
            for (const int side : {-1, +1}) {
                mode_.setOwnSide(surface, side);
                (*mine)[side < 0 ? 0 : 1] = distancesAround(surface);
            }
            mode_.setOwnSide(surface, before);
        }
        if (const auto orientation = orientationBeside(surface, *mine, s))
            mode_.coincident[surface].push_back({s, *orientation});
    }
}

// The surfaces on which it slides, and those on which the point lies; of those that are joined one.
std::vector<std::size_t> ModeSolver::surfacesHere() {
    std::vector<std::size_t> here = mode_.sliding;
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        if (std::ranges::find(here, s) != here.end() || mode_.isCoincident(s) ||
            mode_.decisions[model_.surfaces()[s].members[0].decision] == expression::noBranch)
            continue;
        if (model_.surfaces()[s].whole && !takeLevel(s))
            continue;
        const std::vector<double> now = field_.here();
        const GuardSlope slope = f_.guardRate(s, now);
        if (slope.still || !(std::abs(f_.distance(s)) <= slope.near))
            continue;
        join(s);
        here.push_back(s);
    }
    return here;
}

// Does what is not slid upon lead away to its side, or along the surface, and what is have weights?
bool ModeSolver::isSolved(std::span<const std::size_t> surfaces, Solution asked) {
    const double margin = asked.within ? 1e-9 : -1e-12;
    const auto isOutside = [margin](double w) { return w < margin || w > 1 - margin; };
    std::vector<double> rates(field_.size());
    if (!mode_.isHeld())
        field_.outputs(rates);
    else if (!field_.weigh() || std::ranges::any_of(f_.weights(), isOutside))
        return false;
    else
        rates = field_.values();
    return std::ranges::all_of(surfaces, [&](std::size_t s) {
        if (mode_.slidesOn(s))
            return true;
        const GuardSlope slope = f_.guardRate(s, rates);
        return slope.rate * mode_.sides[s] > (asked.leaves ? slope.noise : -slope.noise);
    });
}

// The first that is one, with as few slides as there can be: best where all weights are within
// their ends, so that it lasts, and all else is left at once.
bool ModeSolver::solveCorner() {
    constexpr std::size_t most = 5;
    const Mode before = mode_;
    const std::vector<std::size_t> here = surfacesHere();
    const auto restore = [&] {
        mode_ = before;
        return false;
    };
    if (here.size() < 2 || here.size() > most)
        return restore();
    std::size_t ways = 1; // each surface is left below, left above, or slid upon
    for (std::size_t k = 0; k < here.size(); ++k)
        ways *= 3;
    constexpr Solution wishes[] = {{true, true}, {true, false}, {false, true}, {false, false}};
    for (const Solution asked : wishes)
        for (std::size_t slides = 0; slides <= here.size(); ++slides)
            for (std::size_t way = 0; way < ways; ++way) {
                mode_.sliding.clear();
                std::size_t digits = way;
                for (const std::size_t s : here) {
                    if (digits % 3 == 2)
                        mode_.sliding.push_back(s);
                    mode_.setSide(s, digits % 3 == 1 ? +1 : -1);
                    digits /= 3;
                }
                if (mode_.sliding.size() == slides && isSolved(here, asked))
                    return true;
            }
    return restore();
}

} // namespace solution
