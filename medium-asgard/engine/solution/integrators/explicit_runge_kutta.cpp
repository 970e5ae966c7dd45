#include "integrators/explicit_runge_kutta.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace solution {

namespace {

constexpr double allowed = BetweenEnds::allowed, allowedSpeed = BetweenEnds::allowedSpeed,
                 pessimism = BetweenEnds::pessimism;
const double smallestLogarithm = std::log(1e-4); // of an error that the controller remembers

} // namespace

Tableau finished(Tableau table) {
    for (const std::vector<double>& row : table.a)
        table.rows.push_back(termsOf(row));
    table.errorTerms = termsOf(table.error);
    table.secondErrorTerms = termsOf(table.secondError);
    for (std::size_t power = 0; !table.dense.empty() && power < table.dense[0].size(); ++power) {
        std::vector<double> weights;
        for (const std::vector<double>& stage : table.dense)
            weights.push_back(stage[power]);
        table.denseTerms.push_back(termsOf(weights));
    }
    for (std::size_t stage = 0; stage < table.dense.size(); ++stage)
        if (std::ranges::any_of(table.dense[stage], [](double weight) { return weight != 0; }))
            table.denseStages.push_back(stage);
    return table;
}

ExplicitRungeKutta::ExplicitRungeKutta(const Tableau& tableau, System& system,
                                       ErrorControl& control, bool fixed)
    : Method(system, control, fixed), tableau_(tableau), size_(system.size()),
      stages_(stagesFor(size_)), direct_(DirectStep::of(tableau, size_)),
      k_(tableau.a.size() * size_), at_(size_), stiffAt_(size_), sum_(size_) {
    for (std::vector<double>* const values :
         {&lost_.start, &lost_.end, &controller_.error, &controller_.secondError, &before_.state,
          &before_.slope})
        values->resize(size_);
    start_.resize(size_);
    end_.resize(size_);
    slope_.resize(size_);
    std::vector<char> isPaired(size_, 0);
    for (const auto& [x, v] : system.integrals())
        isPaired[x] = isPaired[v] = 1;
    for (std::size_t n = 0; n < size_; ++n)
        if (!isPaired[n])
            unpaired_.push_back(n);
}

bool ExplicitRungeKutta::begin(double t, std::span<const double> y) {
    t_ = t;
    h_ = 0;
    start_.assign(y.begin(), y.end());
    controller_.previousLogarithm = smallestLogarithm;
    controller_.isAfterRejection = false;
    stabilityUsed_ = before_.step = 0;
    std::fill(lost_.start.begin(), lost_.start.end(), 0.0);
    return rates(t, y, slope_);
}

namespace {

// out = start + h * sum, by twos: a pair that was just summed is not taken apart.
template <std::size_t Size>
inline void addTo(const double* start, double h, const double* sum, std::size_t size, double* out) {
    const std::size_t count = Size == 0 ? size : Size;
    const Pair both = {h, h};
    for (std::size_t n = 0; n + 1 < count; n += 2)
        put(out + n, pairAt(start + n) + both * pairAt(sum + n));
    if (count % 2 == 1)
        out[count - 1] = start[count - 1] + h * sum[count - 1];
}

} // namespace

// The increment is summed before it is added, and what that addition rounds away at the end of a
// step is added to the next increment (Kahan): far from the origin a position keeps its last bits.
template <std::size_t Size> bool ExplicitRungeKutta::stage(std::size_t i, double* at) {
    const std::size_t size = Size == 0 ? size_ : Size;
    double* const sum = sum_.data();
    if (Size == 0 && i != tableau_.stages) {
        advanceMany(tableau_.rows[i], k_.data(), size, start_.data(), h_, at);
    } else {
        weightedSumOf<Size>(tableau_.rows[i], k_.data(), size, sum);
        if (i == tableau_.stages)
            finishStages(size);
        else
            addTo<Size>(start_.data(), h_, sum, size, at);
    }
    return rates(t_ + tableau_.c[i] * h_, {at, size}, {k_.data() + i * size, size});
}

void ExplicitRungeKutta::finishStages(std::size_t size) {
    for (std::size_t n = 0; n < size; ++n) {
        const double increment = h_ * sum_[n] + lost_.start[n];
        end_[n] = start_[n] + increment;
        lost_.end[n] = increment - (end_[n] - start_[n]);
    }
}

template <std::size_t Size> bool ExplicitRungeKutta::makeStages() {
    double* const given = system_.place();
    double* const at = given ? given : at_.data();
    for (std::size_t i = 1; i < tableau_.stages; ++i)
        if (!stage<Size>(i, i == tableau_.stiffStage ? stiffAt_.data() : at))
            return false;
    return stage<Size>(tableau_.stages, end_.data());
}

ExplicitRungeKutta::Stages ExplicitRungeKutta::stagesFor(std::size_t size) {
    constexpr std::size_t most = 16; // larger ones gain nothing
    return [size]<std::size_t... Size>(std::index_sequence<Size...>) {
        const std::array<Stages, most + 1> all = {&ExplicitRungeKutta::makeStages<Size>...};
        return all[size <= most ? size : 0];
    }
    (std::make_index_sequence<most + 1>());
}

// None: there are no direct ones.
std::optional<bool> ExplicitRungeKutta::makeDirectly(DirectStep::Make make) {
    const System::Direct rates = make ? system_.direct() : System::Direct{};
    if (!rates.code.entry)
        return std::nullopt;
    const DirectStep::Made made = make({.t = t_,
                                        .h = h_,
                                        .start = start_.data(),
                                        .lost = lost_.start.data(),
                                        .end = end_.data(),
                                        .lostNext = lost_.end.data(),
                                        .stiffAt = stiffAt_.data(),
                                        .slopes = k_.data()},
                                       rates);
    counts_.evaluations += made.evaluations;
    return !made.failed;
}

bool ExplicitRungeKutta::makeAllStages() {
    const auto made = makeDirectly(direct_.stages);
    return made ? *made : (this->*stages_)();
}

// Those of dense output.
bool ExplicitRungeKutta::makeStagesBeyond() {
    if (const auto made = makeDirectly(direct_.extension))
        return *made;
    for (std::size_t i = tableau_.stages + 1; i < tableau_.a.size(); ++i)
        if (!stage<0>(i, at_.data()))
            return false;
    return true;
}

Attempt ExplicitRungeKutta::attempt(double h) {
    h_ = h;
    std::copy(slope_.begin(), slope_.end(), k_.begin());
    if (!makeAllStages()) {
        controller_.isAfterRejection = true;
        return {Attempt::Outcome::notFinite, 0.25 * h};
    }
    if (fixed_)
        return {Attempt::Outcome::accepted, h};
    control_.prepare(end_, h);
    const Attempt attempt = judge(errorNorm());
    if (attempt.outcome == Attempt::Outcome::accepted)
        estimateStiffness();
    return attempt;
}

double ExplicitRungeKutta::errorNorm() {
    if (direct_.errors) {
        direct_.errors(h_, k_.data(), controller_.error.data());
        return control_.norm(controller_.error);
    }
    weightedSum(tableau_.errorTerms, k_.data(), size_, controller_.error.data());
    if (!tableau_.secondErrorTerms.empty()) {
        weightedSum(tableau_.secondErrorTerms, k_.data(), size_, controller_.secondError.data());
        for (std::size_t n = 0; n < size_; ++n) {
            const double square = controller_.error[n] * controller_.error[n];
            const double both =
                square + 0.01 * controller_.secondError[n] * controller_.secondError[n];
            if (both > 0)
                controller_.error[n] = square / std::sqrt(both);
        }
    }
    for (double& error : controller_.error)
        error *= h_;
    return control_.norm(controller_.error);
}

Attempt ExplicitRungeKutta::judge(double error) {
    const double p = static_cast<double>(tableau_.order);
    const double logarithm = std::log(std::max(error, 1e-10));
    if (!(error <= 1)) {
        controller_.isAfterRejection = true;
        const double factor = std::isfinite(error) ? 0.9 * std::exp(-logarithm / p) : 0.2;
        return {Attempt::Outcome::errorTooLarge, h_ * std::clamp(factor, 0.2, 0.9)};
    }
    double factor = 0.9 * std::exp((0.4 * controller_.previousLogarithm - 0.7 * logarithm) / p);
    factor = std::clamp(factor, 0.2, controller_.isAfterRejection ? 1.0 : 6.0);
    controller_.previousLogarithm = std::max(logarithm, smallestLogarithm);
    controller_.isAfterRejection = false;
    return {Attempt::Outcome::accepted, h_ * factor};
}

void ExplicitRungeKutta::estimateStiffness() {
    stabilityUsed_ = 0;
    if (tableau_.stabilityLimit == 0)
        return;
    double dk = 0, dy = 0;
    const double *last = slopesOf(tableau_.stages), *before = slopesOf(tableau_.stiffStage);
    for (std::size_t n = 0; n < size_; ++n) {
        const double inverse = 1 / control_.scale(n);
        const double k = (last[n] - before[n]) * inverse;
        const double y = (end_[n] - stiffAt_[n]) * inverse;
        dk += k * k;
        dy += y * y;
    }
    if (dy > 0)
        stabilityUsed_ = h_ * std::sqrt(dk / dy) / tableau_.stabilityLimit;
}

StepEnds ExplicitRungeKutta::ends() {
    return {.h = h_,
            .start = start_,
            .end = end_,
            .startSlope = slope_,
            .endSlope = {slopesOf(tableau_.stages), size_}};
}

// What the polynomials of both ends miss shows in their slopes at inner stages. With u = s(1-s),
//
//     quintic of p:  p - P = c u^3,   so that p' - P' is at most 0.0537 c/h, and p'' - P'' at the
//                    inner stages, where u'' is, at least 0.284 c/h^2;  u^3 at most 1/64
//     cubic of y:    y - C = c u^2,   y' - C' at 6/7 is 0.175 c/h;  u^2 at most 1/16
//
// An inner stage is itself less accurate than the step, which makes the guess a cautious one.
bool ExplicitRungeKutta::endsSuffice(std::span<const Coefficients> columns) {
    constexpr double place = 1.0 / 64 / 0.284, speed = 0.0537 / 0.284, other = 1.0 / 16 / 0.175;
    for (const std::size_t i : tableau_.checkStages) {
        const double s = tableau_.c[i], *slope = slopesOf(i);
        for (const auto& [x, v] : system_.integrals()) {
            const double missed =
                std::abs(evaluateDerivative({columns[v].data(), 5}, s) - h_ * slope[v]);
            if (!(place * h_ * missed <= allowed * control_.scale(x) &&
                  speed * missed <= allowedSpeed * control_.scale(v)))
                return false;
        }
        for (const std::size_t n : unpaired_) {
            const double missed =
                std::abs(evaluateDerivative({columns[n].data(), 4}, s) - h_ * slope[n]);
            if (!(other * missed <= allowed * control_.scale(n)))
                return false;
        }
    }
    return true;
}

// False: a stage of the extension is not finite.
bool ExplicitRungeKutta::extend(std::span<Coefficients> columns) {
    if (!makeStagesBeyond())
        return false;
    for (std::size_t n = 0; n < size_; ++n)
        columns[n] = {start_[n]};
    if (direct_.dense)
        direct_.dense(h_, k_.data(), tableau_, columns.data());
    for (std::size_t power = 0; !direct_.dense && power < tableau_.denseTerms.size(); ++power) {
        weightedSum(tableau_.denseTerms[power], k_.data(), size_, sum_.data());
        for (std::size_t n = 0; n < size_; ++n)
            columns[n][power + 1] = h_ * sum_[n];
    }
    integratePositions(columns, system_.integrals(), ends());
    for (const auto& [x, v] : system_.integrals())
        if (ownEndMoves(columns[x], columns[v], h_) <= BetweenEnds::ownEnd * control_.scale(v))
            differentiate(columns[x], columns[v], h_);
    return true;
}

void ExplicitRungeKutta::dense(std::span<Coefficients> columns) {
    const bool extensible = !tableau_.dense.empty();
    const bool needsStages = tableau_.a.size() > tableau_.stages + 1;
    if (extensible && (!needsStages || fixed_) && extend(columns))
        return;
    if (!extensible) {
        cubics(columns, ends());
        integratePositions(columns, system_.integrals(), ends());
        return;
    }
    cubics(columns, ends(), unpaired_);
    quintics(columns, system_.integrals(), ends());
    if (!needsStages || fixed_ || correct(columns) || endsSuffice(columns) || extend(columns))
        return;
    cubics(columns, ends(), unpaired_);
    quintics(columns, system_.integrals(), ends());
}

// By the start of the step before, where that is needed; false: it does not suffice.
bool ExplicitRungeKutta::correct(std::span<Coefficients> columns) {
    const StepBefore before{before_.step / h_, before_.state, before_.slope};
    if (!usable(before))
        return false;
    const auto within = [this](double value, std::size_t n, double part) {
        return value <= part * control_.scale(n);
    };
    const CorrectionBasis basis = correctionBasis(before.ratio);
    bool needed = false;
    corrections_.resize(system_.integrals().size() + unpaired_.size());
    auto made = corrections_.begin();
    for (const auto& [x, v] : system_.integrals()) {
        const Correction& c = *made++ = quinticCorrection(
            columns[x], before_.state[x], h_ * before_.state[v], h_ * h_ * before_.slope[v], basis);
        if (!within(c.left, x, pessimism * allowed) ||
            !within(c.leftSlope / h_, v, pessimism * allowedSpeed))
            return false;
        needed =
            needed || !within(c.whole, x, allowed) || !within(c.wholeSlope / h_, v, allowedSpeed);
    }
    for (const std::size_t n : unpaired_) {
        const Correction& c = *made++ =
            cubicCorrection(columns[n], before_.state[n], h_ * before_.slope[n], basis);
        if (!within(c.left, n, allowed))
            return false;
        needed = needed || !within(c.whole, n, allowed);
    }
    if (!needed)
        return true;
    auto correction = corrections_.begin();
    for (const auto& [x, v] : system_.integrals()) {
        addToQuintic(columns[x], *correction++, before.ratio);
        differentiate(columns[x], columns[v], h_);
    }
    for (const std::size_t n : unpaired_)
        addToCubic(columns[n], *correction++, before.ratio);
    return true;
}

bool ExplicitRungeKutta::proceed(std::span<const double> y) {
    t_ += h_;
    const double* last = slopesOf(tableau_.stages);
    std::swap(before_.state, start_);
    std::swap(before_.slope, slope_);
    before_.step = h_;
    bool same = true;
    for (std::size_t n = 0; n < size_; ++n) {
        const bool kept = y[n] == end_[n];
        same = same && kept;
        lost_.start[n] = kept ? lost_.end[n] : 0;
        start_[n] = y[n];
        slope_[n] = last[n];
    }
    return same || rates(t_, y, slope_);
}

} // namespace solution
