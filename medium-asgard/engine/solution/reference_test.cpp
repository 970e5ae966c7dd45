// Problems with published or independently computed values (tests/reference).
#include "solution/solver_testing.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

using namespace solution;
using namespace solution::testing;

namespace {

nlohmann::json problem(const std::string& name) {
    std::ifstream file(SOURCE_DIR "/tests/reference/f03_first_order_ivp_values.json");
    const nlohmann::json all = nlohmann::json::parse(file);
    for (const auto& entry : all["problems"])
        if (entry["name"] == name)
            return entry;
    throw std::runtime_error("no problem " + name);
}

void expectValues(const Solver& solver, const nlohmann::json& reference, double relative,
                  double absolute) {
    const double end = reference["t_end"];
    for (std::size_t i = 0; i < reference["values"].size(); ++i) {
        const double exact = reference["values"][i];
        EXPECT_NEAR(solver.histories().value(i, end), exact, relative * std::abs(exact) + absolute)
            << i;
    }
}

expression::EquationSet hires() {
    return equationsOf({{"y1", "-1.71*y1+0.43*y2+8.32*y3+0.0007", 1},
                        {"y2", "1.71*y1-8.75*y2", 0},
                        {"y3", "-10.03*y3+0.43*y4+0.035*y5", 0},
                        {"y4", "8.32*y2+1.71*y3-1.12*y4", 0},
                        {"y5", "-1.745*y5+0.43*y6+0.43*y7", 0},
                        {"y6", "-280*y6*y8+0.69*y4+1.71*y5-0.43*y6+0.69*y7", 0},
                        {"y7", "280*y6*y8-1.81*y7", 0},
                        {"y8", "-280*y6*y8+1.81*y7", 0.0057}});
}

expression::EquationSet robertson() {
    return equationsOf({{"y1", "-0.04*y1+1e4*y2*y3", 1},
                        {"y2", "0.04*y1-1e4*y2*y3-3e7*y2^2", 0},
                        {"y3", "3e7*y2^2", 0}});
}

} // namespace

TEST(Reference, Hires) {
    for (const char* method : {"radau5", "auto"})
        for (const double accuracy : {1e-5, 1e-8}) {
            Options options = tolerance(accuracy);
            options.method = method;
            const auto reference = problem("HIRES");
            expectValues(solved(hires(), reference["t_end"], options), reference, 0, 10 * accuracy);
        }
}

// Over 1e11 seconds; the values themselves fall to 1e-13.
TEST(Reference, Robertson) {
    for (const char* method : {"radau5", "auto"}) {
        Options options = tolerance(1e-9);
        options.method = method;
        const auto reference = problem("Robertson");
        const Solver solver = solved(robertson(), reference["t_end"], options);
        expectValues(solver, reference, 1e-3, 0);
        EXPECT_LT(solver.statistics().steps, 6000u) << method;
    }
}

// Values at the times of f02_vanderpol_mu1000.ref.csv.
TEST(Reference, VanDerPolWithMu1000) {
    const double times[] = {500, 900, 1500, 2000};
    const double values[] = {1.5967689510526617598, -1.9364435447958141283, -1.3547459194866034679,
                             1.7061677321704650085};
    for (const double accuracy : {1e-4, 1e-6, 1e-8}) {
        const Solver solver =
            solved(equationsOf({{"x", "dx", 2, 1}, {"dx", "1000*(1-x^2)*dx-x", 0}}), 2000,
                   tolerance(accuracy));
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(solver.histories().value(0, times[k]), values[k], 50 * accuracy)
                << times[k] << " " << accuracy;
        EXPECT_LT(solver.statistics().evaluations, 60000u);
    }
}
