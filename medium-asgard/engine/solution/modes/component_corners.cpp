// Places at which several surfaces meet, and no order of passing them comes to an end; see
// component_equations.h.
#include "modes/component_equations.h"

#include <algorithm>
#include <cmath>

namespace solution {

// The surfaces on which it slides, and those on which the point lies; of those that are joined one.
std::vector<std::size_t> ComponentEquations::surfacesHere() {
    std::vector<std::size_t> here = mode_.sliding;
    for (std::size_t s = 0; s < model_.surfaces().size(); ++s) {
        if (std::ranges::find(here, s) != here.end() || mode_.isCoincident(s) ||
            mode_.decisions[model_.surfaces()[s].members[0].decision] == expression::noBranch)
            continue;
        if (model_.surfaces()[s].whole && !takeLevel(s))
            continue;
        field();
        const std::vector<double> now = out_;
        const Slope slope = guardRate(s, now);
        if (slope.still || !(std::abs(distance(s)) <= slope.near))
            continue;
        join(s);
        here.push_back(s);
    }
    return here;
}

// Does what is not slid upon lead away to its side, or along the surface, and what is have weights?
bool ComponentEquations::isSolved(std::span<const std::size_t> surfaces, Solution asked) {
    const double margin = asked.within ? 1e-9 : -1e-12;
    const auto isOutside = [margin](double w) { return w < margin || w > 1 - margin; };
    if (!sliding())
        evaluate(out_);
    else if (!weigh() || std::ranges::any_of(weights_, isOutside))
        return false;
    const std::vector<double> rates = out_;
    return std::ranges::all_of(surfaces, [&](std::size_t s) {
        if (mode_.slidesOn(s))
            return true;
        const Slope slope = guardRate(s, rates);
        return slope.rate * mode_.sides[s] > (asked.leaves ? slope.noise : -slope.noise);
    });
}

// The first that is one, with as few slides as there can be: best where all weights are within
// their ends, so that it lasts, and all else is left at once.
bool ComponentEquations::solveCorner() {
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
                    setSide(s, digits % 3 == 1 ? +1 : -1);
                    digits /= 3;
                }
                if (mode_.sliding.size() == slides && isSolved(here, asked))
                    return true;
            }
    return restore();
}

} // namespace solution
