#include "batches/alike_steps.h"

#include "dense/histories.h"

#include <algorithm>
#include <cmath>
#include <limits>

#if defined(__x86_64__)

// All that follows up to the pop is called on processors that have AVX, and nowhere else.
#pragma GCC push_options
#pragma GCC target("avx")

#include "batches/lanes.h"
#include "dense/dense_formulas.h"

namespace solution::lanes {

// As formulas::decay(), which looks for it here.
ASGARD_LANES Wide decay(const Wide& first, const Wide& third) {
    return chosen(first > third, sqrt(third / first), Wide(1));
}

} // namespace solution::lanes

namespace solution {
namespace {

using lanes::Mask, lanes::Wide;
using Rows = AlikeSteps::Rows;

// The rows of both blocks.
struct View {
    double *first, *second;
    [[nodiscard]] Wide operator[](std::size_t row) const {
        return {_mm256_loadu_pd(first + lanes::ofBlock * row),
                _mm256_loadu_pd(second + lanes::ofBlock * row)};
    }
    void put(std::size_t row, const Wide& x) const {
        _mm256_storeu_pd(first + lanes::ofBlock * row, x.a);
        _mm256_storeu_pd(second + lanes::ofBlock * row, x.b);
    }
};

View viewOf(std::vector<double>& data) { return {data.data(), data.data() + data.size() / 2}; }

Wide sumOf(const View& at, const Terms& terms, std::size_t slopes, std::size_t size) {
    Wide sum = 0;
    for (const Term& term : terms)
        sum += Wide(term.weight) * at[slopes + term.stage * size];
    return sum;
}

// The arguments of a stage within the step.
void argue(const View& at, const Rows& rows, const Tableau& table, std::size_t stage,
           std::size_t size) {
    const Wide h = at[rows.step];
    at.put(rows.in, at[rows.time] + table.c[stage] * h);
    for (std::size_t n = 0; n < size; ++n) {
        const Wide sum = sumOf(at, table.rows[stage], rows.slopes + n, size);
        const Wide y = at[rows.start + n] + h * sum;
        at.put(rows.in + 1 + n, y);
        if (stage == table.stiffStage)
            at.put(rows.stiffAt + n, y);
    }
}

// Those of the stage at its end; what rounding loses there is kept.
void argueAtEnd(const View& at, const Rows& rows, const Tableau& table, std::size_t size) {
    const Wide h = at[rows.step];
    at.put(rows.in, at[rows.time] + table.c[table.stages] * h);
    for (std::size_t n = 0; n < size; ++n) {
        const Wide sum = sumOf(at, table.rows[table.stages], rows.slopes + n, size);
        const Wide start = at[rows.start + n], increment = h * sum + at[rows.lost + n];
        const Wide end = start + increment;
        at.put(rows.in + 1 + n, end);
        at.put(rows.end + n, end);
        at.put(rows.lostNext + n, increment - (end - start));
    }
}

void begin(const View& at, const Rows& rows, std::size_t size) {
    for (std::size_t n = 0; n < size; ++n)
        at.put(rows.slopes + n, at[rows.slope + n]);
}

// All rates are finite, and the end is not too large.
unsigned isOrdinary(const View& at, const Rows& rows, std::size_t stages, std::size_t size) {
    Wide zero = 0;
    for (std::size_t i = size; i < (stages + 1) * size; ++i)
        zero += 0 * at[rows.slopes + i];
    Mask ordinary = zero == 0;
    for (std::size_t n = 0; n < size; ++n)
        ordinary = ordinary & (abs(at[rows.end + n]) <= largestValue);
    return ordinary.bits();
}

// ErrorControl::measure() of the end.
void measure(const View& at, const Rows& rows, std::span<const UnknownScale::Kind> kinds) {
    Wide extent = at[rows.leastExtent], speed = 0, other = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Wide y = at[rows.end + i], length = at[rows.length + i];
        const Wide low = min(at[rows.low + i], y), high = max(at[rows.high + i], y);
        at.put(rows.newLow + i, low);
        at.put(rows.newHigh + i, high);
        if (kinds[i] == UnknownScale::Kind::position)
            extent = max(extent, length * (high - low));
        else if (kinds[i] == UnknownScale::Kind::velocity)
            speed = max(speed, length * max(high, -low));
        else
            other = max(max(other, high), -low);
    }
    at.put(rows.extent, extent);
    at.put(rows.speed, speed);
    at.put(rows.other, other);
}

// ErrorControl::prepare().
void prepare(const View& at, const Rows& rows, std::span<const UnknownScale::Kind> kinds) {
    constexpr double rounding = ErrorControl::units * std::numeric_limits<double>::epsilon();
    measure(at, rows, kinds);
    const Wide tolerance = at[rows.tolerance], extent = at[rows.extent];
    Wide coarsest = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i] == UnknownScale::Kind::position)
            coarsest = max(coarsest, rounding * abs(at[rows.end + i]) * at[rows.length + i]);
    at.put(rows.rounding, coarsest / ErrorControl::units);
    const Wide place = tolerance * extent, speed = tolerance * at[rows.speed];
    const Wide unseen = max(0.01 * tolerance * extent, coarsest) /
                        max(at[rows.step], std::numeric_limits<double>::min());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const Wide y = abs(at[rows.end + i]), length = at[rows.length + i];
        Wide weight = max(rounding * y, 1e-280);
        if (kinds[i] == UnknownScale::Kind::position)
            weight = max(weight, place / length);
        else if (kinds[i] == UnknownScale::Kind::velocity)
            weight = max(max(weight, speed / length), unseen / length);
        else {
            weight = max(max(weight, tolerance * at[rows.high + i]), -tolerance * at[rows.low + i]);
            weight = max(max(weight, tolerance * y), tolerance * 1e-3 * at[rows.other]);
            weight = max(weight, chosen(length > 0, unseen / length, Wide(0)));
        }
        at.put(rows.weights + i, weight);
    }
}

// ExplicitRungeKutta::errorNorm(); the answer are lanes in which it is a number.
unsigned findError(const View& at, const Rows& rows, const Tableau& table, std::size_t size) {
    const Wide h = at[rows.step];
    Wide largest = 0;
    Mask isNumber = largest == 0;
    for (std::size_t n = 0; n < size; ++n) {
        Wide error = sumOf(at, table.errorTerms, rows.slopes + n, size);
        if (!table.secondErrorTerms.empty()) {
            const Wide second = sumOf(at, table.secondErrorTerms, rows.slopes + n, size);
            const Wide square = error * error;
            const Wide both = square + 0.01 * second * second;
            error = chosen(both > 0, square / sqrt(both), error);
        }
        const Wide e = abs(error * h) / at[rows.weights + n];
        largest = chosen(e <= largest, largest, e);
        isNumber = isNumber & (e == e);
    }
    at.put(rows.error, largest);
    return isNumber.bits();
}

void estimateStiffness(const View& at, const Rows& rows, const Tableau& table, std::size_t size) {
    Wide dk = 0, dy = 0;
    const std::size_t last = rows.slopes + table.stages * size,
                      before = rows.slopes + table.stiffStage * size;
    for (std::size_t n = 0; n < size; ++n) {
        const Wide inverse = 1 / at[rows.weights + n];
        const Wide k = (at[last + n] - at[before + n]) * inverse;
        const Wide y = (at[rows.end + n] - at[rows.stiffAt + n]) * inverse;
        dk += k * k;
        dy += y * y;
    }
    const Wide used = at[rows.step] * sqrt(dk / dy) / table.stabilityLimit;
    at.put(rows.stability, chosen(dy > 0, used, Wide(0)));
}

using Column = formulas::Column<Wide>;

Column columnAt(const View& at, std::size_t row) {
    Column column{};
    for (std::size_t k = 0; k < maximumCoefficients; ++k)
        column[k] = at[row + k];
    return column;
}

void put(const View& at, std::size_t row, const Column& column) {
    for (std::size_t k = 0; k < maximumCoefficients; ++k)
        at.put(row + k, column[k]);
}

// Of each lane: what its polynomials miss is small enough with corrections; they are needed.
struct Verdict {
    Mask fits, needs;
    void add(const Wide& left, const Wide& most, const Wide& whole, const Wide& enough) {
        fits = fits & (left <= most);
        needs = needs | !(whole <= enough);
    }
};

// What all unknowns of a step's polynomials have in common.
struct Between {
    Wide h;
    CorrectionBasisOf<Wide> basis;
    std::size_t slopesAtEnd;
};

// A place and its velocity by their ends, and what the start of the step before adds to that.
void join(const View& at, const Rows& rows, const Between& step,
          const std::pair<std::size_t, std::size_t>& pair, Verdict& verdict) {
    const auto [x, v] = pair;
    const Wide& h = step.h;
    const formulas::Ends<Wide> ends = {at[rows.start + v], at[rows.end + v], at[rows.slope + v],
                                       at[step.slopesAtEnd + v]};
    const Column place = formulas::quintic(at[rows.start + x], at[rows.end + x], ends, h);
    Column velocity{};
    velocity[0] = ends.start;
    formulas::differentiate(place, velocity, h);
    put(at, rows.columns + maximumCoefficients * x, place);
    put(at, rows.columns + maximumCoefficients * v, velocity);
    const auto c =
        formulas::quinticCorrection<Wide>(place, at[rows.before + x], h * at[rows.before + v],
                                          h * h * at[rows.beforeSlope + v], step.basis);
    for (std::size_t k = 0; k < 3; ++k)
        at.put(rows.corrections + 3 * x + k, c.terms[k]);
    const Wide length = at[rows.weights + x], speed = at[rows.weights + v];
    verdict.add(c.left, BetweenEnds::pessimism * BetweenEnds::allowed * length, c.whole,
                BetweenEnds::allowed * length);
    verdict.add(c.leftSlope / h, BetweenEnds::pessimism * BetweenEnds::allowedSpeed * speed,
                c.wholeSlope / h, BetweenEnds::allowedSpeed * speed);
}

void join(const View& at, const Rows& rows, const Between& step, std::size_t n, Verdict& verdict) {
    const Wide& h = step.h;
    const formulas::Ends<Wide> ends = {at[rows.start + n], at[rows.end + n], at[rows.slope + n],
                                       at[step.slopesAtEnd + n]};
    const Column column = formulas::cubic(ends, h);
    put(at, rows.columns + maximumCoefficients * n, column);
    const auto c = formulas::cubicCorrection<Wide>(column, at[rows.before + n],
                                                   h * at[rows.beforeSlope + n], step.basis);
    for (std::size_t k = 0; k < 3; ++k)
        at.put(rows.corrections + 3 * n + k, c.terms[k]);
    const Wide most = BetweenEnds::allowed * at[rows.weights + n];
    verdict.add(c.left, most, c.whole, most);
}

CorrectionOf<Wide> correctionAt(const View& at, const Rows& rows, std::size_t n) {
    CorrectionOf<Wide> c{};
    for (std::size_t k = 0; k < 3; ++k)
        c.terms[k] = at[rows.corrections + 3 * n + k];
    return c;
}

void put(const View& at, std::size_t row, const Mask& where, const Column& column) {
    for (std::size_t k = 0; k < maximumCoefficients; ++k)
        at.put(row + k, chosen(where, column[k], at[row + k]));
}

void correct(const View& at, const Rows& rows, const Between& step,
             const std::pair<std::size_t, std::size_t>& pair, const Mask& where) {
    const std::size_t x = rows.columns + maximumCoefficients * pair.first,
                      v = rows.columns + maximumCoefficients * pair.second;
    Column place = columnAt(at, x), velocity = columnAt(at, v);
    formulas::addToQuintic(place, correctionAt(at, rows, pair.first), step.basis.ratio);
    formulas::differentiate(place, velocity, step.h);
    put(at, x, where, place);
    put(at, v, where, velocity);
}

void correct(const View& at, const Rows& rows, const Between& step, std::size_t n,
             const Mask& where) {
    const std::size_t row = rows.columns + maximumCoefficients * n;
    Column column = columnAt(at, row);
    formulas::addToCubic(column, correctionAt(at, rows, n), step.basis.ratio);
    put(at, row, where, column);
}

// Polynomials of those steps that their ends, with the start of the step before, say enough of:
// these lanes are the answer.
unsigned makePolynomials(const View& at, const Rows& rows, std::size_t slopesAtEnd,
                         std::span<const std::pair<std::size_t, std::size_t>> integrals,
                         std::span<const std::size_t> unpaired) {
    const Wide h = at[rows.step], ratio = at[rows.beforeStep] / h;
    const Between step{h, formulas::correctionBasis(ratio), slopesAtEnd};
    Verdict verdict{(ratio >= leastRatio) & (ratio <= largestRatio), ratio < ratio};
    for (const auto& pair : integrals)
        join(at, rows, step, pair, verdict);
    for (const std::size_t n : unpaired)
        join(at, rows, step, n, verdict);
    const Mask corrected = verdict.fits & verdict.needs;
    if (corrected.bits() != 0) {
        for (const auto& pair : integrals)
            correct(at, rows, step, pair, corrected);
        for (const std::size_t n : unpaired)
            correct(at, rows, step, n, corrected);
    }
    return verdict.fits.bits();
}

// What has been a step's end is the next one's start, where it was accepted.
void goOn(const View& at, const Rows& rows, std::size_t slopesAtEnd, std::size_t size) {
    const Mask accepted = at[rows.accepted] == 1;
    const auto take = [&](std::size_t to, std::size_t from) {
        at.put(to, chosen(accepted, at[from], at[to]));
    };
    at.put(rows.time, chosen(accepted, at[rows.time] + at[rows.step], at[rows.time]));
    take(rows.beforeStep, rows.step);
    for (std::size_t n = 0; n < size; ++n) {
        take(rows.before + n, rows.start + n);
        take(rows.beforeSlope + n, rows.slope + n);
        take(rows.start + n, rows.end + n);
        take(rows.slope + n, slopesAtEnd + n);
        take(rows.lost + n, rows.lostNext + n);
        take(rows.low + n, rows.newLow + n);
        take(rows.high + n, rows.newHigh + n);
    }
}

} // namespace
} // namespace solution

#pragma GCC pop_options

namespace solution {

bool AlikeSteps::areThere() {
    static const bool are =
        __builtin_cpu_supports("avx") != 0 && expression::Function::lanes() == block;
    return are;
}

AlikeSteps::Lanes AlikeSteps::attempt(std::span<const double, lanes> h) {
    const View view = viewOf(data_);
    for (std::size_t lane = 0; lane < lanes; ++lane)
        at(rows_.step, lane) = h[lane];
    begin(view, rows_, size_);
    for (std::size_t stage = 1; stage < tableau_.stages; ++stage) {
        argue(view, rows_, tableau_, stage, size_);
        evaluate(stage);
    }
    argueAtEnd(view, rows_, tableau_, size_);
    evaluate(tableau_.stages);
    Lanes ordinary = isOrdinary(view, rows_, tableau_.stages, size_);
    prepare(view, rows_, kinds_);
    ordinary &= findError(view, rows_, tableau_, size_);
    estimateStiffness(view, rows_, tableau_, size_);
    return ordinary;
}

void AlikeSteps::dense(Lanes accepted) {
    const std::size_t last = rows_.slopes + tableau_.stages * size_;
    alone_ = accepted & ~makePolynomials(viewOf(data_), rows_, last, integrals_, unpaired_);
    for (std::size_t lane = 0; lane < lanes; ++lane)
        if (alone_ & of(lane))
            denseAlone(lane);
}

void AlikeSteps::proceed(Lanes accepted) {
    for (std::size_t lane = 0; lane < lanes; ++lane)
        at(rows_.accepted, lane) = accepted & of(lane) ? 1 : 0;
    goOn(viewOf(data_), rows_, rows_.slopes + tableau_.stages * size_, size_);
}

} // namespace solution

#else // LIMIT: elsewhere each system steps alone.

namespace solution {
bool AlikeSteps::areThere() { return false; }
AlikeSteps::Lanes AlikeSteps::attempt(std::span<const double, lanes> /*h*/) { return 0; }
void AlikeSteps::dense(Lanes /*accepted*/) {}
void AlikeSteps::proceed(Lanes /*accepted*/) {}
} // namespace solution

#endif
