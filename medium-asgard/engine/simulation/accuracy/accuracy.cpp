#include "accuracy/accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace simulation {
namespace {

constexpr std::size_t spacedTimes = 64, stepTimes = 2000;
// Of a motion that stops: there it runs into what no accuracy resolves, and the stop says so.
constexpr double lastPart = 0.01;
constexpr double earlyPart = 0.25; // of the time

// Asks now and then whether somebody cancelled.
class Poll {
public:
    explicit Poll(const std::function<bool()>& cancelled) : cancelled_(cancelled) {}
    [[nodiscard]] bool isCancelled() {
        if (++done_ >= comparisonsPerPoll) {
            done_ = 0;
            isCancelled_ = isCancelled_ || (cancelled_ && cancelled_());
        }
        return isCancelled_;
    }

private:
    const std::function<bool()>& cancelled_;
    std::size_t done_ = 0;
    bool isCancelled_ = false;
};

// The places of one body at times in order. Unknowns of one component share their steps, and what
// never changes, which is most of a planar motion, is read once.
class PlaceReader {
public:
    static constexpr std::array<std::size_t, 7> kinds = {
        physics::x,      physics::y,      physics::z,     physics::qw,
        physics::qw + 1, physics::qw + 2, physics::qw + 3};

    PlaceReader(const BodyRecord& body, const solution::Histories& histories, double from)
        : body_(body), histories_(histories) {
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const std::size_t unknown = body.firstUnknown + kinds[i];
            const auto [history, column] = histories.place(unknown, from);
            values_[i] = histories.value(unknown, from);
            if (history->empty() || !histories.isInOnePlace(unknown))
                others_.push_back({.kind = i, .steps = {}}); // it has, or had, several components
            else if (history->size() > 1 || history->step(0).coefficients > 1)
                columns_.push_back({.kind = i, .steps = stepsOf(history), .column = column});
            else
                continue;
            turns_ = turns_ || i >= 3;
        }
    }

    [[nodiscard]] Trace::Place at(double t) {
        for (const Column& column : columns_) {
            Steps& steps = steps_[column.steps];
            if (steps.t != t)
                steps.goTo(t);
            values_[column.kind] = steps.value(column.column);
        }
        for (Other& other : others_)
            values_[other.kind] = valueOf(other, t);
        Trace::Place place;
        place.position = {values_[0], values_[1], values_[2]};
        if (tellsAttitude)
            place.attitude =
                Quaternion(values_[3], values_[4], values_[5], values_[6]).normalized();
        return place;
    }

    [[nodiscard]] bool turns() const { return turns_; }
    bool tellsAttitude = true;

    // Where an error can peak: at the ends of the body's own steps, and between them, thinned when
    // there are many. Equally spaced times where there are few.
    [[nodiscard]] std::vector<double> times(double from, double until, Poll& poll);
    // The most that one component had of those that times() looked at.
    [[nodiscard]] std::size_t steps() const { return most_; }

private:
    struct Steps {
        const solution::History* history = nullptr;
        std::size_t step = 0;                                       // that was read last
        double t = std::numeric_limits<double>::quiet_NaN(), s = 0; // then
        solution::History::Reading reading = {};

        void goTo(double time) {
            t = time;
            step = history->find(t, step);
            reading = history->reading(step);
            s = (t - reading.step().origin) / reading.step().scale;
        }
        [[nodiscard]] double value(std::size_t column) const { return reading.value(column, s); }
    };
    struct Column {
        std::size_t kind, steps, column;
    };
    struct Other {
        std::size_t kind;
        Steps steps; // that were read last
    };
    // Several may be in one history, and need only be looked up once.
    [[nodiscard]] double valueOf(Other& other, double t) {
        const std::size_t unknown = body_.firstUnknown + kinds[other.kind];
        const auto [history, column] = histories_.place(unknown, t);
        if (history->empty()) // what was before goes on
            return histories_.value(unknown, t);
        for (const Other& read : others_)
            if (read.steps.history == history && read.steps.t == t)
                return read.steps.value(column);
        if (other.steps.history != history)
            other.steps = {.history = history};
        other.steps.goTo(t);
        return other.steps.value(column);
    }
    std::size_t stepsOf(const solution::History* history) {
        const auto known = std::ranges::find(steps_, history, &Steps::history);
        if (known == steps_.end()) {
            steps_.push_back({.history = history});
            return steps_.size() - 1;
        }
        return static_cast<std::size_t>(known - steps_.begin());
    }
    void addTimes(std::size_t unknown, double from, double until, Poll& poll,
                  std::vector<double>& times) const;

    const BodyRecord& body_;
    const solution::Histories& histories_;
    std::array<double, 7> values_{}; // at the time asked for last
    std::vector<Steps> steps_;
    std::vector<Column> columns_;
    std::vector<Other> others_;
    std::size_t most_ = 0;
    bool turns_ = false; // else its attitude is the same all the time
};

// Ends and middles of steps in turn.
void PlaceReader::addTimes(std::size_t unknown, double from, double until, Poll& poll,
                           std::vector<double>& times) const {
    const solution::History* history = nullptr;
    std::size_t step = 0;
    bool isEnd = true, stays = false; // in that history
    for (double t = from; t < until && !poll.isCancelled(); isEnd = !isEnd) {
        const bool isNext = stays && step + 2 < history->size() && history->origin(step + 1) <= t &&
                            t < history->origin(step + 2);
        if (isNext) {
            ++step;
        } else {
            const solution::History* const here = histories_.place(unknown, t).history;
            if (!here)
                return;
            step = here->find(t, here == history ? step : 0);
            history = here;
            stays = histories_.staysInPlace(unknown, t);
        }
        double next = history->empty() ? solution::infinity : history->until(step);
        if (next > until) // or until it goes on in another component
            next = histories_.piece(unknown, t).until;
        if (!(next > t) || next > until)
            return;
        times.push_back(isEnd ? next : t + (next - t) / 2);
        t = next;
    }
}

std::vector<double> PlaceReader::times(double from, double until, Poll& poll) {
    std::vector<double> times;
    std::vector<const solution::History*> seen;
    for (const std::size_t kind : {physics::x, physics::y, physics::z, physics::qw}) {
        const std::size_t unknown = body_.firstUnknown + kind;
        const solution::History* steps = histories_.place(unknown, from).history;
        if (std::ranges::find(seen, steps) != seen.end())
            continue;
        seen.push_back(steps);
        const std::size_t known = times.size();
        addTimes(unknown, from, until, poll, times);
        most_ = std::max(most_, times.size() - known);
    }
    const std::size_t stride = (times.size() / stepTimes + 1) | 1; // ends and middles in turn
    for (std::size_t i = 1; stride > 1 && i * stride < times.size(); ++i)
        times[i] = times[i * stride];
    times.resize((times.size() + stride - 1) / stride);
    if (times.size() < spacedTimes)
        for (std::size_t i = 0; i < spacedTimes; ++i)
            times.push_back(from + (until - from) * static_cast<double>(i) / spacedTimes);
    times.push_back(until);
    std::ranges::sort(times);
    return times;
}

double positionError(const Trace::Place& state, const Trace::Place& truth, const BodyRecord& body) {
    double error = (state.position - truth.position).norm();
    if (!state.attitude || !truth.attitude)
        return error;
    error = std::max(error, body.radius * state.attitude->angularDistance(*truth.attitude));
    if (body.arms.empty())
        return error;
    const Quaternion turned = truth.attitude->conjugate() * *state.attitude;
    for (const Vector& arm : body.arms)
        error = std::max(error, (turned * arm - arm).norm());
    return error;
}

bool isElsewhere(const Trace::Place& place, const Trace::Place& start) {
    return place.position != start.position ||
           (place.attitude && start.attitude &&
            place.attitude->coeffs() != start.attitude->coeffs());
}

void raise(double& largest, double error) {
    if (!(error <= largest))
        largest = std::isnan(error) ? solution::infinity : error;
}

void extend(Eigen::AlignedBox3d& box, const Vector& position, double radius) {
    box.extend(Vector(position - Vector::Constant(radius)));
    box.extend(Vector(position + Vector::Constant(radius)));
}

// The growth of one body's error: those that exceed all before. (What does not exceed all before of
// its own body does not do so among all bodies.)
class Records {
public:
    explicit Records(std::vector<std::pair<double, double>>& growth) : growth_(growth) {}
    void add(double t, double error) {
        if (error <= largest_)
            return;
        largest_ = std::isnan(error) ? solution::infinity : error;
        growth_.emplace_back(t, error);
    }

private:
    std::vector<std::pair<double, double>>& growth_;
    double largest_ = 0;
};

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

// Taken from the first run: there is nothing to compare.
bool isSame(const Run& second, std::size_t body) {
    return !second.isTaken.empty() && second.isTaken[body];
}

// The end of the time over which both runs know the motion, and over which it is compared.
double comparedUntil(const Problem& problem, std::size_t b, const Run& first, const Run& second) {
    const BodyRecord& body = (*problem.bodies)[b];
    const double until = std::min({problem.finish(), knownUntil(body, *first.histories),
                                   knownUntil(body, *second.histories)});
    const bool isCut = first.stops.contains(b) || second.stops.contains(b);
    return isCut ? until - lastPart * (until - problem.start()) : until;
}

// Calls visit(time, place in the first run, place in the second) where a body is compared. Answers
// how many steps the second run has of it.
template <typename Visit>
std::size_t compareBody(const Problem& problem, std::size_t b, const Run& first, const Run& second,
                        Poll& poll, const Visit& visit) {
    const BodyRecord& body = (*problem.bodies)[b];
    const double from = problem.start();
    const double until = comparedUntil(problem, b, first, second);
    PlaceReader before(body, *first.histories, from);
    PlaceReader after(body, *second.histories, from);
    // What turns in neither run has the attitude of the start in both.
    before.tellsAttitude = after.tellsAttitude = before.turns() || after.turns();
    for (const double t : after.times(from, until, poll)) {
        if (poll.isCancelled())
            break;
        visit(t, before.at(t), after.at(t));
    }
    return after.steps();
}

// How far an unknown goes. Steps may be as long as a swing or a flight: each is halved until its
// bounds say that it goes no farther than is known, but for a hundredth of that or of `least`.
class Extent {
public:
    Extent(double value, double least) : low_(value), high_(value), least_(least) {}

    void add(const solution::Piece& piece, double from, double to) {
        add(piece.value(to));
        widen(piece, from, to, 12);
    }
    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

private:
    void add(double value) {
        low_ = std::min(low_, value);
        high_ = std::max(high_, value);
    }
    void widen(const solution::Piece& piece, double from, double to, int halvings) {
        const auto [low, high] = piece.bounds(from, to);
        const double room = 0.01 * std::max(high_ - low_, least_);
        if ((low >= low_ - room && high <= high_ + room) || halvings == 0)
            return;
        const double middle = from + (to - from) / 2;
        add(piece.value(middle));
        widen(piece, from, middle, halvings - 1);
        widen(piece, middle, to, halvings - 1);
    }

    double low_, high_, least_;
};

// Bounding sphere included.
Eigen::AlignedBox3d boxOf(const BodyRecord& body, const solution::Histories& histories, double from,
                          double until, Poll& poll) {
    Eigen::AlignedBox3d box;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const std::size_t unknown = body.firstUnknown + physics::x + static_cast<std::size_t>(axis);
        Extent extent(histories.value(unknown, from), body.radius);
        for (double t = from; t < until && !poll.isCancelled();) {
            const solution::Piece piece = histories.piece(unknown, t);
            const double end = std::min(piece.until, until);
            if (!(end > t))
                break;
            extent.add(piece, t, end);
            t = end;
        }
        box.min()[axis] = extent.low() - body.radius;
        box.max()[axis] = extent.high() + body.radius;
    }
    return box;
}

// Error control, or arithmetic, ended the motion of the body.
bool endsByIntegration(const BodyRecord& body, const solution::Histories& histories) {
    using enum solution::Stop::Reason;
    for (std::size_t i = 0; i < physics::bodyUnknowns; ++i)
        if (const auto* stop = histories.stop(body.firstUnknown + i))
            if (stop->reason == stepUnderflow || stop->reason == notConverged ||
                stop->reason == overflow || stop->reason == notFinite)
                return true;
    return false;
}

// One run ends by integration where the other goes on: one of them is wrong from there on, or
// before, however near they were. When.
std::optional<double> partsAtAnEnd(const Problem& problem, std::size_t b, const Run& first,
                                   const Run& second) {
    const BodyRecord& body = (*problem.bodies)[b];
    if (!endsByIntegration(body, *first.histories) && !endsByIntegration(body, *second.histories))
        return std::nullopt;
    const auto [earlier, later] =
        std::minmax({std::min(problem.finish(), knownUntil(body, *first.histories)),
                     std::min(problem.finish(), knownUntil(body, *second.histories))});
    if (later - earlier <= lastPart * (later - problem.start()))
        return std::nullopt;
    return earlier;
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
    const double earlyUntil = problem.start() + earlyPart * (problem.finish() - problem.start());
    Poll poll(cancelled);
    std::vector<IslandError> errors(
        bodies.size(),
        {.size = 0, .far = 0, .largest = 0, .early = 0, .growth = {}, .moves = false});
    std::vector<Eigen::AlignedBox3d> boxes(bodies.size()); // by island, as errors
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (poll.isCancelled())
            return errors;
        if (bodies[b].isFixed || isSame(second, b))
            continue;
        const std::size_t island = second.island[b];
        double &largest = errors[island].largest, &early = errors[island].early;
        std::optional<Trace::Place> start;
        const std::size_t steps =
            compareBody(problem, b, first, second, poll,
                        [&](double t, const Trace::Place& place, const Trace::Place& truth) {
                            const double error = positionError(place, truth, bodies[b]);
                            if (!start)
                                start = truth;
                            errors[island].moves = errors[island].moves ||
                                                   isElsewhere(place, *start) ||
                                                   isElsewhere(truth, *start);
                            raise(largest, error);
                            if (t <= earlyUntil)
                                raise(early, error);
                        });
        boxes[island].extend(boxOf(bodies[b], *second.histories, problem.start(),
                                   comparedUntil(problem, b, first, second), poll));
        errors[island].steps = std::max(errors[island].steps, steps);
    }
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!boxes[i].isEmpty()) {
            errors[i].size = boxes[i].sizes().maxCoeff();
            errors[i].far = std::max(boxes[i].min().cwiseAbs().maxCoeff(),
                                     boxes[i].max().cwiseAbs().maxCoeff());
            errors[i].largest /= errors[i].size;
            errors[i].early /= errors[i].size;
        }
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].isFixed || isSame(second, b))
            continue;
        IslandError& error = errors[second.island[b]];
        if (const auto end = partsAtAnEnd(problem, b, first, second)) {
            error.largest = std::max(error.largest, 1.0);
            error.growth.emplace_back(*end, 1);
        }
        if (!(error.largest > limit))
            continue;
        Records records(error.growth);
        (void)compareBody(problem, b, first, second, poll,
                          [&](double t, const Trace::Place& place, const Trace::Place& truth) {
                              records.add(t, positionError(place, truth, bodies[b]) / error.size);
                          });
        if (poll.isCancelled())
            return errors;
    }
    for (IslandError& error : errors)
        keepRecords(error.growth);
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (!bodies[b].isFixed && !isSame(second, b))
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
                                      *place, bodies[b]);
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
