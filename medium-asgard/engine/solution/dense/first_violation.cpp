#include "dense/first_violation.h"

#include "dense/polynomial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>

namespace solution {

namespace {

using Samples = std::array<double, maximumCoefficients>;

// Between the points of interpolation, where it is worst.
constexpr double checkPoints[] = {0.09, 0.405, 0.595, 0.91};
constexpr int deepest = 24;
constexpr int shortPiece = 8; // the depth from which a watch far above 0 may jump
constexpr int mostPieces = 500, mostSearches = 100;

// Every other point of interpolation; and, by point, what each of these counts in the polynomial
// through them.
constexpr std::array<std::size_t, 5> halfOfPoints = {0, 2, 4, 6, 8};
using Weights = std::array<std::array<double, halfOfPoints.size()>, maximumCoefficients>;
Weights weightsOfHalf() {
    const auto& points = interpolationPoints();
    Weights weights{};
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t k = 0; k < halfOfPoints.size(); ++k) {
            weights[i][k] = 1;
            for (std::size_t other = 0; other < halfOfPoints.size(); ++other)
                if (other != k)
                    weights[i][k] *= (points[i] - points[halfOfPoints[other]]) /
                                     (points[halfOfPoints[k]] - points[halfOfPoints[other]]);
        }
    return weights;
}

// Values of all watches at the times that were asked for last: many are asked for again, as those
// at the ends of a piece for each watch that is sought between them.
class Recent {
public:
    Recent(std::size_t watches, const Watches& evaluate) : evaluate_(evaluate) {
        for (Values& values : last_)
            values.second.resize(watches);
    }
    [[nodiscard]] const std::vector<double>* find(double t) {
        const auto found = std::ranges::find(last_, t, &Values::first);
        if (found == last_.end())
            return nullptr;
        std::rotate(last_.begin(), found, found + 1);
        return &last_.front().second;
    }
    [[nodiscard]] const std::vector<double>& at(double t) {
        if (const auto* const known = find(t))
            return *known;
        std::rotate(last_.begin(), last_.end() - 1, last_.end());
        last_.front().first = t;
        evaluate_(t, last_.front().second);
        return last_.front().second;
    }

private:
    using Values = std::pair<double, std::vector<double>>;
    static constexpr Values none = {std::numeric_limits<double>::quiet_NaN(), {}};
    const Watches& evaluate_;
    std::array<Values, 8> last_ = {none, none, none, none, none, none, none, none};
};

class Search {
public:
    enum class Next { none, another }; // search, from where this one runs out of pieces
    Search(std::size_t watches, const Watches& evaluate, const OneWatch& one, double from,
           Search::Next next, Care care)
        : recent_(watches, evaluate), one_(one), samples_(watches), from_(from), next_(next),
          care_(care) {}

    // Where the search ended for lack of pieces; what is later is left to the next one.
    [[nodiscard]] std::optional<double> unsearchedFrom() const { return unsearched_; }

    std::optional<Violation> in(double a, double b, int depth) {
        if (unsearched_)
            return std::nullopt;
        if (budget_ <= 0 && a > from_ && next_ == Next::another) {
            unsearched_ = a;
            return std::nullopt;
        }
        sample(a, b);
        if (a == from_)
            if (Violation violation = atStart(); !violation.watches.empty()) {
                const auto bump =
                    depth < deepest ? endOfBump(violation.watches, a, b) : std::nullopt;
                if (!bump)
                    return violation;
                const auto found = in(a, bump->time, depth + 1);
                return found ? found : bump;
            }
        if (depth < deepest && budget_ > 0 && (!explained(a, b, depth) || almostTouches())) {
            if (const auto fallen = fallenAt(a, b))
                return in(a, *fallen, depth + 1);
            const double middle = a + 0.5 * (b - a);
            if (auto found = in(a, middle, depth + 1))
                return found;
            return in(middle, b, depth + 1);
        }
        if (auto found = refine(a, b))
            return found;
        return depth == deepest && care_ == Care::great ? atMinimum(a, b) : std::nullopt;
    }

private:
    void sample(double a, double b) {
        const auto& points = interpolationPoints();
        --budget_;
        const auto take = [&](std::size_t i) {
            const auto& values = recent_.at(i + 1 == points.size() ? b : a + points[i] * (b - a));
            for (std::size_t k = 0; k < values.size(); ++k)
                samples_[k][i] = values[k];
        };
        for (const std::size_t i : halfOfPoints)
            take(i);
        if (areOnParabolas())
            foretell();
        else
            for (std::size_t i = 1; i < points.size(); i += 2)
                take(i);
    }

    // How near a value that is foretold must be.
    static double enoughFor(double low, double high) {
        constexpr double close = 1e-6, far = 0.01; // of the size, and of the least value
        return std::max(close * std::max(std::abs(low), std::abs(high)), far * low);
    }

    // Of every other sample, those at the ends and in the middle foretell the two between.
    [[nodiscard]] bool areOnParabolas() const {
        return std::ranges::all_of(samples_, [](const Samples& samples) {
            const auto& points = interpolationPoints();
            const auto [low, high] =
                std::minmax({samples[0], samples[2], samples[4], samples[6], samples[8]});
            const double enough = enoughFor(low, high);
            return std::ranges::all_of(std::array<std::size_t, 2>{2, 6}, [&](std::size_t i) {
                const double s = points[i];
                const double foretold = samples[0] * (1 - s) * (1 - 2 * s) +
                                        samples[4] * 4 * s * (1 - s) - samples[8] * s * (1 - 2 * s);
                return std::abs(foretold - samples[i]) <= enough;
            });
        });
    }

    // The others, by every other sample.
    void foretell() {
        for (Samples& samples : samples_)
            for (std::size_t i = 1; i < samples.size(); i += 2)
                samples[i] = foretold(samples, i);
    }

    static double foretold(const Samples& samples, std::size_t i) {
        static const Weights weights = weightsOfHalf();
        double value = 0;
        for (std::size_t k = 0; k < halfOfPoints.size(); ++k)
            value += weights[i][k] * samples[halfOfPoints[k]];
        return value;
    }

    // Half of the samples foretell the others, of each watch: all of them need no check. A watch
    // far above 0 need not be foretold closely.
    [[nodiscard]] bool areForetold() const {
        return std::ranges::all_of(samples_, [](const Samples& samples) {
            const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
            const double enough = enoughFor(*low, *high);
            for (std::size_t i = 1; i < samples.size(); i += 2)
                if (!(std::abs(foretold(samples, i) - samples[i]) <= enough))
                    return false;
            return true;
        });
    }

    static constexpr double noise = 1e-9;       // of the largest sample
    static constexpr double explainedTo = 1e-3; // of the same: what a curve may be off, and more
    static double largestOf(const Samples& samples) {
        double largest = 0;
        for (const double x : samples)
            largest = std::max(largest, std::abs(x));
        return largest;
    }

    // The first sample inside the piece at which a watch that was above 0 is not: what is later
    // does not matter, and need not be followed.
    std::optional<double> fallenAt(double a, double b) const {
        std::size_t first = interpolationPoints().size() - 1;
        for (const Samples& samples : samples_) {
            const double nothing = noise * largestOf(samples);
            bool wasAbove = false;
            for (std::size_t i = 0; i < first; ++i) {
                if (wasAbove && samples[i] < -nothing)
                    first = i;
                wasAbove = wasAbove || samples[i] > nothing;
            }
        }
        if (first + 1 == interpolationPoints().size())
            return std::nullopt;
        return a + interpolationPoints()[first] * (b - a);
    }

    // At or below 0 at the start and below before it has ever been above.
    static bool fallsFromStart(const Samples& samples) {
        if (samples[0] > 0)
            return false;
        const double nothing = noise * largestOf(samples);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            if (samples[i] > 0)
                return false;
            if (samples[i] < -nothing)
                return true;
        }
        return false;
    }

    // What starts at 0 may rise for less than the samples see before it falls: an expression that
    // grazes its surface is passed there and back within a small part of a step. The end of such a
    // rise, where each of these watches has one.
    std::optional<Violation> endOfBump(const std::vector<std::size_t>& falling, double a,
                                       double b) {
        constexpr int halvings = 40;
        constexpr double rounding = 1e-12;
        Violation earliest{b, {}};
        const std::vector<Samples> samples = samples_;
        for (const std::size_t k : falling) {
            double largest = 0;
            for (const double x : samples[k])
                largest = std::max(largest, std::abs(x));
            const double high = a + interpolationPoints()[1] * (b - a);
            double t = high;
            bool isAbove = false;
            for (int i = 0; i < halvings && !isAbove && t > a; ++i) {
                t = a + 0.5 * (t - a);
                isAbove = watch(k, t) > rounding * largest;
            }
            const auto root = isAbove ? between(k, t, high) : std::nullopt;
            if (!root)
                return std::nullopt;
            if (*root < earliest.time)
                earliest = {*root, {k}};
        }
        return earliest;
    }

    // Does a polynomial of degree 8 follow the watches here? Far above 0 it need not do so closely,
    // and in a short piece not at all: a force jumps where a slip passes by 0 and turns.
    bool explained(double a, double b, int depth) {
        if (areForetold())
            return true;
        std::vector<Coefficients> curves;
        for (const Samples& samples : samples_)
            curves.push_back(interpolate(samples));
        for (const double point : checkPoints) {
            const std::vector<double>& values = recent_.at(a + point * (b - a));
            for (std::size_t k = 0; k < values.size(); ++k) {
                const auto [low, high] =
                    std::minmax_element(samples_[k].begin(), samples_[k].end());
                const double size = std::max(std::abs(*low), std::abs(*high));
                const double wrong = std::abs(evaluate(curves[k], point) - values[k]);
                const bool jumps = depth >= shortPiece && std::min(*low, values[k]) > 0.2 * size;
                if (!jumps && !(wrong <= std::max(1e-4 * size, 0.02 * *low)))
                    return false;
            }
        }
        return true;
    }

    // A minimum that lies on one of the samples is below 0 there by next to nothing.
    bool isAboveOrTouches(const Samples& samples, double low, double high) const {
        constexpr double nothing = 1e-9;
        return low > 0 || (care_ == Care::great && samples[0] > 0 && low > -nothing * high);
    }

    // Above 0 at all samples, and its curve comes so near 0 between them that it may be below
    // there.
    bool almostTouches() const {
        constexpr int looks = 40;
        for (const Samples& samples : samples_) {
            const auto [low, high] = std::minmax_element(samples.begin(), samples.end());
            if (!isAboveOrTouches(samples, *low, *high) || *low > 0.1 * *high)
                continue;
            const Coefficients curve = interpolate(samples);
            for (int i = 1; i < looks; ++i)
                if (const double value = evaluate(curve, static_cast<double>(i) / looks);
                    value < 1e-3 * *high && (value > 0 || care_ == Care::great))
                    return true;
        }
        return false;
    }

    // What touches 0, or nearly, in a piece as short as they get: at the minimum of its curve, or
    // on the last sample.
    std::optional<Violation> atMinimum(double a, double b) {
        Violation earliest{b, {}};
        const std::vector<Samples> samples = samples_;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const double minimum = a + minimumOf(interpolate(samples[k])) * (b - a);
            for (const double end : {minimum, b}) {
                const auto root = between(k, a, end);
                if (root && *root < earliest.time)
                    earliest = {*root, {k}};
            }
        }
        if (earliest.watches.empty())
            return std::nullopt;
        return earliest;
    }

    // In 0 to 1, by golden sections.
    static double minimumOf(const Coefficients& curve) {
        constexpr double golden = 0.618033988749895;
        double low = 0, high = 1;
        for (int i = 0; i < 60; ++i) {
            const double left = high - golden * (high - low), right = low + golden * (high - low);
            if (evaluate(curve, left) < evaluate(curve, right))
                high = right;
            else
                low = left;
        }
        return std::midpoint(low, high);
    }

    // The earliest root of any watch in this piece, on the watches themselves: first of the watch
    // whose curve falls first, so that others are looked at only up to there.
    std::optional<Violation> refine(double a, double b) {
        Violation earliest{b, {}};
        const std::vector<Samples> samples = samples_; // bisection evaluates too
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            const auto crossing =
                firstCrossing(interpolate(samples[k]), +1, armedFrom(samples[k]), 1, 1e-7);
            order.emplace_back(crossing ? crossing->low : 1, k);
        }
        std::ranges::sort(order);
        for (const auto& [from, k] : order) {
            const auto time = firstRoot(k, samples[k], a, earliest.time, b - a);
            if (!time)
                continue;
            if (*time < earliest.time)
                earliest = {*time, {}};
            earliest.watches.push_back(k);
        }
        if (earliest.watches.empty())
            return std::nullopt;
        std::ranges::sort(earliest.watches);
        return earliest;
    }

    std::optional<double> firstRoot(std::size_t k, const Samples& samples, double a, double b,
                                    double length) {
        const Coefficients curve = interpolate(samples);
        double s = armedFrom(samples);
        const double end = (b - a) / length;
        while (s < end) {
            const auto crossing = firstCrossing(curve, +1, s, end, 1e-7);
            const double atEnd = end < 1 ? evaluate(curve, end) : samples.back();
            const bool isAboveAtEnd = atEnd > (end < 1 ? explainedTo * largestOf(samples) : 0);
            if (!crossing)
                return isAboveAtEnd ? std::nullopt : between(k, a + s * length, b);
            // The curve is good to 1e-4 of its size: look a little around it.
            for (const double margin : {1e-7, 1e-5, 1e-3, 0.02}) {
                const double low = a + std::max(s, crossing->low - margin) * length;
                const double high = std::min(b, a + (crossing->high + margin) * length);
                if (const auto root = between(k, low, high))
                    return root;
            }
            s = crossing->high + 0.02; // a touch, or the curve's own error
        }
        return std::nullopt;
    }

    // To the last bit: above 0 at the double before the answer, and not at it.
    std::optional<double> between(std::size_t k, double low, double high) {
        constexpr double few = 4 * std::numeric_limits<double>::epsilon();
        double above = watch(k, low), below = above > 0 ? watch(k, high) : 0;
        if (!(above > 0 && below <= 0))
            return std::nullopt;
        for (int onLow = 0, onHigh = 0, slow = 0;;) { // how often in turn either end has moved
            const double middle = low + 0.5 * (high - low);
            if (middle <= low || middle >= high)
                return high;
            // A root at one end, but for rounding, is looked for beside that end.
            const double width = high - low, near = few * std::max(std::abs(low), std::abs(high));
            const double falsely = low + width * (above / (above - below));
            const bool isFalse =
                slow < 2 && width > 4 * near && falsely >= low && falsely <= high; // a number
            const double at = isFalse ? std::clamp(falsely, low + near, high - near) : middle;
            const double value = watch(k, at);
            if (value > 0) {
                low = at;
                above = value;
                onHigh = 0;
                below /= ++onLow > 1 ? 2 : 1;
            } else {
                high = at;
                below = value;
                onLow = 0;
                above /= ++onHigh > 1 ? 2 : 1;
            }
            slow = high - low > 0.5 * width ? slow + 1 : 0;
        }
    }

    static double armedFrom(const Samples& samples) {
        const auto& points = interpolationPoints();
        for (std::size_t i = 0; i < samples.size(); ++i)
            if (samples[i] > 0)
                return points[i];
        return 1;
    }

    double watch(std::size_t k, double t) {
        if (const auto* const known = recent_.find(t))
            return (*known)[k];
        if (one_)
            if (const auto value = one_(t, k))
                return *value;
        return recent_.at(t)[k];
    }

    Violation atStart() const {
        Violation violation{from_, {}};
        for (std::size_t k = 0; k < samples_.size(); ++k)
            if (fallsFromStart(samples_[k]))
                violation.watches.push_back(k);
        return violation;
    }

    Recent recent_;
    const OneWatch& one_;
    std::vector<Samples> samples_;
    double from_;
    Next next_;
    Care care_;
    std::optional<double> unsearched_;
    int budget_ = mostPieces;
};

} // namespace

std::optional<Violation> firstViolation(std::size_t watches, const Watches& evaluate, double from,
                                        double to, Care care, const OneWatch& one) {
    if (watches == 0 || !(to > from))
        return std::nullopt;
    for (int left = care == Care::great ? mostSearches : 1;; --left) {
        Search search(watches, evaluate, one, from,
                      left > 1 ? Search::Next::another : Search::Next::none, care);
        if (auto found = search.in(from, to, 0))
            return found;
        if (!search.unsearchedFrom())
            return std::nullopt;
        from = *search.unsearchedFrom();
    }
}

} // namespace solution
