#include "integrators/radau.h"

#include "dense/dense_output.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace solution {

namespace {

const double root6 = std::sqrt(6.0);
const CoupledStages::Nodes node = {(4 - root6) / 10, (4 + root6) / 10, 1};

// Eigenvalues of A^-1: g, and a +- ib (from the roots of its characteristic polynomial).
const double cube9 = std::cbrt(9.0);
const double inverseG = (6 + cube9 * (cube9 - 1)) / 30;
const double rawA = (12 - cube9 * (cube9 - 1)) / 60;
const double rawB = cube9 * (cube9 + 1) * std::numbers::sqrt3 / 60;
const double g = 1 / inverseG;
const double a = rawA / (rawA * rawA + rawB * rawB);
const double b = rawB / (rawA * rawA + rawB * rawB);

// Columns of T: the eigenvectors' real form; its last row is (t, 1, 0).
const double T[3][3] = {
    {9.1232394870892942792e-02, -0.14125529502095420843, -3.0029194105147424492e-02},
    {0.24171793270710701896, 0.20412935229379993199, 0.38294211275726193779},
    {0.96604818261509293619, 1, 0}};
const double inverseT[3][3] = {
    {4.3255798900631553510, 0.33919925181580986954, 0.54177053993587487119},
    {-4.1787185915519047273, -0.32768282076106238708, 0.47662355450055045196},
    {-0.50287263494578687595, 2.5719269498556054292, -0.59603920482822492497}};

// Error estimate: (g/h I - J)^-1 (f(y0) + sum e_i z_i / h).
const double estimateWeight[3] = {-(13 + 7 * root6) / 3, (-13 + 7 * root6) / 3, -1.0 / 3};

// Coefficients of the polynomial of degree n through given values at given points in [0, 1].
template <std::size_t Count>
std::array<std::array<double, Count>, Count>
lagrangeBasis(const std::array<double, Count>& points) {
    std::array<std::array<double, Count>, Count> basis{}; // [point][power]
    for (std::size_t i = 0; i < Count; ++i) {
        basis[i][0] = 1;
        std::size_t degree = 0;
        for (std::size_t j = 0; j < Count; ++j) {
            if (j == i)
                continue;
            ++degree;
            const double d = points[i] - points[j];
            for (std::size_t k = degree; k > 0; --k)
                basis[i][k] = (basis[i][k - 1] - points[j] * basis[i][k]) / d;
            basis[i][0] = -points[j] * basis[i][0] / d;
        }
    }
    return basis;
}

// The collocation polynomial through 0 and the z_i, and polynomials through four slopes.
const auto collocation = lagrangeBasis<4>({0, node[0], node[1], node[2]});

// Slopes of the collocation polynomial at the nodes, by the z_j.
const auto slopeWeights = [] {
    std::array<std::array<double, 3>, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            weights[i][j] = evaluateDerivative(collocation[j + 1], node[i]);
    return weights;
}();

} // namespace

Radau::Radau(System& system, ErrorControl& control, bool fixed)
    : Method(system, control, fixed), at_(system.size()), error_(system.size()),
      errorRates_(system.size()), endSlope_(system.size()), startSlope_(system.size()),
      pair_(system.size()) {
    const std::size_t n = system.size();
    start_.resize(n);
    end_.resize(n);
    slope_.resize(n);
    for (Stages* stages : {&z_, &w_, &f_, &before_.z})
        for (std::vector<double>& stage : *stages)
            stage.resize(n);
    solver_ = std::make_unique<LinearSolver>(system.jacobianPattern());
    linear_.jacobian.resize(system.jacobianPattern().entries());
}

bool Radau::begin(double t, std::span<const double> y) {
    t_ = t;
    start_.assign(y.begin(), y.end());
    before_.step = 0;
    linear_.isFactored = linear_.isFresh = false;
    controller_.isFirst = true;
    controller_.isAfterRejection = false;
    controller_.step = 0;
    newton_.rate = 1;
    together_.from = together_.unsolved = infinity;
    together_.steps = 0;
    if (!rates(t, y, slope_))
        return false;
    startSlope_ = slope_;
    return true;
}

// Stages on the last step's polynomial, continued; at the start on nothing (z = 0).
void Radau::predict() {
    for (std::size_t i = 0; i < 3; ++i)
        std::fill(z_[i].begin(), z_[i].end(), 0.0);
    if (before_.step > 0)
        for (std::size_t i = 0; i < 3; ++i) {
            const double s = 1 + node[i] * h_ / before_.step;
            double change[3] = {};
            for (std::size_t j = 0; j < 3; ++j)
                change[j] = evaluate(collocation[j + 1], s) - evaluate(collocation[j + 1], 1);
            for (std::size_t n = 0; n < start_.size(); ++n)
                z_[i][n] = change[0] * before_.z[0][n] + change[1] * before_.z[1][n] +
                           change[2] * before_.z[2][n];
        }
    before_.predictedEnd = z_[2];
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t n = 0; n < start_.size(); ++n)
            w_[i][n] =
                inverseT[i][0] * z_[0][n] + inverseT[i][1] * z_[1][n] + inverseT[i][2] * z_[2][n];
}

void Radau::middle(std::vector<double>& y) const {
    for (std::size_t n = 0; n < y.size(); ++n)
        y[n] = start_[n] + z_[1][n];
}

bool Radau::linearize(double t, std::span<const double> y) {
    ++counts_.jacobians;
    linear_.isFresh = true;
    return system_.jacobian(t, y, linear_.jacobian);
}

bool Radau::refactor() {
    ++counts_.factorisations;
    linear_.isFactored = solver_->factor(linear_.jacobian, g / h_, std::complex<double>(a, b) / h_);
    linear_.step = h_;
    return linear_.isFactored;
}

bool Radau::stageRates() {
    ++counts_.iterations;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t n = 0; n < start_.size(); ++n)
            at_[n] = start_[n] + z_[i][n];
        if (!rates(t_ + node[i] * h_, at_, f_[i]))
            return false;
    }
    return true;
}

// One Newton correction of all stages; `size` is its norm.
bool Radau::correct(double& size) {
    if (!stageRates())
        return false;
    const auto transformed = [this](std::size_t i, std::size_t n) {
        return inverseT[i][0] * f_[0][n] + inverseT[i][1] * f_[1][n] + inverseT[i][2] * f_[2][n];
    };
    for (std::size_t n = 0; n < start_.size(); ++n) {
        error_[n] = transformed(0, n) - g / h_ * w_[0][n];
        pair_[n] = std::complex<double>(transformed(1, n), transformed(2, n)) -
                   std::complex<double>(a, b) / h_ * std::complex<double>(w_[1][n], w_[2][n]);
    }
    solver_->solve(error_);
    solver_->solve(pair_);
    size = 0;
    for (std::size_t n = 0; n < start_.size(); ++n) {
        w_[0][n] += error_[n];
        w_[1][n] += pair_[n].real();
        w_[2][n] += pair_[n].imag();
        const double before[3] = {z_[0][n], z_[1][n], z_[2][n]};
        for (std::size_t i = 0; i < 3; ++i) {
            z_[i][n] = T[i][0] * w_[0][n] + T[i][1] * w_[1][n] + T[i][2] * w_[2][n];
            size = std::max(size, std::abs(z_[i][n] - before[i]) / control_.scale(n));
        }
    }
    return std::isfinite(size);
}

bool Radau::linearizeMiddle() {
    middle(at_);
    return linearize(t_ + node[1] * h_, at_) && refactor();
}

Radau::Newton Radau::iterate() {
    constexpr std::size_t mostIterations = 12, mayGrow = 5;
    constexpr double mostGrowth = 5, slow = 0.5;
    // The estimate is of order 3, and its tolerance is the tighter for it.
    constexpr double most = 0.03, cautious = 5;
    const double kappa =
        fixed_ ? control_.newtonTolerance() : std::min(most, cautious * control_.newtonTolerance());
    const double noise = control_.newtonNoise(!fixed_);
    double last = 0;
    // With fixed steps Newton goes to rounding, which stiffness magnifies: no further than that.
    const auto isRounding = [this, noise](double size) {
        return size < noise || (fixed_ && size * control_.tolerance() < 1e-9);
    };
    newton_.rate = std::max(newton_.rate, 1e-16);
    // At fixed steps nothing checks what an old rate promises.
    double rate = newton_.rate < 1 && !linear_.isFresh && !fixed_ ? std::pow(newton_.rate, 0.8) : 1;
    for (newton_.count = 1; newton_.count <= mostIterations; ++newton_.count) {
        double size = 0;
        if (!correct(size))
            return Newton::notFinite;
        if (last > 0) {
            rate = size / last;
            if (rate >= (newton_.count <= mayGrow ? mostGrowth : 1))
                return isRounding(last) ? Newton::converged : Newton::failed;
        }
        last = size;
        const bool isSmall = rate < 1 && rate / (1 - rate) * size < kappa;
        if (size == 0 || (newton_.count >= leastCorrections() && isSmall) ||
            (newton_.count > 1 && rate > slow && size < noise)) {
            newton_.rate = newton_.count > 1 ? rate : newton_.rate;
            return Newton::converged;
        }
        if (newton_.count > 1 && rate > slow && !linearizeMiddle())
            return Newton::notFinite;
    }
    return isRounding(last) ? Newton::converged : Newton::failed;
}

// What one Jacobian for all stages does not solve may do so with one for each. Then the error is
// estimated with the Jacobian of the start, whose stiff directions are those in which rounding of
// the start shows.
Radau::Newton Radau::solveTogether() {
    if (!together_.stages)
        together_.stages = std::make_unique<CoupledStages>(system_, control_, node, slopeWeights);
    predict();
    linear_.isFactored = false;
    newton_.rate = 1; // says nothing of the other iteration
    const Newton result = together_.stages->solve(t_, h_, start_, z_, fixed_, leastCorrections());
    counts_ += together_.stages->counts();
    newton_.count = together_.stages->counts().iterations;
    if (result != Newton::converged)
        return result;
    ++counts_.factorisations;
    return linearize(t_, start_) && solver_->factor(linear_.jacobian, g / h_) ? Newton::converged
                                                                              : Newton::notFinite;
}

Radau::Newton Radau::solveStages() {
    constexpr std::size_t patience = 32;
    if (h_ >= together_.from && ++together_.steps % patience == 0)
        together_.from *= 2;
    if (h_ >= together_.from)
        return solveTogether();
    const bool keep = linear_.isFactored && h_ == linear_.step && newton_.rate < 1e-3;
    if (keep) {
        linear_.isFresh = false;
    } else if (!linearizeMiddle() && !(linearize(t_, start_) && refactor())) {
        return Newton::notFinite; // the prediction may lie where f has no value
    }
    const Newton result = iterate();
    if (result != Newton::failed)
        return result;
    together_.from = h_;
    return solveTogether();
}

// What the last step's polynomial, continued to the end of this one, misses says how well this
// one's follows the motion within the step: the errors of both are the fourth derivative over 24
// times the product of the distances from their nodes. The estimate below does not see it where
// stiffness holds the ends of steps in place.
double Radau::denseError() {
    constexpr double largestWithin = 0.018; // of |s (s - c1) (s - c2) (s - 1)| on [0, 1]
    if (!(before_.step > 0))
        return 0;
    const double r = h_ / before_.step;
    const double beyond = (1 + r) * (1 + r - node[0]) * (1 + r - node[1]) * r;
    const double part = largestWithin * r * r * r * r / beyond;
    for (std::size_t n = 0; n < error_.size(); ++n)
        error_[n] = part * (z_[2][n] - before_.predictedEnd[n]);
    for (const auto& [x, v] : system_.integrals())
        error_[x] = 0; // the quintic is better
    return control_.norm(error_);
}

// What rounding of the start's positions makes of the estimate is no error, and shorter steps make
// it larger: less as much as it is for roundings taken at random.
void Radau::removeRounding() {
    constexpr double matters = 1e-3, likely = 4;
    if (control_.newtonNoise() < matters)
        return;
    std::vector<double>& rounding = at_;
    std::vector<double> response(rounding.size(), 0.0);
    std::minstd_rand random(1);
    for (std::size_t n = 0; n < rounding.size(); ++n)
        rounding[n] = control_.rounding(n) * (random() % 2 == 0 ? likely : -likely);
    const Pattern& pattern = system_.jacobianPattern();
    for (std::size_t column = 0; column < rounding.size(); ++column)
        for (int k = pattern.columnStarts[column]; k < pattern.columnStarts[column + 1]; ++k)
            response[static_cast<std::size_t>(pattern.rows[static_cast<std::size_t>(k)])] +=
                linear_.jacobian[static_cast<std::size_t>(k)] * rounding[column];
    solver_->solve(response);
    for (std::size_t n = 0; n < error_.size(); ++n) {
        const double left = std::max(0.0, std::abs(error_[n]) - std::abs(response[n]));
        error_[n] = std::copysign(left, error_[n]);
    }
}

// A step whose Jacobian was good is estimated from f(y0) and the stages; a second evaluation damps
// the estimate where stiff components dominate it.
double Radau::estimate() {
    for (std::size_t n = 0; n < error_.size(); ++n) {
        errorRates_[n] = (estimateWeight[0] * z_[0][n] + estimateWeight[1] * z_[1][n] +
                          estimateWeight[2] * z_[2][n]) /
                         h_;
        error_[n] = errorRates_[n] + slope_[n];
    }
    solver_->solve(error_);
    removeRounding();
    double error = control_.norm(error_);
    if (error >= 1 && (controller_.isFirst || controller_.isAfterRejection)) {
        for (std::size_t n = 0; n < error_.size(); ++n)
            at_[n] = start_[n] + error_[n];
        if (rates(t_, at_, error_)) {
            for (std::size_t n = 0; n < error_.size(); ++n)
                error_[n] += errorRates_[n];
            solver_->solve(error_);
            removeRounding();
            error = control_.norm(error_);
        }
    }
    return std::max({error, denseError(), 1e-10});
}

Attempt Radau::attempt(double h) {
    h_ = h;
    predict();
    for (std::size_t n = 0; n < end_.size(); ++n)
        end_[n] = start_[n] + (before_.step > 0 ? z_[2][n] : h * slope_[n]);
    control_.prepare(end_, h);
    const Newton result = solveStages();
    if (result != Newton::converged) {
        together_.unsolved = h;
        controller_.isAfterRejection = true;
        linear_.isFactored = false;
        newton_.rate = 1;
        const bool finite = result == Newton::failed;
        return {finite ? Attempt::Outcome::notConverged : Attempt::Outcome::notFinite,
                finite ? 0.5 * h : 0.25 * h};
    }
    for (std::size_t n = 0; n < end_.size(); ++n)
        end_[n] = start_[n] + z_[2][n];
    if (fixed_)
        return {Attempt::Outcome::accepted, h};
    control_.prepare(end_, h);
    return judge(estimate());
}

// Gustafsson's predictive controller; few Newton iterations allow a bolder step, and a step that
// would grow by less than a fifth is kept, with its factors.
Attempt Radau::judge(double error) {
    constexpr double safety = 0.9, most = 12;
    constexpr double shorter = 0.8, recovery = 1.05; // than what Newton did not solve
    const double bold = safety * (1 + 2 * most) / (static_cast<double>(newton_.count) + 2 * most);
    double quotient = std::clamp(std::pow(error, 0.25) / bold, 0.125, 5.0);
    if (!(error < 1)) {
        controller_.isAfterRejection = true;
        return {Attempt::Outcome::errorTooLarge, controller_.isFirst ? 0.1 * h_ : h_ / quotient};
    }
    if (controller_.step > 0) {
        const double predicted =
            (controller_.step / h_) * std::pow(error * error / controller_.error, 0.25) / safety;
        quotient = std::max(quotient, std::clamp(predicted, 0.125, 5.0));
    }
    controller_.step = h_;
    controller_.error = std::max(1e-2, error);
    double next = std::min(h_ / quotient, shorter * together_.unsolved);
    together_.unsolved *= recovery;
    if (controller_.isAfterRejection)
        next = std::min(next, h_);
    if (quotient <= 1 && quotient >= 1 / 1.2)
        next = h_;
    controller_.isAfterRejection = false;
    return {Attempt::Outcome::accepted, next};
}

void Radau::dense(std::span<Coefficients> columns) {
    const auto& basis = collocation; // for values at 0, c1, c2, 1
    for (std::size_t n = 0; n < columns.size(); ++n) {
        double k[4] = {h_ * startSlope_[n]}; // times h
        for (std::size_t i = 0; i < 3; ++i)
            k[i + 1] = slopeWeights[i][0] * z_[0][n] + slopeWeights[i][1] * z_[1][n] +
                       slopeWeights[i][2] * z_[2][n];
        endSlope_[n] = k[3] / h_;
        columns[n] = {start_[n]};
        for (std::size_t power = 0; power < 4; ++power)
            columns[n][power + 1] = (k[0] * basis[0][power] + k[1] * basis[1][power] +
                                     k[2] * basis[2][power] + k[3] * basis[3][power]) /
                                    static_cast<double>(power + 1);
    }
    quintics(
        columns, system_.integrals(),
        {.h = h_, .start = start_, .end = end_, .startSlope = startSlope_, .endSlope = endSlope_});
}

bool Radau::proceed(std::span<const double> y) {
    t_ += h_;
    for (std::size_t i = 0; i < 3; ++i)
        std::swap(before_.z[i], z_[i]);
    before_.step = h_;
    startSlope_ = endSlope_;
    start_.assign(y.begin(), y.end());
    controller_.isFirst = false;
    return rates(t_, y, slope_);
}

} // namespace solution
