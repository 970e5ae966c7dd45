#include "modes/active_set.h"

#include "complementarity/solve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

using complementarity::State;

namespace {

constexpr double atRest = 1e-12; // of the rates that enter, what counts as none
constexpr double rateOf = 1e-3;  // of a resolution, in the unit of time

double shortest(double t) { return 1e-12 * std::max(1e-6, std::abs(t)); }

} // namespace

ActiveSet::ActiveSet(ModelFunctions& functions, Multipliers& multipliers, Mode& mode)
    : f_(functions), multipliers_(multipliers), mode_(mode) {
    const auto& laws = functions.bound()->laws;
    for (std::size_t row = 0; row < laws.size(); ++row)
        if (laws[row].isBounded())
            bounded_.push_back(row);
}

bool ActiveSet::isStop(std::size_t row) const { return law(row).isStop; }

void ActiveSet::refresh() {
    watches_.clear();
    for (const std::size_t row : bounded_) {
        const BoundModel::Law& of = law(row);
        if (mode_.kept[row] == Mode::gone)
            continue;
        if (mode_.kept[row] == State::inside) {
            if (of.low > -complementarity::unbounded)
                watches_.push_back({row, Kind::least});
            if (of.high < complementarity::unbounded)
                watches_.push_back({row, Kind::most});
        } else if (of.isStop) {
            watches_.push_back({row, Kind::gap});
        } else {
            watches_.push_back(
                {row, mode_.kept[row] == State::low ? Kind::forward : Kind::backward});
        }
    }
}

void ActiveSet::watch(std::span<double> values) {
    if (watches_.empty())
        return;
    multipliers_.evaluateGaps();
    for (std::size_t k = 0; k < watches_.size(); ++k) {
        const auto [row, kind] = watches_[k];
        const double m = multipliers_.values()[row];
        switch (kind) {
        case Kind::gap:
            values[k] = multipliers_.gap(row) + (mode_.touches[row] != 0 ? law(row).resolution : 0);
            break;
        case Kind::least:
            values[k] = m - law(row).low;
            break;
        case Kind::most:
            values[k] = law(row).high - m;
            break;
        case Kind::forward: // others may hold its rate at 0, but for rounding
            values[k] = rateOf * law(row).resolution + multipliers_.rate(row);
            break;
        case Kind::backward:
            values[k] = rateOf * law(row).resolution - multipliers_.rate(row);
            break;
        }
    }
}

// Stops and brakes are open while the conditions without bounds make velocities consistent.
void ActiveSet::decide(double t, std::span<double> y) {
    if (bounded_.empty())
        return;
    std::ranges::fill(mode_.touches, 0);
    for (const std::size_t row : bounded_)
        if (mode_.kept[row] != Mode::gone)
            mode_.kept[row] = State::low;
    multipliers_.project(t, y);
    lastCross_ = t;
    ahead_ = 0;
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    double fastest = 0;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row)
        fastest = std::max(fastest, std::abs(multipliers_.rate(row)));
    std::vector<std::size_t> hit;
    for (const std::size_t row : bounded_)
        if (mode_.kept[row] != Mode::gone && isStop(row) &&
            multipliers_.gap(row) <= law(row).resolution &&
            multipliers_.rate(row) < -atRest * fastest)
            hit.push_back(row);
    if (!hit.empty())
        blow(hit, t, y);
    slip(fastest, t, y);
    (void)settle(hit, fastest, t, y);
    refresh();
}

// At the bound itself the laws have both answers; a little ahead, along the rates that led there,
// they have one. Where that little was too little, it is more the next time.
bool ActiveSet::cross(std::span<const std::size_t> watches, double t, std::span<double> y,
                      std::span<const double> rates) {
    constexpr double part = 1e-6, more = 100; // of the time since the last event
    ahead_ = t > lastCross_ ? part * (t - lastCross_) : std::max(more * ahead_, shortest(t));
    lastCross_ = t;
    std::vector<std::size_t> candidates, hit;
    for (const std::size_t k : watches) {
        candidates.push_back(watches_[k].row);
        if (watches_[k].kind == Kind::gap)
            hit.push_back(watches_[k].row);
    }
    double fastest = 0;
    bool isDone = false;
    if (!hit.empty()) {
        f_.fill(t, y);
        multipliers_.evaluateGaps();
        for (const std::size_t row : hit)
            fastest = std::max(fastest, std::abs(multipliers_.rate(row)));
        blow(hit, t, y);
        slip(fastest, t, y);
        isDone = settle(candidates, fastest, t, y);
    } else {
        std::vector<double> beyond(y.begin(), y.end());
        for (std::size_t i = 0; i < beyond.size(); ++i)
            beyond[i] += ahead_ * rates[i];
        isDone = settle(candidates, fastest, t + ahead_, beyond);
    }
    multipliers_.project(t, y);
    refresh();
    return isDone;
}

complementarity::Laws ActiveSet::lawsOf(std::span<const std::size_t> rows, bool isBlow) const {
    complementarity::Laws laws;
    for (const std::size_t row : rows) {
        const BoundModel::Law& of = law(row);
        if (!of.isBounded())
            complementarity::addEquality(laws);
        else if (isBlow)
            complementarity::addUnilateral(laws);
        else
            complementarity::addInterval(laws, of.low, of.high);
    }
    return laws;
}

// A stop whose rebound would be lower than its resolution takes the blow without one.
void ActiveSet::blow(std::span<const std::size_t> hit, double t, std::span<double> y) {
    std::vector<double> restitutions(mode_.kept.size(), 0);
    for (const std::size_t row : hit)
        restitutions[row] = law(row).restitution;
    const std::vector<double> before(y.begin(), y.end());
    give(hit, restitutions, t, y);
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    bool isAnyLow = false;
    for (const std::size_t row : hit)
        if (const double rate = multipliers_.rate(row);
            restitutions[row] > 0 && rate > 0 && isLow(row, rate)) {
            restitutions[row] = 0;
            isAnyLow = true;
        }
    if (!isAnyLow)
        return;
    std::ranges::copy(before, y.begin());
    give(hit, restitutions, t, y);
}

// Brakes and motors do not hold against a blow: they slip the way that it gives.
void ActiveSet::slip(double fastest, double t, std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    for (const std::size_t row : bounded_)
        if (const double rate = multipliers_.rate(row);
            !isStop(row) && mode_.kept[row] != Mode::gone)
            mode_.kept[row] = std::abs(rate) <= atRest * fastest ? State::inside
                              : rate > 0                         ? State::low
                                                                 : State::high;
}

// With nothing that holds it, it would come back from that height.
bool ActiveSet::isLow(std::size_t row, double rate) {
    (void)multipliers_.solve();
    const double second = multipliers_.secondRate(row);
    return second < 0 && rate * rate / (-2 * second) < law(row).resolution;
}

// Newton's law: of what approaches the rate afterwards is -e times that before, or more.
void ActiveSet::give(std::span<const std::size_t> hit, std::span<const double> restitutions,
                     double t, std::span<double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row) {
        const bool isHeld = mode_.kept[row] == State::inside &&
                            (!law(row).isBounded() ? law(row).isOnSecondRates : isStop(row));
        if (isHeld || std::ranges::find(hit, row) != hit.end())
            rows.push_back(row);
    }
    const auto [a, none] = multipliers_.systemOf(rows);
    Eigen::VectorXd b(static_cast<Eigen::Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double rate = multipliers_.rate(rows[i]);
        const bool isHit = std::ranges::find(hit, rows[i]) != hit.end() && rate < 0;
        b[static_cast<Eigen::Index>(i)] = isHit ? (1 + restitutions[rows[i]]) * rate : rate;
    }
    const auto answer = complementarity::solve(a, b, lawsOf(rows, true));
    if (answer)
        multipliers_.push(rows, answer->forces, y);
}

// It is at its bound without a rate, or holds: the laws on second rates decide.
bool ActiveSet::isCandidate(std::size_t row, double fastest) const {
    if (!law(row).isBounded() || mode_.kept[row] == Mode::gone)
        return false;
    const double none = std::max(rateOf * law(row).resolution, atRest * fastest);
    const bool isSlow = std::abs(multipliers_.rate(row)) <= none;
    return mode_.kept[row] == State::inside ||
           (isSlow && (!isStop(row) || multipliers_.gap(row) <= law(row).resolution));
}

bool ActiveSet::settle(std::span<const std::size_t> fallen, double fastest, double t,
                       std::span<const double> y) {
    f_.fill(t, y);
    multipliers_.evaluateGaps();
    std::vector<std::size_t> rows;
    bool isAny = false;
    for (std::size_t row = 0; row < mode_.kept.size(); ++row) {
        const bool isBounded = law(row).isBounded();
        const bool hasFallen = std::ranges::find(fallen, row) != fallen.end();
        // Rates round with the velocities, however slow the blow was.
        const double none = std::max(rateOf * law(row).resolution, atRest * fastest);
        const bool leaves = isStop(row) && fastest > 0 && multipliers_.rate(row) > none;
        if (isBounded && (leaves || multipliers_.gap(row) > law(row).resolution))
            mode_.touches[row] = 0;
        if (isBounded && leaves && mode_.kept[row] != Mode::gone)
            mode_.kept[row] = State::low;
        else if (hasFallen || isCandidate(row, fastest) ||
                 (!isBounded && law(row).isOnSecondRates && mode_.kept[row] != Mode::gone))
            rows.push_back(row);
        isAny = isAny || (isBounded && !rows.empty() && rows.back() == row);
    }
    if (!isAny)
        return true;
    const auto [a, b] = multipliers_.systemOf(rows);
    const complementarity::Laws laws = lawsOf(rows, false);
    const auto answer = complementarity::solve(a, b, laws);
    if (!answer)
        return false;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (law(rows[i]).isBounded()) {
            const double force = answer->forces[static_cast<Eigen::Index>(i)];
            const bool isNothing = isStop(rows[i]) && force <= law(rows[i]).low;
            mode_.kept[rows[i]] = isNothing ? State::low : answer->states[i];
            mode_.touches[rows[i]] = isNothing ? 1 : 0;
        }
    return true;
}

} // namespace solution
