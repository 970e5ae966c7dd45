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
//
// A peak is narrow, but its argument is not: exp(-((t-60)/0.01)^2) is largest where its exponent
// is, and a step that passes over that changes the sign of the exponent's rate. So signs of such
// centres are watched too, in every step, and the rates are asked for where one is 0, and beside
// it, where what is odd about it peaks.
//
// LIMIT: high powers that are built of low ones, by squaring squares, are not seen to peak: a term
// that acts by one for less than a 25th of the time since the start, from its beginning to its end,
// can lie between two watched times.
#pragma once

#include "expression/graph.h"

#include <functional>
#include <span>
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

// May these expressions be next to nothing nearly everywhere, and large in one place? Sums,
// products, sines, roots and switches, which are watched by themselves, may not; exponentials,
// quotients and other powers may. Denominators that read attitudes alone are their lengths, which
// stay 1. Where the `values` of the constants are given, a quotient whose denominator stays within
// eight times of its least, whatever all other symbols are, may not peak either: 2 - cos(x)^2.
[[nodiscard]] bool canPeak(const expression::Graph& graph,
                           std::span<const expression::Node> outputs,
                           std::span<const expression::Node> constants,
                           std::span<const expression::Node> attitudes,
                           std::span<const double> values = {});

// A symbol that changes in time, and the symbol of its rate; of the time itself, 1.
struct Moving {
    expression::Node symbol, rate;
};

// Where these expressions may peak, however narrow the peak: where the cause of the peak (an
// exponent, a denominator) is least or most, which is where its rate is 0, or is 0 itself (a pole,
// an edge: tanh((x-700)/w)).
struct Peaks {
    struct Cause { // of time, states, inputs and constants
        expression::Node value;
        expression::Node rate; // of what moves it, too
        double ratio; // to which it must change for a peak to hide; 0: it is an exponent, infinite:
                      // only its own 0 counts, not that of its rate
    };
    std::vector<Cause> causes;
    std::vector<expression::Node> heights; // what peaks
    bool arePolynomials = true;            // the causes, of what moves
};
[[nodiscard]] Peaks peaksOf(expression::Graph& graph, std::span<const expression::Node> outputs,
                            std::span<const expression::Node> constants,
                            std::span<const expression::Node> attitudes,
                            std::span<const Moving> moving);

// Times in (from, to), in order, at which a cause or its rate is 0. `evaluate` gives the values of
// all causes, then their rates. The sign of a tiny rate means nothing, so a zero of a rate counts
// only where the cause changes enough to make its peak 16 times as large within the step as at the
// step's ends.
[[nodiscard]] std::vector<double>
centresPassed(const std::vector<double>& ratios, bool arePolynomials,
              const std::function<void(double t, std::span<double> values)>& evaluate, double from,
              double to);

} // namespace solution
