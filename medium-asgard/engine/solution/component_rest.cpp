// How a component comes to where directions have none, as what friction in a plane stops; see
// component.h and component_equations.h.
//
// Near rest the rates turn within ever shorter times. A step goes no farther than nine tenths of
// the way to where the present rates lead to rest, so that explicit steps stay on this side of it
// and come nearer by a tenth each time where the way is straight. Where it is not, since what pulls
// is nearly as strong as what brakes, directions turn so much faster than the length falls that an
// explicit step swings about the way: it goes half as far, until the length falls as foreseen. What
// is nearer than a step may err by goes there along its rates.
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
    constexpr double shortest = 8;
    restsAfter_ = infinity;
    const std::vector<double> y = stateValues();
    takeReach(y);
    // Along the present rates no farther than a step might go.
    const double farthest = proposed_ > 0 ? proposed_ : longestFirst();
    for (const auto& [direction, length, duration, isNear] : equations_->approaches(time_, y)) {
        const bool isHere = duration <= shortest * shortestStep(time_);
        if ((isHere || (isNear && duration <= farthest && time_ + duration <= limit_)) &&
            goToRest(direction, duration))
            return true;
        if (!isHere && !isNear)
            restsAfter_ = std::min(restsAfter_, partOfWay(direction, length, duration) * duration);
    }
    return false;
}

// How much of the way to rest the next step may go: a vector that was to fall by much and did not
// is swung about by steps that are too long for how fast it turns.
double Component::partOfWay(std::size_t direction, double length, double duration) {
    constexpr double most = 0.9, least = 0.01, much = 0.3, again = 1.1;
    const auto [now, isNew] =
        falling_.try_emplace(direction, Falling{time_, length, duration, most});
    Falling& falling = now->second;
    const double way = isNew ? 0 : (time_ - falling.time) / falling.duration;
    if (way > falling.part * much && way <= 1) {
        const bool fell = length <= falling.length * (1 - 0.5 * way);
        falling.part = std::clamp(falling.part * (fell ? again : 0.5), least, most);
    }
    falling = {time_, length, duration, way > 1 ? most : falling.part};
    return falling.part;
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
