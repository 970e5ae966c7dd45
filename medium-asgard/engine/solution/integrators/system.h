// A component as an integrator sees it: y' = f(t, y), and the Jacobian df/dy when it asks.
#pragma once

#include "expression/function.h"
#include "integrators/pattern.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace solution {

class System {
public:
    virtual ~System() = default;
    [[nodiscard]] virtual std::size_t size() const = 0;
    // False: some derivative has no finite value there.
    [[nodiscard]] virtual bool rates(double t, std::span<const double> y,
                                     std::span<double> derivatives) = 0;
    // Where y may be put for rates() to find it, which saves copying it; null: nowhere. Every call
    // of anything here may change what lies there.
    [[nodiscard]] virtual double* place() { return nullptr; }
    // The rates as machine code, of time and the states, which are put at `arguments`: what rates()
    // would give, but for whether they are finite. With a `reader`, putInputs() of that first, for
    // each time. No code: there is none, or none yet, or more to it. Calls of anything else here
    // may change what lies there.
    struct Direct {
        expression::Function::Code code;
        double *arguments = nullptr, *scratch = nullptr;
        System* reader = nullptr;
    };
    [[nodiscard]] virtual Direct direct() { return {}; }
    // The values of others at that time.
    virtual void putInputs(double /*t*/) {}
    [[nodiscard]] virtual const Pattern& jacobianPattern() = 0;
    [[nodiscard]] virtual bool jacobian(double t, std::span<const double> y,
                                        std::span<double> entries) = 0;
    // Pairs (x, v) for which x' = v holds exactly: positions and their velocities.
    [[nodiscard]] virtual std::span<const std::pair<std::size_t, std::size_t>> integrals() const {
        return {};
    }
    // Positions and attitudes, as against velocities: in order of place.
    [[nodiscard]] virtual std::span<const std::size_t> configuration() const { return {}; }
};

} // namespace solution
