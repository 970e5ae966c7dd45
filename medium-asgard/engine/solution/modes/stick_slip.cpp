#include "modes/stick_slip.h"

#include <algorithm>
#include <cmath>

namespace solution {

// Its vector to that value, by what its forces do; exactly where its parts are states.
void StickSlip::put(std::size_t direction, const Eigen::VectorXd& target,
                    const HeldField::Response& response, std::span<double> y) {
    const auto [first, count] = model_.directions().ranges[direction];
    Eigen::VectorXd wanted = target;
    for (std::size_t i = 0; i < count; ++i)
        wanted(static_cast<Eigen::Index>(i)) -= f_.scaleOf(first + i) * f_.measures()[first + i];
    const Eigen::VectorXd blow = leastSolution(response.change, wanted);
    for (std::size_t j = 0; j < count && blow.allFinite(); ++j)
        for (std::size_t k = 0; k < y.size(); ++k)
            y[k] += blow(static_cast<Eigen::Index>(j)) * response.fields[j][k];
    for (std::size_t i = 0; i < count; ++i)
        if (const auto state = model_.directions().gradients[first + i].state)
            y[*state] = target(static_cast<Eigen::Index>(i)) / f_.scaleOf(first + i);
}

// The error that a step may have in one part of the vector, scaled.
double StickSlip::reachOf(std::size_t part) {
    std::vector<double> partial(model_.variables() + 1);
    f_.evaluate(model_.directions().gradients[part].derivatives, partial);
    double reach = 0;
    for (std::size_t i = 0; i < reach_.size(); ++i)
        reach += std::abs(partial[1 + i]) * reach_[i];
    return f_.scaleOf(part) * reach;
}

// For a body that begins to slip: how much farther its velocity may deviate from the direction of
// the pull. A deviation within the tolerance does not count. While the velocity hardly grows, its
// direction is that of the pull, whatever it was before, so more deviation is allowed.
double StickSlip::leeway() {
    constexpr double part = 1e-2, slow = 1e-2, rounding = 1e-9;
    const auto [first, count] = model_.directions().ranges[*mode_.leaving];
    f_.measure();
    const Eigen::VectorXd a = f_.vectorOf(*mode_.leaving);
    const double length = a.norm();
    double off = 0, allowed = reachOf(first);
    for (std::size_t p = first; p < first + count; ++p) {
        off = std::max(off,
                       std::abs(a(static_cast<Eigen::Index>(p - first)) - length * f_.units()[p]));
        allowed = std::min(allowed, reachOf(p));
    }
    allowed = std::max(allowed, tolerance_ * length); // nothing has moved yet
    allowed += part * length * std::max(0.0, 1 - field_.growth() / (slow * field_.pull()));
    return std::min(allowed - off, field_.growth() / field_.pull() + rounding);
}

// A body counts as beginning to slip as long as rates near its rest are stiff. One does at a time;
// others leave their rest by next to nothing.
bool StickSlip::leaveRest(std::size_t direction, double t, std::span<double> y) {
    constexpr double part = 1e-2, least = 1e-100;
    f_.fill(t, y);
    const auto response = field_.responseOf(direction);
    const auto departure = response ? response->departure() : std::nullopt;
    if (!departure)
        return false;
    if (!mode_.leaving) {
        mode_.leaving = direction;
        return true;
    }
    const auto [first, count] = model_.directions().ranges[direction];
    double reach = reachOf(first);
    for (std::size_t p = first + 1; p < first + count; ++p)
        reach = std::min(reach, reachOf(p));
    put(direction, std::max(part * reach, least) * departure->direction, *response, y);
    std::erase(mode_.sticking, direction);
    return true;
}

bool StickSlip::leave(std::span<const std::size_t> directions, double t, std::span<double> y) {
    bool isDone = true;
    for (const std::size_t direction : directions)
        isDone =
            (direction == mode_.leaving ? setFree(t, y) : leaveRest(direction, t, y)) && isDone;
    return isDone;
}

// It has left, and goes as its direction says; or does not leave after all.
bool StickSlip::setFree(double t, std::span<double> y) {
    const std::size_t direction = *mode_.leaving;
    f_.fill(t, y);
    const auto response = field_.responseOf(direction);
    const auto departure = response ? response->departure() : std::nullopt;
    f_.measure();
    const Eigen::VectorXd vector = f_.vectorOf(direction);
    const auto first = model_.directions().ranges[direction].first;
    bool isThere = true;
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        isThere = isThere && std::abs(vector(i)) <= reachOf(first + static_cast<std::size_t>(i));
    mode_.leaving.reset();
    if (vector.isZero(0) || (departure && departure->growth <= 0 && isThere)) {
        if (response)
            put(direction, Eigen::VectorXd::Zero(vector.size()), *response, y);
        return response.has_value();
    }
    constexpr double aside = 0.1; // more is none of its own doing
    if (departure && departure->growth > 0) {
        const Eigen::VectorXd straight = vector.norm() * departure->direction;
        if ((straight - vector).norm() <= aside * vector.norm())
            put(direction, straight, *response, y);
    }
    std::erase(mode_.sticking, direction);
    return true;
}

// Where what is held is not at 0 any more, since its expression has jumped, as that of a plate's
// speed when the plate turns back.
void StickSlip::releaseWhereJumped(double t, std::span<const double> y) {
    if (mode_.sticking.empty())
        return;
    f_.fill(t, y);
    f_.measure();
    std::erase_if(mode_.sticking, [this](std::size_t direction) {
        const auto [first, count] = model_.directions().ranges[direction];
        bool hasJumped = false;
        for (std::size_t p = first; direction != mode_.leaving && p < first + count; ++p)
            hasJumped = hasJumped || std::abs(f_.measures()[p]) * f_.scaleOf(p) > reachOf(p);
        return hasJumped;
    });
}

std::vector<StickSlip::Approach> StickSlip::approaches(double t, std::span<const double> y) {
    constexpr double part = 0.1;
    std::vector<Approach> found;
    f_.fill(t, y);
    const std::vector<double> rates = field_.here();
    f_.measure();
    const ComponentModel::Directions& directions = model_.directions();
    const auto& ranges = directions.ranges;
    for (std::size_t d = 0; d < ranges.size(); ++d) {
        if (d != mode_.leaving && std::ranges::find(mode_.sticking, d) != mode_.sticking.end())
            continue;
        double square = 0, along = 0, noise = 0;
        bool isNear = true;
        for (std::size_t p = ranges[d].first; p < ranges[d].first + ranges[d].count; ++p) {
            const double a = f_.scaleOf(p) * f_.measures()[p];
            const GuardSlope slope = f_.slopeOf(directions.gradients[p].derivatives, rates);
            square += a * a;
            along += a * f_.scaleOf(p) * slope.rate;
            noise += std::abs(a) * f_.scaleOf(p) * slope.noise;
            isNear = isNear && std::abs(a) <= part * reachOf(p);
        }
        if (along < -noise)
            found.push_back({d, std::sqrt(square), -square / along, isNear});
    }
    return found;
}

bool StickSlip::rest(std::span<const std::size_t> directions, double t, std::span<double> y) {
    const Mode before = mode_;
    f_.fill(t, y);
    if (mode_.leaving && std::ranges::find(directions, *mode_.leaving) != directions.end()) {
        std::erase(mode_.sticking, *mode_.leaving);
        mode_.leaving.reset();
    }
    const std::size_t others = mode_.sticking.size();
    mode_.sticking.insert(mode_.sticking.end(), directions.begin(), directions.end());
    for (const std::size_t d : directions) {
        f_.fill(t, y);
        const auto response = field_.responseOf(d);
        if (response && response->brakes())
            put(d, Eigen::VectorXd::Zero(response->rate.size()), *response, y);
        else
            std::erase(mode_.sticking, d);
    }
    bool isDone = mode_.sticking.size() > others;
    for (std::size_t round = 0; isDone && round < f_.units().size(); ++round) {
        f_.fill(t, y);
        const auto more = [this](std::size_t a, std::size_t b) {
            return field_.excess(a) < field_.excess(b);
        };
        const bool isPossible = field_.weigh();
        const auto worst = std::ranges::max_element(mode_.sticking, more);
        if (worst == mode_.sticking.end() || (isPossible && field_.excess(*worst) <= 0))
            break;
        isDone = leaveRest(isPossible ? *worst : mode_.sticking.back(), t, y);
    }
    if (!isDone)
        mode_ = before;
    return isDone;
}

} // namespace solution
