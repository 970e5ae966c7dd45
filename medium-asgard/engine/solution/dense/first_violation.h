// When does one of several functions of time first fall below 0?
//
// Watches are functions that are at least 0 while something holds, as the branches of switching
// expressions do. They are followed on the dense output of a step; the first to fall ends the step.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace solution {

struct Violation {
    double time = 0;
    std::vector<std::size_t> watches; // those that are no longer above 0 at `time`
};

// The first time in [from, to] at which a watch falls to 0 or below, to the last bit: it is above 0
// at the double before. A watch that starts at or below 0 (by rounding, after an event) is followed
// from where it rises above; if it only falls, the violation is at `from`.
//
// On pieces of the interval, cut where a watch has fallen, or else halved, until a polynomial of
// degree 8 agrees with the watches, its Bernstein form isolates the first root. A polynomial
// through nine values needs four more for that check, and none where the one through five of them
// foretells the other four; of five that lie on one through three of them the four are not asked
// for. False position on that watch itself, after Illinois, with bisection
// where it gets on slowly, finishes: a dozen values of this one watch.
//
// A graze: a watch that starts at 0, rises for less than the samples see and falls is followed to
// the end of that rise, down to a 2^-40th of the interval.
//
// LIMIT: in a piece too short to be halved, or with no pieces left, a watch whose polynomial is a
// thousandth of its size above 0 at the first root of another counts as later, though no check has
// shown that polynomial right.
//
// LIMIT: a watch that falls below 0 and rises again between samples that a polynomial of degree 8
// explains otherwise is not seen; nor is a touch, nor surely what needs more pieces than 500, or
// 50,000 with great care. A kink, as that of hypot(x, 0), is followed down to a 2^-24th of the
// interval.
enum class Care {
    some, // 500 pieces, and no touch is followed to its minimum: what is sought shows elsewhere too
    great
};
using Watches = std::function<void(double t, std::span<double> values)>;
using OneWatch = std::function<std::optional<double>(double t, std::size_t watch)>;
// `one`: the value of one watch, where that costs less than all of them; none: it does not.
[[nodiscard]] std::optional<Violation> firstViolation(std::size_t watches, const Watches& evaluate,
                                                      double from, double to,
                                                      Care care = Care::great,
                                                      const OneWatch& one = {});

} // namespace solution
