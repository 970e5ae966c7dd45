// How a component's steps become pieces of its history; see component.h.
#include "solution/component.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// What values change by when the time changes by its last places: what their formulas lose to
// rounding, however small they are themselves. `valuesAt` puts them into `values`.
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

void Component::append(std::span<const Coefficients> states, double scale, double until) {
    history_->dropAnchor();
    appendPart(states, time_, scale, until, 0);
}

// Held values follow the states by polynomials of their own; where one does not fit, the step is
// kept in halves.
void Component::appendPart(std::span<const Coefficients> states, double origin, double scale,
                           double until, int depth) {
    constexpr int deepest = 10;
    if (equations_->held().empty()) {
        appendRow(states, {}, origin, scale, until);
        return;
    }
    std::vector<Coefficients> held(equations_->held().size());
    if (!held.empty() && !fitHeld(states, origin, scale, until, heldPart, held) &&
        depth < deepest) {
        const double middle = origin + 0.5 * (until - origin);
        appendPart(states, origin, scale, middle, depth + 1);
        std::vector<Coefficients> second;
        for (const Coefficients& column : states)
            second.push_back(reparametrize(column, (middle - origin) / scale, 1));
        appendPart(second, middle, scale, until, depth + 1);
        return;
    }
    if (!held.empty() && until - origin != scale) { // one scale for all
        std::vector<Coefficients> rescaled;
        for (const Coefficients& column : states)
            rescaled.push_back(reparametrize(column, 0, (until - origin) / scale));
        appendRow(rescaled, held, origin, until - origin, until);
        return;
    }
    appendRow(states, held, origin, scale, until);
}

// Polynomials of (t - origin)/(until - origin). False: they do not fit, by more than this part of
// the tolerance of what they span, and by more than rounding, of time too, makes of them.
bool Component::fitHeld(std::span<const Coefficients> states, double origin, double scale,
                        double until, double part, std::span<Coefficients> held) {
    const auto& points = interpolationPoints();
    std::vector<double> y(states.size()), out(held.size());
    std::vector<std::array<double, maximumCoefficients>> samples(held.size());
    const auto valuesAt = [&](double t) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = evaluate(states[i], (t - origin) / scale);
        return equations_->heldValues(t, y, out);
    };
    const double length = until - origin;
    const double latest = std::max(std::abs(origin), std::abs(until));
    const double late = 16 * std::numeric_limits<double>::epsilon() * latest / length;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (!valuesAt(p == maximumDegree ? until : origin + points[p] * length))
            return false;
        for (std::size_t k = 0; k < held.size(); ++k)
            samples[k][p] = out[k];
    }
    std::vector<double> allowed;
    for (std::size_t k = 0; k < held.size(); ++k) {
        held[k] = interpolate(samples[k]);
        const auto [low, high] = std::ranges::minmax(samples[k]);
        const double size = std::max(std::abs(low), std::abs(high)), spanned = high - low;
        allowed.push_back(std::max({part * tolerance_ * spanned, late * spanned, 1e-13 * size}));
    }
    std::vector<double> checks = centresIn(states, origin, scale, until);
    for (const double s : {0.13, 0.31, 0.6, 0.93})
        checks.push_back(origin + s * length);
    return follow(held, allowed, checks, {origin, length}, valuesAt, out);
}

// Which columns are places whose velocities are here too, and which are neither.
void Component::findPairs() {
    pairs_.clear();
    for (const auto& [x, v] : equations_->integrals())
        pairs_.emplace_back(equations_->states()[x], equations_->states()[v]);
    if (!pairs_.empty() && !history_->takePairs(pairs_))
        pairs_.clear();
    std::vector<char> isOther(unknowns_.size(), 1);
    places_.clear();
    for (const auto& [place, velocity] : pairs_) {
        places_.push_back(place);
        isOther[place] = isOther[velocity] = 0;
    }
    all_.clear();
    others_.clear();
    for (std::size_t n = 0; n < unknowns_.size(); ++n) {
        all_.push_back(n);
        if (isOther[n])
            others_.push_back(n);
    }
}

// The number of coefficients that all these columns need.
std::uint8_t Component::lengthOf(std::span<const std::size_t> columns, std::size_t least) const {
    std::size_t count = least;
    for (const std::size_t column : columns)
        for (std::size_t k = maximumDegree; k >= count; --k)
            if ((*kept_[column])[k] != 0) {
                count = k + 1;
                break;
            }
    return static_cast<std::uint8_t>(count);
}

bool Component::tellVelocities(double scale) const {
    return std::ranges::all_of(pairs_, [&](const auto& pair) {
        return History::tells(*kept_[pair.first], *kept_[pair.second], scale);
    });
}

void Component::appendRow(std::span<const Coefficients> states, std::span<const Coefficients> held,
                          double origin, double scale, double until) {
    kept_.resize(unknowns_.size());
    for (std::size_t i = 0; i < states.size(); ++i)
        kept_[equations_->states()[i]] = &states[i];
    for (std::size_t i = 0; i < held.size(); ++i)
        kept_[equations_->held()[i]] = &held[i];
    History::Step step{.origin = origin, .until = until, .scale = scale, .fresh = fresh_};
    if (!pairs_.empty() && tellVelocities(scale)) {
        step.coefficients = lengthOf(places_, 2);
        step.others = lengthOf(others_, 1);
    } else {
        step.coefficients = lengthOf(all_, 1);
    }
    history_->append(step, kept_);
    fresh_ = false;
}

} // namespace solution
