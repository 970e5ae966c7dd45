// Directions that are held where they have none; see component_equations.h.
//
// With a the vector whose direction it is, scaled by the roots of its weights, and u what stands
// for a/|a| while a is held at 0: expressions of a/|a| are evaluated with u times next to nothing
// for a and next to nothing for |a|.
#include "modes/component_equations.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr double tooMuch = 1e100; // what is divided does not vanish with a
constexpr double isNone = 1e-12;  // of the largest, of what solves equations

Eigen::VectorXd leastSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wanted) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(isNone);
    return decomposition.compute(matrix).solve(wanted);
}

} // namespace

// a' = rate + change u
struct ComponentEquations::Response {
    Eigen::VectorXd rate;
    Eigen::MatrixXd change;
    std::vector<std::vector<double>> fields; // change of all rates by each u
    struct Departure {
        Eigen::VectorXd direction;
        double growth;
    };
    // It draws a to 0, or does nothing, whatever the direction.
    [[nodiscard]] bool brakes() const {
        const double size = change.norm();
        const Eigen::MatrixXd symmetric = 0.5 * (change + change.transpose());
        const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric,
                                                                    Eigen::EigenvaluesOnly);
        return size > 0 && size < tooMuch && rate.norm() < tooMuch &&
               solver.eigenvalues().maxCoeff() <= 1e-9 * size;
    }
    // The d of length 1 for which rate + change d is l d. With x = (l - change)^-1 rate, 1/|x| is
    // next to linear in l, and exactly so where friction is alike in all directions.
    [[nodiscard]] std::optional<Departure> departure() const {
        constexpr int rounds = 30;
        const auto n = rate.size();
        double l = 0;
        Eigen::VectorXd x(n);
        for (int round = 0; round < rounds; ++round) {
            const Eigen::MatrixXd shifted = l * Eigen::MatrixXd::Identity(n, n) - change;
            x = leastSolution(shifted, rate);
            const double length = x.norm();
            if (!(length > 0) || !std::isfinite(length))
                return std::nullopt;
            const double slope = x.dot(leastSolution(shifted, x)) / (length * length * length);
            const double step = (1 - 1 / length) / slope;
            l += step;
            if (!(std::abs(step) > 1e-14 * rate.norm()))
                break;
        }
        if (!(std::abs(x.norm() - 1) < 1e-6))
            return std::nullopt;
        return Departure{x / x.norm(), l};
    }
};

void ComponentEquations::measure() {
    const ComponentModel::Directions& directions = model_.directions();
    measures_.resize(2 * directions.parts + directions.ranges.size());
    evaluate(directions.measures, measures_);
}

void ComponentEquations::evaluateOutputs(std::span<double> out) {
    if (mode_.sticking.empty()) {
        if (mode_.decisions.empty())
            model_.function().evaluate(in_, out, scratch_);
        else
            model_.function().evaluate(in_, out, scratch_, mode_.decisions);
        return;
    }
    measure();
    const ComponentModel::Directions& directions = model_.directions();
    const auto parts = measures_.begin(), lengths = parts + 2 * std::ptrdiff_t(directions.parts);
    inHeld_ = in_;
    inHeld_.insert(inHeld_.end(), parts, parts + std::ptrdiff_t(directions.parts));
    inHeld_.insert(inHeld_.end(), lengths, measures_.end());
    for (const std::size_t d : mode_.sticking) {
        const auto [first, count] = directions.ranges[d];
        const double length =
            d == mode_.leaving ? std::max(vectorOf(d).norm(), nextToNothing) : nextToNothing;
        inHeld_[in_.size() + directions.parts + d] = length;
        for (std::size_t p = first; p < first + count; ++p)
            inHeld_[in_.size() + p] = length * units_[p] / scaleOf(p);
    }
    evaluate(directions.outputs, inHeld_, out);
}

// Of a part, after measure().
double ComponentEquations::scaleOf(std::size_t part) const {
    return std::sqrt(measures_[model_.directions().parts + part]);
}

// After measure().
Eigen::VectorXd ComponentEquations::vectorOf(std::size_t direction) const {
    const auto [first, count] = model_.directions().ranges[direction];
    Eigen::VectorXd vector(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i)
        vector(static_cast<Eigen::Index>(i)) = scaleOf(first + i) * measures_[first + i];
    return vector;
}

// What is not given is solved for.
std::vector<ComponentEquations::Column> ComponentEquations::columns() const {
    std::vector<Column> columns;
    for (const std::size_t s : mode_.sliding)
        columns.push_back({false, s});
    for (const std::size_t d : mode_.sticking) {
        const auto [first, count] = model_.directions().ranges[d];
        for (std::size_t p = first; d != given_ && d != mode_.leaving && p < first + count; ++p)
            columns.push_back({true, p});
    }
    return columns;
}

const ComponentModel::Gradient& ComponentEquations::gradientOf(const Column& column) const {
    return column.isPart ? model_.directions().gradients[column.which]
                         : model_.gradient(column.which);
}

void ComponentEquations::setColumn(const Column& column, bool isSet) {
    if (column.isPart)
        units_[column.which] = isSet ? 1 : 0;
    else
        setSide(column.which, isSet ? +1 : -1);
}

double ComponentEquations::rateOf(const Column& column, std::span<const double> rates) {
    const double rate = slopeOf(gradientOf(column).derivatives, rates).rate;
    return column.isPart ? scaleOf(column.which) * rate : rate;
}

// What sets off goes where it is drawn to.
bool ComponentEquations::weighWithDirections() {
    if (!mode_.leaving || given_)
        return solveWithDirections();
    const auto response = responseOf(*mode_.leaving);
    const auto departure = response ? response->departure() : std::nullopt;
    if (!departure)
        return false;
    growth_ = departure->growth;
    pull_ = response->rate.norm();
    const auto first = model_.directions().ranges[*mode_.leaving].first;
    for (Eigen::Index i = 0; i < departure->direction.size(); ++i)
        units_[first + static_cast<std::size_t>(i)] = departure->direction(i);
    return solveWithDirections();
}

// As weigh(), also for what stands for directions: of several solutions the one that is nearest to
// no force at all, and to the middle of weights.
bool ComponentEquations::solveWithDirections() {
    const std::vector<Column> all = columns();
    for (const Column& column : all)
        setColumn(column, false);
    evaluate(base_);
    const auto m = static_cast<Eigen::Index>(all.size());
    Eigen::MatrixXd change(m, m);
    Eigen::VectorXd wanted(m), w(m);
    std::vector<std::vector<double>> fields;
    for (const Column& column : all) {
        setColumn(column, true);
        evaluate(other_);
        setColumn(column, false);
        fields.push_back(other_);
    }
    for (Eigen::Index i = 0; i < m; ++i) {
        const Column& row = all[static_cast<std::size_t>(i)];
        wanted(i) = -rateOf(row, base_);
        for (Eigen::Index j = 0; j < m; ++j)
            change(i, j) = rateOf(row, fields[static_cast<std::size_t>(j)]) + wanted(i);
        w(i) = row.isPart ? 0 : 0.5;
    }
    if (m > 0 && change.allFinite() && wanted.allFinite())
        w += leastSolution(change, wanted - change * w);
    if (!w.allFinite() || !((change * w - wanted).norm() <= 1e-9 * wanted.norm()))
        return false;
    out_ = base_;
    weights_.clear();
    for (std::size_t j = 0; j < all.size(); ++j) {
        const double weight = w(static_cast<Eigen::Index>(j));
        for (std::size_t n = 0; n < out_.size(); ++n)
            out_[n] += weight * (fields[j][n] - base_[n]);
        if (all[j].isPart)
            units_[all[j].which] = weight;
        else
            weights_.push_back(weight);
    }
    for (const Column& column : all)
        if (const auto state = gradientOf(column).state)
            out_[*state] = 0;
    return true;
}

// Of the square of what stands for it, over what can be.
double ComponentEquations::excess(std::size_t direction) const {
    constexpr double rounding = 2e-12;
    const auto [first, count] = model_.directions().ranges[direction];
    double square = 0;
    if (direction == mode_.leaving)
        return -1;
    for (std::size_t p = first; p < first + count; ++p)
        square += units_[p] * units_[p];
    return square - (1 + rounding);
}

// Of one that is held, at what fill() was given, while all else that is held stays so.
std::optional<ComponentEquations::Response> ComponentEquations::responseOf(std::size_t direction) {
    const auto [first, count] = model_.directions().ranges[direction];
    const auto n = static_cast<Eigen::Index>(count);
    Response response{Eigen::VectorXd(n), Eigen::MatrixXd(n, n), {}};
    const std::vector<double> before = units_;
    given_ = direction;
    bool isPossible = true;
    std::vector<double> base;
    for (Eigen::Index j = -1; j < n; ++j) {
        for (Eigen::Index i = 0; i < n; ++i)
            units_[first + static_cast<std::size_t>(i)] = i == j ? 1 : 0;
        isPossible = isPossible && weigh();
        std::vector<double> field = out_;
        for (Eigen::Index i = 0; i < n; ++i) {
            const double rate = rateOf({true, first + static_cast<std::size_t>(i)}, field);
            if (j < 0)
                response.rate(i) = rate;
            else
                response.change(i, j) = rate - response.rate(i);
        }
        if (j < 0)
            base = field;
        else
            for (std::size_t k = 0; k < field.size(); ++k)
                field[k] -= base[k];
        if (j >= 0)
            response.fields.push_back(std::move(field));
    }
    given_.reset();
    units_ = before;
    if (!isPossible || !response.rate.allFinite() || !response.change.allFinite())
        return std::nullopt;
    return response;
}

// Its vector to that value, by what its forces do; exactly where its parts are states.
void ComponentEquations::put(std::size_t direction, const Eigen::VectorXd& target,
                             const Response& response, std::span<double> y) {
    const auto [first, count] = model_.directions().ranges[direction];
    Eigen::VectorXd wanted = target;
    for (std::size_t i = 0; i < count; ++i)
        wanted(static_cast<Eigen::Index>(i)) -= scaleOf(first + i) * measures_[first + i];
    const Eigen::VectorXd blow = leastSolution(response.change, wanted);
    for (std::size_t j = 0; j < count && blow.allFinite(); ++j)
        for (std::size_t k = 0; k < y.size(); ++k)
            y[k] += blow(static_cast<Eigen::Index>(j)) * response.fields[j][k];
    for (std::size_t i = 0; i < count; ++i)
        if (const auto state = model_.directions().gradients[first + i].state)
            y[*state] = target(static_cast<Eigen::Index>(i)) / scaleOf(first + i);
}

// The error that a step may have in one part of the vector, scaled.
double ComponentEquations::reachOf(std::size_t part) {
    std::vector<double> partial(model_.variables() + 1);
    evaluate(model_.directions().gradients[part].derivatives, partial);
    double reach = 0;
    for (std::size_t i = 0; i < reach_.size(); ++i)
        reach += std::abs(partial[1 + i]) * reach_[i];
    return scaleOf(part) * reach;
}

// For a body that begins to slip: how much farther its velocity may deviate from the direction of
// the pull. A deviation within the tolerance does not count. While the velocity hardly grows, its
// direction is that of the pull, whatever it was before, so more deviation is allowed.
double ComponentEquations::leeway() {
    constexpr double part = 1e-2, slow = 1e-2, rounding = 1e-9;
    const auto [first, count] = model_.directions().ranges[*mode_.leaving];
    measure();
    const Eigen::VectorXd a = vectorOf(*mode_.leaving);
    const double length = a.norm();
    double off = 0, allowed = reachOf(first);
    for (std::size_t p = first; p < first + count; ++p) {
        off = std::max(off, std::abs(a(static_cast<Eigen::Index>(p - first)) - length * units_[p]));
        allowed = std::min(allowed, reachOf(p));
    }
    allowed = std::max(allowed, tolerance_ * length); // nothing has moved yet
    allowed += part * length * std::max(0.0, 1 - growth_ / (slow * pull_));
    return std::min(allowed - off, growth_ / pull_ + rounding);
}

// A body counts as beginning to slip as long as rates near its rest are stiff. One does at a time;
// others leave their rest by next to nothing.
bool ComponentEquations::leaveRest(std::size_t direction, double t, std::span<double> y) {
    constexpr double part = 1e-2, least = 1e-100;
    fill(t, y);
    const auto response = responseOf(direction);
    const auto departure = response ? response->departure() : std::nullopt;
    if (!departure)
        return false;
    if (!mode_.leaving) {
        mode_.leaving = direction;
        return true;
    }
    const auto [first, count] = model_.directions().ranges[direction];
    double reach = reachOf(first);
    for (std::size_t p = first + 1; p < first + count; ++p)
        reach = std::min(reach, reachOf(p));
    put(direction, std::max(part * reach, least) * departure->direction, *response, y);
    std::erase(mode_.sticking, direction);
    return true;
}

// It has left, and goes as its direction says; or does not leave after all.
bool ComponentEquations::setFree(double t, std::span<double> y) {
    const std::size_t direction = *mode_.leaving;
    fill(t, y);
    const auto response = responseOf(direction);
    const auto departure = response ? response->departure() : std::nullopt;
    measure();
    const Eigen::VectorXd vector = vectorOf(direction);
    const auto first = model_.directions().ranges[direction].first;
    bool isThere = true;
    for (Eigen::Index i = 0; i < vector.size(); ++i)
        isThere = isThere && std::abs(vector(i)) <= reachOf(first + static_cast<std::size_t>(i));
    mode_.leaving.reset();
    if (vector.isZero(0) || (departure && departure->growth <= 0 && isThere)) {
        if (response)
            put(direction, Eigen::VectorXd::Zero(vector.size()), *response, y);
        return response.has_value();
    }
    constexpr double aside = 0.1; // more is none of its own doing
    if (departure && departure->growth > 0) {
        const Eigen::VectorXd straight = vector.norm() * departure->direction;
        if ((straight - vector).norm() <= aside * vector.norm())
            put(direction, straight, *response, y);
    }
    std::erase(mode_.sticking, direction);
    return true;
}

// Where what is held is not at 0 any more, since its expression has jumped, as that of a plate's
// speed when the plate turns back.
void ComponentEquations::releaseWhereJumped(double t, std::span<const double> y) {
    if (mode_.sticking.empty())
        return;
    fill(t, y);
    measure();
    std::erase_if(mode_.sticking, [this](std::size_t direction) {
        const auto [first, count] = model_.directions().ranges[direction];
        bool hasJumped = false;
        for (std::size_t p = first; direction != mode_.leaving && p < first + count; ++p)
            hasJumped = hasJumped || std::abs(measures_[p]) * scaleOf(p) > reachOf(p);
        return hasJumped;
    });
}

bool ComponentEquations::leaveRest(const Violation& violation, double t, std::span<double> y) {
    std::vector<std::size_t> leaving;
    for (const std::size_t k : violation.watches)
        if (k >= watches_.size())
            leaving.push_back(mode_.sticking[k - watches_.size()]);
    bool isDone = true;
    for (const std::size_t direction : leaving)
        isDone =
            (direction == mode_.leaving ? setFree(t, y) : leaveRest(direction, t, y)) && isDone;
    refreshWatches();
    return isDone;
}

std::vector<ComponentEquations::Approach>
ComponentEquations::approaches(double t, std::span<const double> y) {
    constexpr double part = 0.1;
    std::vector<Approach> found;
    fill(t, y);
    field();
    const std::vector<double> rates = out_;
    measure();
    const ComponentModel::Directions& directions = model_.directions();
    const auto& ranges = directions.ranges;
    for (std::size_t d = 0; d < ranges.size(); ++d) {
        if (d != mode_.leaving && std::ranges::find(mode_.sticking, d) != mode_.sticking.end())
            continue;
        double square = 0, along = 0, noise = 0;
        bool isNear = true;
        for (std::size_t p = ranges[d].first; p < ranges[d].first + ranges[d].count; ++p) {
            const double a = scaleOf(p) * measures_[p];
            const Slope slope = slopeOf(directions.gradients[p].derivatives, rates);
            square += a * a;
            along += a * scaleOf(p) * slope.rate;
            noise += std::abs(a) * scaleOf(p) * slope.noise;
            isNear = isNear && std::abs(a) <= part * reachOf(p);
        }
        if (along < -noise)
            found.push_back({d, std::sqrt(square), -square / along, isNear});
    }
    return found;
}

std::vector<std::size_t> ComponentEquations::directionsAtRest(double t, std::span<const double> y) {
    std::vector<std::size_t> found;
    fill(t, y);
    const std::vector<double> still(out_.size());
    const ComponentModel::Directions& directions = model_.directions();
    for (std::size_t d = 0; d < directions.ranges.size(); ++d) {
        bool isAtRest = std::ranges::find(mode_.sticking, d) == mode_.sticking.end();
        const auto [first, count] = directions.ranges[d];
        for (std::size_t p = first; isAtRest && p < first + count; ++p) {
            const Slope slope = slopeOf(directions.gradients[p].derivatives, still);
            isAtRest = directions.gradients[p].state ? slope.value == 0
                                                     : std::abs(slope.value) <= slope.near;
        }
        if (isAtRest)
            found.push_back(d);
    }
    return found;
}

bool ComponentEquations::rest(std::span<const std::size_t> directions, double t,
                              std::span<double> y) {
    const Mode before = mode_;
    fill(t, y);
    if (mode_.leaving && std::ranges::find(directions, *mode_.leaving) != directions.end()) {
        std::erase(mode_.sticking, *mode_.leaving);
        mode_.leaving.reset();
    }
    const std::size_t others = mode_.sticking.size();
    mode_.sticking.insert(mode_.sticking.end(), directions.begin(), directions.end());
    for (const std::size_t d : directions) {
        fill(t, y);
        const auto response = responseOf(d);
        if (response && response->brakes())
            put(d, Eigen::VectorXd::Zero(response->rate.size()), *response, y);
        else
            std::erase(mode_.sticking, d);
    }
    bool isDone = mode_.sticking.size() > others;
    for (std::size_t round = 0; isDone && round < units_.size(); ++round) {
        fill(t, y);
        const auto more = [this](std::size_t a, std::size_t b) { return excess(a) < excess(b); };
        const bool isPossible = weigh();
        const auto worst = std::ranges::max_element(mode_.sticking, more);
        if (worst == mode_.sticking.end() || (isPossible && excess(*worst) <= 0))
            break;
        isDone = leaveRest(isPossible ? *worst : mode_.sticking.back(), t, y);
    }
    if (!isDone)
        mode_ = before;
    refreshWatches();
    return isDone;
}

} // namespace solution
