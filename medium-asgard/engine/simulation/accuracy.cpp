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

double positionError(const BodyState& state, const Trace::Place& truth, double radius) {
    const double angle = truth.attitude ? state.attitude.angularDistance(*truth.attitude) : 0;
    return std::max((state.position - truth.position).norm(), angle * radius);
}

void extend(Eigen::AlignedBox3d& box, const Vector& position, double radius) {
    box.extend(Vector(position - Vector::Constant(radius)));
    box.extend(Vector(position + Vector::Constant(radius)));
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
            const Trace::Place place{.position = state.position, .attitude = state.attitude};
            samples[island].push_back({t, positionError(other, place, bodies[b].radius)});
            extend(boxes[island], state.position, bodies[b].radius);
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

Trace traceOf(const Motion& motion, std::size_t times) {
    Trace trace;
    for (std::size_t i = 0; i <= times; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(times);
        trace.times.push_back(motion.start() + part * (motion.computed() - motion.start()));
        auto& places = trace.places.emplace_back();
        for (std::size_t b = 0; b < motion.bodies(); ++b) {
            const BodyState state = motion.at(b, trace.times.back());
            places.push_back(Trace::Place{.position = state.position, .attitude = state.attitude});
        }
    }
    return trace;
}

double scaledError(const Problem& problem, const std::vector<std::size_t>& island,
                   const Trace& truth, const Motion& motion) {
    const auto& bodies = *problem.bodies;
    std::map<std::size_t, double> errors;
    std::map<std::size_t, Eigen::AlignedBox3d> boxes;
    for (std::size_t i = 0; i < truth.times.size(); ++i)
        for (std::size_t b = 0; b < bodies.size(); ++b) {
            const auto& place = truth.places[i][b];
            if (bodies[b].isFixed || !place)
                continue;
            const double t = truth.times[i], radius = bodies[b].radius;
            const auto stop = motion.stop(b);
            const bool known =
                t <= (stop ? std::min(stop->time, motion.finish()) : motion.computed());
            const double error =
                known ? positionError(motion.at(b, t), *place, radius) : solution::infinity;
            if (!(error <= errors[island[b]]))
                errors[island[b]] = std::isnan(error) ? solution::infinity : error;
            extend(boxes[island[b]], place->position, radius);
        }
    double largest = 0;
    for (const auto& [group, error] : errors)
        largest = std::max(largest, error / boxes[group].sizes().maxCoeff());
    return largest;
}

} // namespace simulation
