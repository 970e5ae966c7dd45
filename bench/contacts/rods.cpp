#include "rods.h"

#include "extrapolation.h"

#include <algorithm>
#include <numbers>

namespace bench::contacts {
namespace {

constexpr Real g = standardGravity;
constexpr Real longest = 0.01L; // of one step

} // namespace

struct FallingRod::Forces {
    Real along = 0, normal = 0, tip = 0; // on the foot, per mass
};

FallingRod::Forces FallingRod::forces(const State& state, int slips) const {
    const Real a = state[1], rate = state[3], s = std::sin(a), c = std::cos(a), l = half;
    Forces f;
    if (slips == 0) {
        f.tip = g * l * s / (inertia + l * l);
        f.along = l * (c * f.tip - s * rate * rate);
        f.normal = g - l * (s * f.tip + c * rate * rate);
        return f;
    }
    const Real friction = slips < 0 ? Real(back) : -Real(forward); // over the normal force
    const Real arm = l * (s - friction * c);
    f.tip = (g - l * c * rate * rate) * arm / (inertia + l * s * arm);
    f.normal = g - l * (s * f.tip + c * rate * rate);
    f.along = friction * f.normal;
    return f;
}

Real FallingRod::margin(const State& state) const {
    const Forces f = forces(state, 0);
    return std::min(back * f.normal - f.along, forward * f.normal + f.along);
}

int FallingRod::direction(const State& state) const { return forces(state, 0).along > 0 ? -1 : 1; }

Real FallingRod::advance(State& state, int& slips, Real span) const {
    const int way = slips;
    const auto f = [&](const State& y, State& slope) {
        const Forces now = forces(y, way);
        const Real s = std::sin(y[1]), c = std::cos(y[1]), l = half;
        const Real foot = way == 0 ? 0 : now.along - l * (c * now.tip - s * y[3] * y[3]);
        slope = {y[2], y[3], foot, now.tip};
    };
    const auto event = [&](const State& y) {
        return way == 0 ? margin(y) : static_cast<Real>(way) * y[2];
    };
    const Real step = std::min(longest, span), taken = extrapolateUntil(f, step, state, event);
    if (event(state) > 0)
        return taken;
    state[2] = 0;
    slips = way != 0 && margin(state) > 0 ? 0 : direction(state);
    return taken;
}

FallingRod::Slip FallingRod::firstSlip() const {
    State state = {0, angle, 0, 0};
    Real now = 0;
    for (int slips = 0; slips == 0;)
        now += advance(state, slips, longest);
    return {static_cast<double>(now), static_cast<double>(state[1]), static_cast<double>(state[3])};
}

std::vector<FallingRod::Pose> FallingRod::poses(const std::vector<double>& times) const {
    State state = {0, angle, 0, 0};
    Real now = 0;
    int slips = 0;
    std::vector<Pose> all;
    for (const double time : times) {
        while (now < time)
            now += advance(state, slips, time - now);
        all.push_back({static_cast<double>(state[0] + half * std::sin(state[1])),
                       static_cast<double>(state[1])});
    }
    return all;
}

Real StoppedRod::advance(std::vector<Real>& state, Real span, bool& hit) const {
    const auto f = [](const std::vector<Real>& y, std::vector<Real>& slope) {
        slope = {y[1], -Real(1.5) * g * std::cos(y[0])};
    };
    const auto event = [](const std::vector<Real>& y) {
        return y[0] + std::numbers::pi_v<Real> / 2;
    };
    const Real taken = extrapolateUntil(f, std::min(longest, span), state, event);
    hit = !(event(state) > 0);
    if (hit)
        state = {-std::numbers::pi_v<Real> / 2, -rebound * state[1]};
    return taken;
}

std::vector<double> StoppedRod::angles(const std::vector<double>& times) const {
    std::vector<Real> state = {0, 0};
    Real now = 0;
    bool hit = false;
    std::vector<double> all;
    for (const double time : times) {
        while (now < time)
            now += advance(state, time - now, hit);
        all.push_back(static_cast<double>(state[0]));
    }
    return all;
}

std::vector<double> StoppedRod::hits(std::size_t count) const {
    std::vector<Real> state = {0, 0};
    Real now = 0;
    std::vector<double> all;
    while (all.size() < count) {
        bool hit = false;
        now += advance(state, longest, hit);
        if (hit)
            all.push_back(static_cast<double>(now));
    }
    return all;
}

} // namespace bench::contacts
