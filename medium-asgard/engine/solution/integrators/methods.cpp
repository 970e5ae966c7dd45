#include "integrators/methods.h"

#include "integrators/diagonally_implicit.h"
#include "integrators/explicit_runge_kutta.h"
#include "integrators/radau.h"
#include "integrators/rosenbrock.h"
#include "integrators/step_doubling.h"
#include "integrators/symplectic_euler.h"

namespace solution {

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
