// For tests: a network of a few components, without a solver.
#pragma once

#include "solution/network.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <memory>
#include <utility>
#include <vector>

namespace solution::testing {

inline std::shared_ptr<const PreparedEquations> preparedNetwork(const Options& options) {
    return std::make_shared<const PreparedEquations>(
        std::make_shared<const expression::EquationSet>(equationsOf({{"x", "v", 1, 1},
                                                                     {"v", "w-v", 2},
                                                                     {"w", "-w", 3},
                                                                     {"alone", "1", 4},
                                                                     {"flat", "spin", 0, 1},
                                                                     {"spin", "0", 0}})),
        preparationFor(options));
}

struct NetworkTest : ::testing::Test {
    // x reads v, v reads w; nobody reads alone, and nothing moves flat, by its rate spin.
    enum Unknowns : std::size_t { x, v, w, alone, flat, spin };

    explicit NetworkTest(const Options& options = {})
        : network(preparedNetwork(options), options) {}
    Network network;

    [[nodiscard]] std::vector<std::size_t> componentsOf(std::vector<std::size_t> unknowns) const {
        for (std::size_t& u : unknowns)
            u = network.componentOf[u];
        return unknowns;
    }
    [[nodiscard]] static Event at(double time, std::size_t unknown) {
        return {.time = time, .touched = {unknown}, .tag = 0};
    }
    void stepTo(double time) {
        for (const std::size_t unknown : {w, v, x, alone})
            for (Component& component = *network.components[network.componentOf[unknown]];
                 component.time() < time;)
                network.readyFor(component).step();
    }
};

} // namespace solution::testing
