#include "simulation/accuracy.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace simulation {
namespace {

constexpr std::size_t spacedTimes = 128, stepTimes = 2000;

// Where an error can peak: at the ends of the body's own steps, thinned when there are many.
std::vector<double> timesOf(const Problem& problem, const BodyRecord& body,
                            const solution::Histories& histories, double until) {
    std::vector<double> times;
    const double start = problem.start();
    for (std::size_t i = 0; i <= spacedTimes; ++i)
        times.push_back(start + (until - start) * static_cast<double>(i) / spacedTimes);
    std::vector<double> steps;
    for (const std::size_t unknown : {physics::x, physics::y, physics::z, physics::qw}) {
        double t = start;
        for (std::size_t guard = 0; t < until && guard < 50 * stepTimes; ++guard) {
            const double next = histories.piece(body.firstUnknown + unknown, t).until;
            if (!(next > t) || next > until)
                break;
            steps.push_back(next);
            t = next;
        }
    }
    const std::size_t stride = steps.size() / stepTimes + 1;
    for (std::size_t i = 0; i < steps.size(); i += stride)
        times.push_back(steps[i]);
    std::ranges::sort(times);
    return times;
}

double positionError(const BodyState& a, const BodyState& b, double radius) {
    const double angle = a.attitude.angularDistance(b.attitude);
    return std::max((a.position - b.position).norm(), angle * radius);
}

} // namespace

std::vector<IslandError> compareRuns(const Problem& problem, const Run& first, const Run& second,
                                     double limit) {
    struct Sample {
        double time, error;
    };
    const auto& bodies = *problem.bodies;
    std::map<std::size_t, std::vector<Sample>> samples; // by island
    std::map<std::size_t, Eigen::AlignedBox3d> boxes;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].isFixed)
            continue;
        const std::size_t island = second.island[b];
        const double until = std::min({problem.finish(), knownUntil(bodies[b], *first.histories),
                                       knownUntil(bodies[b], *second.histories)});
        for (const double t : timesOf(problem, bodies[b], *second.histories, until)) {
            const BodyState state = stateOf(bodies[b], *second.histories, t);
            const BodyState other = stateOf(bodies[b], *first.histories, t);
            samples[island].push_back({t, positionError(state, other, bodies[b].radius)});
            const Vector radius = Vector::Constant(bodies[b].radius);
            boxes[island].extend(Vector(state.position - radius));
            boxes[island].extend(Vector(state.position + radius));
        }
    }
    std::map<std::size_t, IslandError> errors;
    for (const auto& [island, list] : samples) {
        IslandError error{.size = boxes[island].sizes().maxCoeff(),
                          .largest = 0,
                          .beyondFrom = solution::infinity};
        for (const Sample& sample : list) {
            const double scaled = sample.error / error.size;
            if (!(scaled <= error.largest))
                error.largest = scaled;
            if (!(scaled <= limit))
                error.beyondFrom = std::min(error.beyondFrom, sample.time);
        }
        errors[island] = error;
    }
    std::vector<IslandError> byBody(bodies.size(),
                                    {.size = 0, .largest = 0, .beyondFrom = solution::infinity});
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (!bodies[b].isFixed)
            byBody[b] = errors[second.island[b]];
    return byBody;
}

} // namespace simulation
