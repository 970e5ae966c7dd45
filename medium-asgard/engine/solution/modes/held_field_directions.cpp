// Directions that are held where they have none; see held_field.h.
#include "modes/held_field.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

constexpr double tooMuch = 1e100; // what is divided does not vanish with a
constexpr double isNone = 1e-12;  // of the largest, of what solves equations

} // namespace

Eigen::VectorXd leastSolution(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& wanted) {
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
    decomposition.setThreshold(isNone);
    return decomposition.compute(matrix).solve(wanted);
}

// It draws a to 0, or does nothing, whatever the direction.
bool HeldField::Response::brakes() const {
    const double size = change.norm();
    const Eigen::MatrixXd symmetric = 0.5 * (change + change.transpose());
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(symmetric, Eigen::EigenvaluesOnly);
    return size > 0 && size < tooMuch && rate.norm() < tooMuch &&
           solver.eigenvalues().maxCoeff() <= 1e-9 * size;
}

// The d of length 1 for which rate + change d is l d. With x = (l - change)^-1 rate, 1/|x| is
// next to linear in l, and exactly so where friction is alike in all directions.
std::optional<HeldField::Response::Departure> HeldField::Response::departure() const {
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

void HeldField::evaluateOutputs(std::span<double> out) {
    if (multipliers_.solveWith(out)) {
        isContradictory_ = false;
        return;
    }
    isContradictory_ = !multipliers_.solve();
    if (mode_.sticking.empty()) {
        if (mode_.decisions.empty())
            model_.function().evaluate(f_.symbols(), out, f_.scratch());
        else
            model_.function().evaluate(f_.symbols(), out, f_.scratch(), mode_.decisions);
        multipliers_.addForces(out);
        return;
    }
    f_.evaluate(model_.directions().outputs, f_.inHeld(), out);
}

// What is not given is solved for.
std::vector<HeldField::Column> HeldField::columns() const {
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

const ComponentModel::Gradient& HeldField::gradientOf(const Column& column) const {
    return column.isPart ? model_.directions().gradients[column.which]
                         : model_.gradient(column.which);
}

void HeldField::setColumn(const Column& column, bool isSet) {
    if (column.isPart)
        f_.units()[column.which] = isSet ? 1 : 0;
    else
        mode_.setSide(column.which, isSet ? +1 : -1);
}

double HeldField::rateOf(const Column& column, std::span<const double> rates) {
    const double rate = f_.slopeOf(gradientOf(column).derivatives, rates).rate;
    return column.isPart ? f_.scaleOf(column.which) * rate : rate;
}

// What sets off goes where it is drawn to.
bool HeldField::weighWithDirections() {
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
        f_.units()[first + static_cast<std::size_t>(i)] = departure->direction(i);
    return solveWithDirections();
}

// As weigh(), also for what stands for directions: of several solutions the one that is nearest to
// no force at all, and to the middle of weights.
bool HeldField::solveWithDirections() {
    const std::vector<Column> all = columns();
    for (const Column& column : all)
        setColumn(column, false);
    outputsAndForces(base_);
    const auto m = static_cast<Eigen::Index>(all.size());
    Eigen::MatrixXd change(m, m);
    Eigen::VectorXd wanted(m), w(m);
    if (fields_.size() < all.size())
        fields_.resize(all.size());
    for (std::size_t j = 0; j < all.size(); ++j) {
        setColumn(all[j], true);
        outputsAndForces(fields_[j]);
        setColumn(all[j], false);
    }
    for (Eigen::Index i = 0; i < m; ++i) {
        const Column& row = all[static_cast<std::size_t>(i)];
        wanted(i) = -rateOf(row, base_);
        for (Eigen::Index j = 0; j < m; ++j)
            change(i, j) = rateOf(row, fields_[static_cast<std::size_t>(j)]) + wanted(i);
        w(i) = row.isPart ? 0 : 0.5;
    }
    if (m > 0 && change.allFinite() && wanted.allFinite())
        w += leastSolution(change, wanted - change * w);
    if (!w.allFinite() || !((change * w - wanted).norm() <= 1e-9 * wanted.norm()))
        return false;
    mixFields({w.data(), all.size()});
    f_.weights().clear();
    for (std::size_t j = 0; j < all.size(); ++j) {
        const double weight = w(static_cast<Eigen::Index>(j));
        if (all[j].isPart)
            f_.units()[all[j].which] = weight;
        else
            f_.weights().push_back(weight);
    }
    for (const Column& column : all)
        if (const auto state = gradientOf(column).state)
            values_[*state] = 0;
    return true;
}

std::vector<std::size_t> HeldField::directionsAtRest(double t, std::span<const double> y) {
    std::vector<std::size_t> found;
    f_.fill(t, y);
    const std::vector<double> still(size());
    const ComponentModel::Directions& directions = model_.directions();
    for (std::size_t d = 0; d < directions.ranges.size(); ++d) {
        bool isAtRest = std::ranges::find(mode_.sticking, d) == mode_.sticking.end();
        const auto [first, count] = directions.ranges[d];
        for (std::size_t p = first; isAtRest && p < first + count; ++p) {
            const GuardSlope slope = f_.slopeOf(directions.gradients[p].derivatives, still);
            isAtRest = directions.gradients[p].state ? slope.value == 0
                                                     : std::abs(slope.value) <= slope.near;
        }
        if (isAtRest)
            found.push_back(d);
    }
    return found;
}

// Of the square of what stands for it, over what can be.
double HeldField::excess(std::size_t direction) const {
    constexpr double rounding = 2e-12;
    const auto [first, count] = model_.directions().ranges[direction];
    double square = 0;
    if (direction == mode_.leaving)
        return -1;
    for (std::size_t p = first; p < first + count; ++p)
        square += f_.units()[p] * f_.units()[p];
    return square - (1 + rounding);
}

// Of one that is held, at what f_.fill() was given, while all else that is held stays so.
std::optional<HeldField::Response> HeldField::responseOf(std::size_t direction) {
    const auto [first, count] = model_.directions().ranges[direction];
    const auto n = static_cast<Eigen::Index>(count);
    Response response{Eigen::VectorXd(n), Eigen::MatrixXd(n, n), {}};
    const std::vector<double> before = f_.units();
    given_ = direction;
    bool isPossible = true;
    std::vector<double> base;
    for (Eigen::Index j = -1; j < n; ++j) {
        for (Eigen::Index i = 0; i < n; ++i)
            f_.units()[first + static_cast<std::size_t>(i)] = i == j ? 1 : 0;
        isPossible = isPossible && weigh();
        std::vector<double> field = values_;
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
    f_.units() = before;
    if (!isPossible || !response.rate.allFinite() || !response.change.allFinite())
        return std::nullopt;
    return response;
}

} // namespace solution
