// Which switches do outputs read on the branches that are in force? The others are none.
#include "equations/surfaces.h"
#include "solution/solver_testing.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace solution;
using namespace solution::testing;

namespace {

// Guards that are read where the symbols have these values, in order.
std::vector<std::string> guardsRead(const std::string& text, double x, double y) {
    expression::Graph graph;
    const expression::Node node = expression::testing::parsed(graph, text);
    const std::vector<Surface> surfaces = surfacesOf(graph, {&node, 1});
    const std::vector<expression::Node> inputs = {graph.symbol("x"), graph.symbol("y")};
    const expression::Tape tape(graph, inputs, {&node, 1});
    std::vector<expression::Decision> branches(tape.decisions());
    std::vector<double> guards(tape.decisions());
    expression::Tape::Scratch scratch;
    tape.decide(std::vector<double>{x, y}, branches, guards, scratch);
    const ReadSurfaces reads(graph, {&node, 1}, surfaces);
    const std::vector<bool> read = reads.on(branches);
    std::vector<std::string> names;
    for (std::size_t s = 0; s < surfaces.size(); ++s)
        if (!reads.mayVary() || read[s])
            names.push_back(print(graph, surfaces[s].guard));
    return names;
}

using Names = std::vector<std::string>;

TEST(ReadSurfaces, LieInTheBranchesInForce) {
    EXPECT_EQ(guardsRead("x>0 ? max(0,y) : 0", 1, 1).size(), 2u);
    EXPECT_EQ(guardsRead("x>0 ? max(0,y) : 0", -1, 1), Names{"x"});
    EXPECT_EQ(guardsRead("(x>0)*abs(y)", -1, 1), Names{"x"});
    EXPECT_EQ(guardsRead("(x>0)*abs(y)", 1, 1).size(), 2u);
    EXPECT_EQ(guardsRead("(x>0 && y>1 ? sign(x-7) : 2)", -1, 1).size(), 2u);
    EXPECT_EQ(guardsRead("(x>0 || y>1 ? sign(x-7) : abs(y-3))", 1, 1).size(), 3u);
}

TEST(ReadSurfaces, AreAllOfThoseThatGuardsOrOtherOutputsRead) {
    EXPECT_EQ(guardsRead("max(x,y) + (x>0 ? abs(y) : 1)", -1, 1).size(), 2u);
    EXPECT_EQ(guardsRead("max(x,y) + (x>0 ? abs(y) : 1)", 1, 1).size(), 3u);
    EXPECT_EQ(guardsRead("(x>0 ? abs(y) : 1) + abs(y)", -1, 1).size(), 2u);
    EXPECT_EQ(guardsRead("max(x, abs(y))", 5, 1).size(), 2u); // the maximum's own guard reads it
}

// y swings about 0 while x decides that nobody asks: no switch is passed, no step is cut.
TEST(ReadSurfaces, OthersCutNoSteps) {
    const auto switches = [](const std::string& rate) {
        const Solver solver =
            solved(equationsOf({{"y", "dy", 1}, {"dy", "-400*y", 0}, {"x", rate, -1}}), 3,
                   tolerance(1e-6));
        EXPECT_EQ(solver.histories().stop(2), nullptr);
        return solver.statistics().switches;
    };
    EXPECT_EQ(switches("0.1+(x>0 ? max(0,y) : 0)"), 0u);
    EXPECT_GT(switches("0.1+(x<0 ? max(0,y) : 0)"), 10u);
}

// The side of a switch that is asked for again follows from its value there.
TEST(ReadSurfaces, AreOnTheirSideWhenTheyAreReadAgain) {
    // x' = 1 where x < 1; then |cos(20 t)|, whose sign has changed six times meanwhile.
    const Solver solver =
        solved(equationsOf({{"x", "x<1 ? 1 : abs(cos(20*t))", 0}}), 2, tolerance(1e-9));
    double exact = 1;
    constexpr int parts = 2'000'000;
    for (int i = 0; i < parts; ++i)
        exact += std::abs(std::cos(20 * (1 + (i + 0.5) / parts))) / parts;
    EXPECT_NEAR(solver.histories().value(0, 2), exact, 1e-8);
}

} // namespace
