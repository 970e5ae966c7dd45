#include "dense/piece_writer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace solution {

namespace {

// By how much values change when the time changes by its last places: what their formulas lose to
// rounding, however small the values are. `valuesAt` puts them into `values`.
template <typename ValuesAt>
std::vector<double> roughness(std::span<const double> times, const ValuesAt& valuesAt,
                              const std::vector<double>& values) {
    constexpr int places = 4;
    std::vector<double> found(values.size()), here;
    for (const double time : times) {
        if (!valuesAt(time))
            continue;
        here.assign(values.begin(), values.end());
        double beside = time;
        for (int i = 0; i < places; ++i) {
            beside = std::nextafter(beside, infinity);
            if (!valuesAt(beside))
                break;
            for (std::size_t k = 0; k < found.size(); ++k)
                found[k] = std::max(found[k], std::abs(values[k] - here[k]));
        }
    }
    return found;
}

struct Stretch {
    double origin, length;
};

// Do the curves, of (t - origin)/length, follow the values at these times but for what is allowed,
// or for what is rough about the values themselves?
template <typename ValuesAt>
bool follow(std::span<const Coefficients> curves, std::span<const double> allowed,
            std::span<const double> times, Stretch stretch, const ValuesAt& valuesAt,
            const std::vector<double>& values) {
    constexpr double interpolated = 4;        // what interpolation makes of roughness
    std::vector<double> wrong(curves.size()); // by more than is allowed
    for (const double t : times) {
        if (!valuesAt(t))
            return false;
        for (std::size_t k = 0; k < curves.size(); ++k) {
            const double s = (t - stretch.origin) / stretch.length;
            const double difference = std::abs(evaluate(curves[k], s) - values[k]);
            if (!(difference <= allowed[k]))
                wrong[k] = std::max(wrong[k], difference);
        }
    }
    if (std::ranges::count(wrong, 0.0) == std::ssize(wrong))
        return true;
    const std::vector<double> rough = roughness(times, valuesAt, values);
    for (std::size_t k = 0; k < curves.size(); ++k)
        if (!(wrong[k] <= interpolated * rough[k]))
            return false;
    return true;
}

} // namespace

void PieceWriter::takeLayout(std::span<const std::size_t> states, std::span<const std::size_t> held,
                             std::span<const std::pair<std::size_t, std::size_t>> integrals) {
    states_.assign(states.begin(), states.end());
    held_.assign(held.begin(), held.end());
    pairs_.clear();
    for (const auto& [x, v] : integrals)
        pairs_.emplace_back(states_[x], states_[v]);
    if (!pairs_.empty() && !history_->takePairs(pairs_))
        pairs_.clear();
    std::vector<char> isOther(unknowns_, 1);
    places_.clear();
    for (const auto& [place, velocity] : pairs_) {
        places_.push_back(place);
        isOther[place] = isOther[velocity] = 0;
    }
    all_.clear();
    others_.clear();
    for (std::size_t n = 0; n < unknowns_; ++n) {
        all_.push_back(n);
        if (isOther[n])
            others_.push_back(n);
    }
}

void PieceWriter::hold(std::span<const std::size_t> unknowns, std::span<const double> values) {
    constant_.assign(unknowns.begin(), unknowns.end());
    constants_.assign(values.size(), Coefficients{});
    for (std::size_t i = 0; i < values.size(); ++i)
        constants_[i][0] = values[i];
}

void PieceWriter::append(const StateCurves& states, HeldValues& values, double allowed) {
    history_->dropAnchor();
    appendPart(states, values, allowed, 0);
}

void PieceWriter::append(const StateCurves& states, std::span<const Coefficients> held) {
    history_->dropAnchor();
    appendRow(states, held);
}

void PieceWriter::standAt(double t, std::span<const double> valuesAndRates) {
    history_->dropAnchor();
    history_->append({t, t, 1, true, 2}, valuesAndRates);
}

void PieceWriter::append(const History::Step& step, std::span<const double> row) {
    history_->append(step, row);
    isFresh_ = false;
}

void PieceWriter::appendPart(const StateCurves& states, HeldValues& values, double allowed,
                             int depth) {
    constexpr int deepest = 10;
    if (held_.empty()) {
        appendRow(states, {});
        return;
    }
    const auto [columns, origin, scale, until] = states;
    std::vector<Coefficients> held(held_.size());
    if (!fit(states, values, allowed, held) && depth < deepest) {
        const double middle = origin + 0.5 * (until - origin);
        appendPart({columns, origin, scale, middle}, values, allowed, depth + 1);
        std::vector<Coefficients> second;
        for (const Coefficients& column : columns)
            second.push_back(reparametrize(column, (middle - origin) / scale, 1));
        appendPart({second, middle, scale, until}, values, allowed, depth + 1);
        return;
    }
    if (until - origin != scale) { // one scale for all
        std::vector<Coefficients> rescaled;
        for (const Coefficients& column : columns)
            rescaled.push_back(reparametrize(column, 0, (until - origin) / scale));
        appendRow({rescaled, origin, until - origin, until}, held);
        return;
    }
    appendRow(states, held);
}

bool PieceWriter::fit(const StateCurves& states, HeldValues& values, double allowed,
                      std::span<Coefficients> held) {
    const auto& points = interpolationPoints();
    std::vector<double> y(states.columns.size()), out(held.size());
    std::vector<std::array<double, maximumCoefficients>> samples(held.size());
    const auto valuesAt = [&](double t) {
        states.at(t, y);
        return values.valuesAt(t, y, out);
    };
    const double origin = states.origin, until = states.until, length = until - origin;
    const double latest = std::max(std::abs(origin), std::abs(until));
    const double late = 16 * std::numeric_limits<double>::epsilon() * latest / length;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!valuesAt(p == maximumDegree ? until : origin + points[p] * length))
            return false;
        for (std::size_t k = 0; k < held.size(); ++k)
            samples[k][p] = out[k];
    }
    std::vector<double> errors;
    for (std::size_t k = 0; k < held.size(); ++k) {
        held[k] = interpolate(samples[k]);
        const auto [low, high] = std::ranges::minmax(samples[k]);
        const double size = std::max(std::abs(low), std::abs(high)), spanned = high - low;
        errors.push_back(std::max({allowed * spanned, late * spanned, 1e-13 * size}));
    }
    std::vector<double> checks = values.peaksOn(states);
    for (const double s : {0.13, 0.31, 0.6, 0.93})
        checks.push_back(origin + s * length);
    return follow(held, errors, checks, {origin, length}, valuesAt, out);
}

// The number of coefficients that all these columns need.
std::uint8_t PieceWriter::lengthOf(std::span<const std::size_t> columns, std::size_t least) const {
    std::size_t count = least;
    for (const std::size_t column : columns)
        for (std::size_t k = maximumDegree; k >= count; --k)
            if ((*kept_[column])[k] != 0) {
                count = k + 1;
                break;
            }
    return static_cast<std::uint8_t>(count);
}

bool PieceWriter::tellVelocities(double scale) const {
    return std::ranges::all_of(pairs_, [&](const auto& pair) {
        return History::tells(*kept_[pair.first], *kept_[pair.second], scale);
    });
}

void PieceWriter::appendRow(const StateCurves& states, std::span<const Coefficients> held) {
    kept_.resize(unknowns_);
    for (std::size_t i = 0; i < constant_.size(); ++i)
        kept_[constant_[i]] = &constants_[i];
    for (std::size_t i = 0; i < states.columns.size(); ++i)
        kept_[states_[i]] = &states.columns[i];
    for (std::size_t i = 0; i < held.size(); ++i)
        kept_[held_[i]] = &held[i];
    History::Step step{
        .origin = states.origin, .until = states.until, .scale = states.scale, .fresh = isFresh_};
    if (!pairs_.empty() && tellVelocities(states.scale)) {
        step.coefficients = lengthOf(places_, 2);
        step.others = lengthOf(others_, 1);
    } else {
        step.coefficients = lengthOf(all_, 1);
    }
    history_->append(step, kept_);
    isFresh_ = false;
}

} // namespace solution
