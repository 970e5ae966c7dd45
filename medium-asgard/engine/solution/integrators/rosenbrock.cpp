#include "integrators/rosenbrock.h"

#include "dense/dense_output.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace solution {

namespace {

// Hairer and Wanner II, IV.10 (RODAS): six stages, stiffly accurate, order 4 with 3, dense order 3.
RosenbrockTableau makeRodas4() {
    RosenbrockTableau t{.name = "rodas4", .order = 4, .errorOrder = 3, .diagonal = 0.25};
    t.alpha = {0, 0.386, 0.21, 0.63, 1, 1};
    t.gamma = {0.25, -0.1043, 0.1035, -0.3620000000000023e-1, 0, 0};
    t.a = {{},
           {1.544},
           {0.9466785280815826, 0.2557011698983284},
           {3.314825187068521, 2.896124015972201, 0.9986419139977817},
           {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950},
           {1.221224509226641, 6.019134481288629, 12.53708332932087, -0.6878860361058950, 1}};
    t.c = {{},
           {-5.6688},
           {-2.430093356833875, -0.2063599157091915},
           {-0.1073529058151375, -9.594562251023355, -20.47028614809616},
           {7.496443313967647, -10.24680431464352, -33.99990352819905, 11.70890893206160},
           {8.083246795921522, -7.981132988064893, -31.52159432874371, 16.31930543123136,
            -6.058818238834054}};
    t.m = t.a.back();
    t.m.push_back(1);
    t.error = {0, 0, 0, 0, 0, 1};
    t.p = {10.12623508344586,  -7.487995877610167, -34.80091861555747,
           -7.992771707568823, 1.025137723295662,  0};
    t.q = {-0.6762803392806898, 6.087714651680015,  16.43084320892478,
           24.76722511418386,   -6.594389125716872, 0};
    return t;
}

} // namespace

const RosenbrockTableau* rosenbrockTableauNamed(const std::string& name) {
    static const RosenbrockTableau rodas4 = makeRodas4();
    return name == rodas4.name ? &rodas4 : nullptr;
}

Rosenbrock::Rosenbrock(const RosenbrockTableau& tableau, System& system, ErrorControl& control,
                       bool fixed)
    : Method(system, control, fixed), tableau_(tableau),
      solver_(std::make_unique<LinearSolver>(system.jacobianPattern())),
      jacobian_(system.jacobianPattern().entries()),
      u_(tableau.m.size(), std::vector<double>(system.size())), timeSlope_(system.size()),
      at_(system.size()), error_(system.size()) {
    end_.resize(system.size());
    slope_.resize(system.size());
}

bool Rosenbrock::begin(double t, std::span<const double> y) {
    t_ = t;
    start_.assign(y.begin(), y.end());
    linearized_ = afterRejection_ = false;
    return rates(t, y, slope_);
}

// The derivative by time is a difference over a root of the resolution, as RODAS takes it.
bool Rosenbrock::linearize() {
    if (linearized_)
        return true;
    const double difference = std::min(
        h_, std::sqrt(std::numeric_limits<double>::epsilon() * std::max(1e-5, std::abs(t_))));
    const double later = t_ + difference;
    if (!rates(later, start_, timeSlope_))
        return false;
    for (std::size_t n = 0; n < timeSlope_.size(); ++n)
        timeSlope_[n] = (timeSlope_[n] - slope_[n]) / (later - t_);
    ++counts_.jacobians;
    linearized_ = system_.jacobian(t_, start_, jacobian_);
    return linearized_;
}

double Rosenbrock::combination(std::span<const double> weights, std::size_t n) const {
    double sum = 0;
    for (std::size_t j = 0; j < weights.size(); ++j)
        sum += weights[j] * u_[j][n];
    return sum;
}

bool Rosenbrock::stage(std::size_t i) {
    std::vector<double>& u = u_[i];
    if (i == 0) {
        u = slope_;
    } else {
        for (std::size_t n = 0; n < at_.size(); ++n)
            at_[n] = start_[n] + combination(tableau_.a[i], n);
        if (!rates(t_ + tableau_.alpha[i] * h_, at_, u))
            return false;
    }
    for (std::size_t n = 0; n < at_.size(); ++n)
        u[n] += combination(tableau_.c[i], n) / h_ + tableau_.gamma[i] * h_ * timeSlope_[n];
    solver_->solve(u);
    return true;
}

Attempt Rosenbrock::attempt(double h) {
    h_ = h;
    bool good = linearize();
    if (good) {
        ++counts_.factorisations;
        good = solver_->factor(jacobian_, 1 / (h * tableau_.diagonal));
    }
    for (std::size_t i = 0; i < u_.size() && good; ++i)
        good = stage(i);
    if (!good) {
        afterRejection_ = true;
        return {Attempt::Outcome::notFinite, 0.25 * h};
    }
    for (std::size_t n = 0; n < end_.size(); ++n) {
        end_[n] = start_[n] + combination(tableau_.m, n);
        error_[n] = combination(tableau_.error, n);
    }
    if (fixed_)
        return {Attempt::Outcome::accepted, h};
    control_.prepare(end_, h);
    const double error = control_.norm(error_);
    const double exponent = -1 / static_cast<double>(tableau_.errorOrder + 1);
    const double factor =
        std::isfinite(error) ? 0.9 * std::pow(std::max(error, 1e-10), exponent) : 0.2;
    if (!(error <= 1)) {
        afterRejection_ = true;
        return {Attempt::Outcome::errorTooLarge, h * std::clamp(factor, 0.2, 0.9)};
    }
    const double most = afterRejection_ ? 1.0 : 6.0;
    afterRejection_ = false;
    return {Attempt::Outcome::accepted, h * std::clamp(factor, 0.2, most)};
}

void Rosenbrock::dense(std::span<Coefficients> columns) {
    for (std::size_t n = 0; n < columns.size(); ++n) {
        const double rise = end_[n] - start_[n];
        const double p = combination(tableau_.p, n), q = combination(tableau_.q, n);
        columns[n] = {start_[n], rise + p, q - p, -q};
    }
    const StepEnds ends{.h = h_, .start = start_, .end = end_, .startSlope = {}, .endSlope = {}};
    integratePositions(columns, system_.integrals(), ends);
}

bool Rosenbrock::proceed(std::span<const double> y) {
    t_ += h_;
    start_.assign(y.begin(), y.end());
    linearized_ = false;
    return rates(t_, y, slope_);
}

} // namespace solution
