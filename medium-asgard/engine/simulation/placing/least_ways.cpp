#include "placing/least_ways.h"

#include <algorithm>
#include <cmath>

namespace simulation {

LeastWays leastWays(const std::vector<physics::PartGap>& gaps, const std::vector<char>& isLoose,
                    int sweeps, const std::function<double(const physics::PartGap&)>& roundingOf) {
    using geometry::Vector;
    LeastWays least;
    least.forces.assign(gaps.size(), 0);
    for (const physics::PartGap& of : gaps)
        for (const std::size_t body : {of.first, of.second})
            if (isLoose[body])
                least.ways.emplace(body, Vector::Zero());
    const auto wayOf = [&](std::size_t body) {
        const auto found = least.ways.find(body);
        return found == least.ways.end() ? Vector(Vector::Zero()) : found->second;
    };
    for (int sweep = 0; sweep < sweeps && !least.isDone; ++sweep) {
        least.isDone = true;
        for (std::size_t k = 0; k < gaps.size(); ++k) {
            const physics::PartGap& of = gaps[k];
            const double sides = isLoose[of.first] && isLoose[of.second] ? 2 : 1;
            const double left = of.gap + of.normal.dot(wayOf(of.first) - wayOf(of.second));
            const double change = std::max(-left / sides, -least.forces[k]);
            least.isDone = least.isDone && std::abs(change) <= roundingOf(of);
            least.forces[k] += change;
            if (isLoose[of.first])
                least.ways[of.first] += change * of.normal;
            if (isLoose[of.second])
                least.ways[of.second] -= change * of.normal;
        }
    }
    return least;
}

} // namespace simulation
