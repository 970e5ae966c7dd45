#include "stepping/rest_approach.h"

#include <algorithm>

namespace solution {

// Speeds count by themselves here, not by what they move within a step.
void takeReach(const StepContext& context, std::span<const double> y) {
    ErrorControl& control = context.control();
    control.prepare(y, infinity);
    std::vector<double> reach(y.size());
    for (std::size_t i = 0; i < reach.size(); ++i)
        reach[i] = control.scale(i);
    context.equations().stickSlip().setReach(reach, context.tolerance);
}

std::optional<StepPiece> RestApproach::arrive(double farthest) {
    constexpr double shortest = 8;
    longest_ = infinity;
    const std::vector<double> y = context_.states();
    takeReach(context_, y);
    const double time = context_.time();
    for (const auto& approach : context_.equations().stickSlip().approaches(time, y)) {
        const double duration = approach.duration;
        const bool isHere = duration <= shortest * shortestStep(time);
        if (isHere ||
            (approach.isNear && duration <= farthest && time + duration <= context_.limit()))
            if (auto piece = goTo(approach.direction, duration))
                return piece;
        if (!isHere && !approach.isNear)
            longest_ = std::min(longest_, partOfWay(approach) * duration);
    }
    return std::nullopt;
}

// How much of the way to rest the next step may go: a vector that was to fall by much and did not
// is swung about by steps that are too long for how fast it turns.
double RestApproach::partOfWay(const ComponentEquations::Approach& approach) {
    constexpr double most = 0.9, least = 0.01, much = 0.3, again = 1.1;
    const double time = context_.time();
    const auto [now, isNew] = falling_.try_emplace(
        approach.direction, Falling{time, approach.length, approach.duration, most});
    Falling& falling = now->second;
    const double way = isNew ? 0 : (time - falling.time) / falling.duration;
    if (way > falling.part * much && way <= 1) {
        const bool fell = approach.length <= falling.length * (1 - 0.5 * way);
        falling.part = std::clamp(falling.part * (fell ? again : 0.5), least, most);
    }
    falling = {time, approach.length, approach.duration, way > 1 ? most : falling.part};
    return falling.part;
}

void goAlong(const ComponentEquations& equations, std::span<const double> rates, double h,
             std::vector<double>& y, std::vector<Coefficients>& curves) {
    curves.assign(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i) {
        curves[i][0] = y[i];
        curves[i][1] = h * rates[i];
    }
    for (const auto& [x, v] : equations.integrals())
        curves[x][2] = 0.5 * h * h * rates[v];
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = evaluate(curves[i], 1);
}

std::optional<StepPiece> RestApproach::goTo(std::size_t direction, double duration) {
    ComponentEquations& equations = context_.equations();
    const double from = context_.time();
    double to = std::min(from + duration, context_.limit());
    const double h = to - from;
    y_ = context_.states();
    std::vector<double> slopes(y_.size());
    ++context_.counts.evaluations;
    if (!equations.rates(from, y_, slopes))
        return std::nullopt;
    goAlong(equations, slopes, h, y_, line_);
    equations.inputs().window(infinity);
    if (!equations.rest(std::span(&direction, 1), to, y_))
        return std::nullopt;
    const bool takesTime = h > shortestStep(from);
    if (!takesTime)
        to = from;
    return StepPiece{.curves = {line_, from, h, to},
                     .end = y_,
                     .kind = takesTime ? StepPiece::Kind::step : StepPiece::Kind::nothing,
                     .endsAnew = true};
}

} // namespace solution
