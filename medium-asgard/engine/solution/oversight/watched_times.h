// Could a step have passed over something that none of its stages saw? A push that lasts a moment
// leaves no trace in a long step: its stages see nothing, its error estimate is 0, and a second run
// with smaller errors passes over it as well.
//
// Against this times are watched. From one to the next it is about a 64th of the time since the
// start, and never the same. They depend on the start alone: not on steps, nor on what else moves,
// nor on when motion is to end. Inside long steps of equations that can peak the rates there are
// held against the polynomials that the step left. Where they differ by more than the tolerance,
// the step is refused, and halved until they do not. The short steps of peaking inputs keep their
// readers from long steps: a step crosses few joints of its inputs. No step is longer than all the
// time before it, once it is over 1.
#pragma once

#include <vector>

namespace solution {

class WatchedTimes {
public:
    explicit WatchedTimes(double start) : start_(start) {}

    // From one to the next, on the average, before `t`.
    [[nodiscard]] double spacing(double t) const { return (t - start_) / perTime; }
    // Those in (from, to), in order; of the first step, what is after a small part of it.
    [[nodiscard]] std::vector<double> between(double from, double to) const;
    // How long a step from t may be.
    [[nodiscard]] double longest(double t) const;
    // And where steps themselves are to see what happens.
    [[nodiscard]] double longestThatSees(double t) const;

private:
    static constexpr double perTime = 64;
    double start_;
};

} // namespace solution
