#include "oversight/peak_centres.h"

#include "dense/first_violation.h"
#include "equations/peaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

namespace solution {

namespace {

// What a few values at even distances say of what lies between them, by parabolas.
struct Course {
    explicit Course(std::span<const double> values) {
        const auto [least, most] = std::ranges::minmax(values);
        double bend = 0;
        for (std::size_t i = 2; i < values.size(); ++i)
            bend = std::max(bend, std::abs(values[i] - 2 * values[i - 1] + values[i - 2]));
        const double low = least > 0 ? least : most < 0 ? -most : 0;
        change = most - least + 0.25 * bend;
        high = std::max(most, -least);
        // Twice what a parabola passes below the lowest of them.
        lowest = std::max(low - 0.25 * bend, 0.0);
        staysAway = lowest > 1e-3 * high;
    }
    double change, lowest, high; // of the size
    bool staysAway;              // from 0
};

// Of causes and rates, those that may be 0 somewhere.
std::vector<std::size_t> suspects(const std::vector<double>& ratios, bool arePolynomials,
                                  const std::function<void(double, std::span<double>)>& evaluate,
                                  double from, double to) {
    const std::size_t causes = ratios.size(), count = arePolynomials ? 3 : 9;
    std::array<std::vector<double>, 9> samples;
    for (std::size_t i = 0; i < count; ++i) {
        const double s = static_cast<double>(i) / static_cast<double>(count - 1);
        samples[i].resize(2 * causes);
        evaluate(i + 1 == count ? to : from + s * (to - from), samples[i]);
    }
    const auto course = [&](std::size_t k) {
        std::array<double, 9> values{};
        for (std::size_t i = 0; i < count; ++i)
            values[i] = samples[i][k];
        return Course(std::span(values).first(count));
    };
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < causes; ++k) {
        const Course value = course(k), rate = course(causes + k);
        if (!value.staysAway)
            found.push_back(k);
        const bool isSeen = ratios[k] > 0 ? value.high <= ratios[k] * value.lowest
                                          : value.change <= std::log(seenPeak);
        if (!rate.staysAway && !isSeen)
            found.push_back(causes + k);
    }
    return found;
}

} // namespace

namespace {

using Evaluate = std::function<void(double, std::span<double>)>;

// Times in (from, to) at which one of `watched` changes its sign, by which one.
std::vector<std::pair<double, std::size_t>> signChanges(const std::vector<std::size_t>& watched,
                                                        std::size_t count, const Evaluate& evaluate,
                                                        double from, double to) {
    constexpr std::size_t most = 64;
    std::vector<std::pair<double, std::size_t>> found;
    if (watched.empty())
        return found;
    std::vector<double> all(count), sides(watched.size());
    evaluate(from, all);
    for (std::size_t k = 0; k < watched.size(); ++k)
        sides[k] = all[watched[k]] < 0 ? -1 : 1;
    const auto besideSides = [&](double t, std::span<double> values) {
        evaluate(t, all);
        for (std::size_t k = 0; k < watched.size(); ++k)
            values[k] = sides[k] * all[watched[k]];
    };
    for (std::size_t i = 0; i < most + watched.size(); ++i) {
        const auto next = firstViolation(watched.size(), besideSides, from, to, Care::some);
        if (!next || next->time >= to)
            return found;
        for (const std::size_t k : next->watches) {
            sides[k] = -sides[k];
            if (next->time > from)
                found.emplace_back(next->time, watched[k]);
        }
        from = next->time;
    }
    return found;
}

// Of what is monotone from `low` to `high`, to the last bit; none where its sign is the same there.
std::optional<double> root(std::size_t k, std::size_t count, const Evaluate& evaluate, double low,
                           double high) {
    std::vector<double> all(count);
    const auto isNegative = [&](double t) {
        evaluate(t, all);
        return all[k] < 0;
    };
    const bool side = isNegative(low);
    if (isNegative(high) == side)
        return std::nullopt;
    for (;;) {
        const double middle = std::midpoint(low, high);
        if (middle <= low || middle >= high)
            return high;
        (isNegative(middle) == side ? low : high) = middle;
    }
}

} // namespace

// Between the roots of its rate a cause has one root at most. Where it touches 0 there, as squares
// do, it would be looked for in vain.
std::vector<double> centresPassed(const std::vector<double>& ratios, bool arePolynomials,
                                  const Evaluate& evaluate, double from, double to) {
    std::vector<std::size_t> values, rates;
    for (const std::size_t k : suspects(ratios, arePolynomials, evaluate, from, to))
        (k < ratios.size() ? values : rates).push_back(k);
    const auto turns = signChanges(rates, 2 * ratios.size(), evaluate, from, to);
    std::vector<double> found;
    found.reserve(turns.size());
    for (const auto& [time, rate] : turns)
        found.push_back(time);
    for (const std::size_t k : values) {
        double low = from;
        const auto take = [&](double high) {
            const auto time = root(k, 2 * ratios.size(), evaluate, low, high);
            if (time && *time > from && *time < to)
                found.push_back(*time);
            low = high;
        };
        for (const auto& [time, rate] : turns)
            if (rate == k + ratios.size())
                take(time);
        take(to);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace solution
