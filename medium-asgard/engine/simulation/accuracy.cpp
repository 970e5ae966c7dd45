#include "simulation/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace simulation {
namespace {

constexpr std::size_t spacedTimes = 64, stepTimes = 2000;

// Where an error can peak: at the ends of the body's own steps, and between them, thinned when
// there are many. Equally spaced times where there are few.
std::vector<double> timesOf(const Problem& problem, const BodyRecord& body,
                            const solution::Histories& histories, double until) {
    std::vector<double> times;
    const double start = problem.start();
    std::vector<const solution::History*> seen;
    for (const std::size_t kind : {physics::x, physics::y, physics::z, physics::qw}) {
        const std::size_t unknown = body.firstUnknown + kind;
        const solution::History* steps = histories.place(unknown, start).history;
        if (std::ranges::find(seen, steps) != seen.end())
            continue;
        seen.push_back(steps);
        double t = start;
        for (std::size_t i = 0; t < until && i < 50 * stepTimes; ++i) {
            const double next = histories.piece(unknown, t).until;
            if (!(next > t) || next > until)
                break;
            times.push_back(i % 2 == 0 ? next : t + (next - t) / 2);
            t = next;
        }
    }
    const std::size_t stride = times.size() / stepTimes + 1;
    for (std::size_t i = 1; stride > 1 && i * stride < times.size(); ++i)
        times[i] = times[i * stride];
    times.resize((times.size() + stride - 1) / stride);
    if (times.size() < spacedTimes)
        for (std::size_t i = 0; i < spacedTimes; ++i)
            times.push_back(start + (until - start) * static_cast<double>(i) / spacedTimes);
    times.push_back(until);
    std::ranges::sort(times);
    return times;
}

// Places of one body at times in order.
class PlaceReader {
public:
    PlaceReader(const BodyRecord& body, const solution::Histories& histories)
        : body_(body), histories_(histories) {}

    Trace::Place at(double t) {
        Trace::Place place;
        for (std::size_t i = 0; i < 3; ++i)
            place.position[static_cast<Eigen::Index>(i)] = value(i, body_.firstUnknown + i, t);
        const std::size_t q = body_.firstUnknown + physics::qw;
        place.attitude =
            Quaternion(value(3, q, t), value(4, q + 1, t), value(5, q + 2, t), value(6, q + 3, t))
                .normalized();
        return place;
    }

private:
    double value(std::size_t i, std::size_t unknown, double t) {
        const auto [history, column] = histories_.place(unknown, t);
        if (history->empty())
            return histories_.value(unknown, t);
        step_[i] = history->find(t, step_[i]);
        return history->piece(step_[i], column).value(t);
    }

    const BodyRecord& body_;
    const solution::Histories& histories_;
    std::array<std::size_t, 7> step_{};
};

double positionError(const Trace::Place& state, const Trace::Place& truth, double radius) {
    const double angle =
        state.attitude && truth.attitude ? state.attitude->angularDistance(*truth.attitude) : 0;
    return std::max((state.position - truth.position).norm(), angle * radius);
}

void extend(Eigen::AlignedBox3d& box, const Vector& position, double radius) {
    box.extend(Vector(position - Vector::Constant(radius)));
    box.extend(Vector(position + Vector::Constant(radius)));
}

// In order of time, those that exceed all before by a tenth.
void keepRecords(std::vector<std::pair<double, double>>& growth) {
    std::ranges::sort(growth);
    double largest = 0;
    std::erase_if(growth, [&](const auto& sample) {
        if (sample.second <= 1.1 * largest)
            return true;
        largest = std::isnan(sample.second) ? solution::infinity : sample.second;
        return false;
    });
}

// Calls visit(time, place in the first run, place in the second) where a body is compared.
template <typename Visit>
void compareBody(const Problem& problem, std::size_t b, const Run& first, const Run& second,
                 const Visit& visit) {
    const BodyRecord& body = (*problem.bodies)[b];
    const double until = std::min({problem.finish(), knownUntil(body, *first.histories),
                                   knownUntil(body, *second.histories)});
    PlaceReader before(body, *first.histories), after(body, *second.histories);
    for (const double t : timesOf(problem, body, *second.histories, until))
        visit(t, before.at(t), after.at(t));
}

} // namespace

double IslandError::beyondFrom(double limit) const {
    for (const auto& [time, error] : growth)
        if (!(error <= limit))
            return time;
    return solution::infinity;
}

std::vector<IslandError> compareRuns(const Problem& problem, const Run& first, const Run& second,
                                     double limit, const std::function<bool()>& cancelled) {
    const auto& bodies = *problem.bodies;
    std::vector<IslandError> errors(bodies.size(),
                                    {.size = 0, .far = 0, .largest = 0, .growth = {}});
    std::vector<Eigen::AlignedBox3d> boxes(bodies.size()); // by island, as errors
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (b % 16 == 15 && cancelled && cancelled())
            return errors;
        if (bodies[b].isFixed)
            continue;
        const std::size_t island = second.island[b];
        double& largest = errors[island].largest;
        compareBody(problem, b, first, second,
                    [&](double, const Trace::Place& place, const Trace::Place& truth) {
                        const double error = positionError(place, truth, bodies[b].radius);
                        if (!(error <= largest))
                            largest = std::isnan(error) ? solution::infinity : error;
                        extend(boxes[island], truth.position, bodies[b].radius);
                    });
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!boxes[i].isEmpty()) {
            errors[i].size = boxes[i].sizes().maxCoeff();
            errors[i].far = std::max(boxes[i].min().cwiseAbs().maxCoeff(),
                                     boxes[i].max().cwiseAbs().maxCoeff());
            errors[i].largest /= errors[i].size;
        }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].isFixed || !(errors[second.island[b]].largest > limit))
            continue;
        IslandError& error = errors[second.island[b]];
        compareBody(problem, b, first, second,
                    [&](double t, const Trace::Place& place, const Trace::Place& truth) {
                        error.growth.emplace_back(t, positionError(place, truth, bodies[b].radius) /
                                                         error.size);
                    });
    }
    for (IslandError& error : errors)
        keepRecords(error.growth);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (!bodies[b].isFixed)
            errors[b] = errors[second.island[b]];
    return errors;
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
            double error = solution::infinity;
            if (known) {
                const BodyState state = motion.at(b, t);
                error = positionError({.position = state.position, .attitude = state.attitude},
                                      *place, radius);
            }
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
