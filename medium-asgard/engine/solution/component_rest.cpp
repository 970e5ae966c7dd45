// How a component comes to where directions have none, as what friction in a plane stops; see
// component.h and component_equations.h.
//
// Near rest the rates turn within ever shorter times. A step goes no farther than nine tenths of
// the way to where the present rates lead to rest, so that explicit steps stay on this side of it
// and come nearer by a tenth each time where the way is straight. What is nearer than a step may
// err by goes there along its rates.
#include "solution/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

// Speeds count by themselves here, not by what they move within a step.
void Component::takeReach(std::span<const double> y) {
    control_.prepare(y, infinity);
    std::vector<double> reach(y.size());
    for (std::size_t i = 0; i < reach.size(); ++i)
        reach[i] = control_.scale(i);
    equations_->setReach(reach, tolerance_);
}

void Component::decideRest(std::vector<double>& y) {
    takeReach(y);
    const auto directions = equations_->directionsAtRest(time_, y);
    std::vector<double> rested = y;
    if (!directions.empty() && equations_->rest(directions, time_, rested))
        y = rested;
}

// True: it came to rest, or through it.
bool Component::reachesRest() {
    constexpr double part = 0.9, shortest = 8;
    restsAfter_ = infinity;
    const std::vector<double> y = stateValues();
    takeReach(y);
    // Along the present rates no farther than a step might go.
    const double farthest = proposed_ > 0 ? proposed_ : longestFirst();
    for (const auto& [direction, duration, isNear] : equations_->approaches(time_, y)) {
        const bool isHere = duration <= shortest * shortestStep(time_);
        if ((isHere || (isNear && duration <= farthest && time_ + duration <= limit_)) &&
            goToRest(direction, duration))
            return true;
        if (!isHere && !isNear)
            restsAfter_ = std::min(restsAfter_, part * duration);
    }
    return false;
}

// Along the rates, and what they do to places.
bool Component::goToRest(std::size_t direction, double duration) {
    const double to = std::min(time_ + duration, limit_), h = to - time_;
    std::vector<double> y = stateValues(), slopes(y.size());
    ++counts_.evaluations;
    if (!equations_->rates(time_, y, slopes))
        return false;
    std::vector<Coefficients> line(y.size(), Coefficients{});
    for (std::size_t i = 0; i < y.size(); ++i) {
        line[i][0] = y[i];
        line[i][1] = h * slopes[i];
    }
    for (const auto& [x, v] : equations_->integrals())
        line[x][2] = 0.5 * h * h * slopes[v];
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = evaluate(line[i], 1);
    equations_->inputs().window(infinity);
    if (!equations_->rest(std::span(&direction, 1), to, y))
        return false;
    if (h > shortestStep(time_)) {
        ++counts_.steps;
        append(line, h, to);
        time_ = to;
    }
    y_ = y;
    if (land(time_))
        settle();
    if (!stop_ && time_ >= limit_)
        arrive();
    return true;
}

} // namespace solution
