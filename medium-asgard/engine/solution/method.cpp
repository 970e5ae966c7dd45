#include "solution/method.h"

#include "solution/diagonally_implicit.h"
#include "solution/explicit_runge_kutta.h"
#include "solution/radau.h"
#include "solution/rosenbrock.h"
#include "solution/step_doubling.h"
#include "solution/symplectic_euler.h"

#include <algorithm>
#include <cmath>

namespace solution {

namespace {

// The shortest time in which some unknown changes by its own size. A velocity that starts at rest
// has no size: then by what would move its position by the extent.
double timeScale(const ErrorControl& control, std::span<const double> rates) {
    double shortest = infinity;
    for (std::size_t i = 0; i < rates.size(); ++i) {
        const double rate = std::abs(rates[i]);
        if (rate == 0)
            continue;
        if (control.magnitude(i) > 0)
            shortest = std::min(shortest, control.magnitude(i) / rate);
        else if (control.extent() > 0)
            shortest = std::min(shortest, std::sqrt(control.extent() / rate));
    }
    return shortest;
}

} // namespace

// After Hairer, Norsett and Wanner (Solving ODEs I, II.4), with time scales in place of |y|/|f|:
// a hundredth of the time scale of y, then what the change of f over that allows.
double Method::firstStep(double limit) {
    const double scale = timeScale(control_, slope_);
    double h = std::min(scale < infinity ? 0.01 * scale : 1e-3, limit);
    std::vector<double> y(start_), f(start_.size());
    for (int tries = 0; tries < 60; ++tries) {
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = start_[i] + h * slope_[i];
        if (rates(t_ + h, y, f))
            break;
        h *= 0.25;
    }
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] = start_[i] + 0.5 * h * (slope_[i] + f[i]);
    control_.prepare(y, h);
    double change = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double d = std::abs(f[i] - slope_[i]) / h * control_.tolerance() / control_.scale(i);
        change = std::max(change, d); // about |y''| over the size of y
    }
    const double exponent = 1.0 / static_cast<double>(order());
    const double bend = std::sqrt(2 / std::max(change, 1e-30)); // when y'' has moved y by its size
    const double wanted = bend * std::pow(control_.tolerance(), exponent);
    return std::min({std::isfinite(wanted) ? wanted : h, 100 * h, limit});
}

namespace {

// With an estimate of its own a method controls its step; `fixed` is for the others, which
// StepDoubling then controls.
std::unique_ptr<Method> makeInner(const std::string& name, System& system, ErrorControl& control,
                                  bool fixed, bool& estimates) {
    if (const Tableau* table = tableauNamed(name)) {
        estimates = !table->error.empty();
        return std::make_unique<ExplicitRungeKutta>(*table, system, control, fixed || !estimates);
    }
    if (const DiagonalTableau* table = diagonalTableauNamed(name)) {
        estimates = !table->error.empty() || table->stepByNewton;
        return std::make_unique<DiagonallyImplicit>(*table, system, control, fixed || !estimates);
    }
    estimates = true;
    if (const RosenbrockTableau* table = rosenbrockTableauNamed(name))
        return std::make_unique<Rosenbrock>(*table, system, control, fixed);
    if (name == "radau5")
        return std::make_unique<Radau>(system, control, fixed);
    estimates = false;
    if (name == "symplectic-euler")
        return std::make_unique<SymplecticEuler>(system, control);
    return nullptr;
}

} // namespace

const std::vector<std::string>& methodNames() {
    static const std::vector<std::string> names = {
        "forward-euler", "symplectic-euler", "midpoint", "rk4", "trapezoidal", "backward-euler",
        "tsit5",         "dopri5",           "dop853",   "gbs", "tr-bdf2",     "radau5",
        "sdirk4",        "rodas4",           "original"};
    return names;
}

std::unique_ptr<Method> makeMethod(const std::string& name, System& system, ErrorControl& control,
                                   bool fixed) {
    bool estimates = false;
    std::unique_ptr<Method> method = makeInner(name, system, control, fixed, estimates);
    if (!method || fixed || estimates)
        return method;
    return std::make_unique<StepDoubling>(std::move(method), system, control);
}

} // namespace solution
