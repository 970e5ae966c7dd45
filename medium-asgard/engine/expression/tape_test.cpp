#include "expression/tape.h"

#include "expression/random_expressions.h"
#include "expression/testing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace expression {
namespace {

using namespace testing;

TEST(Tape, AgreesWithAnExplanationNodeByNodeInfiniteAndUndefinedValuesIncluded) {
    RandomExpressions random(1);
    Tape::Scratch scratch;
    int notNumbers = 0;
    for (int i = 0; i < repetitions(10'000); ++i) {
        Xyz s;
        const Node n = random.make(s.graph, 5);
        const double in[] = {random.number(), random.number(), random.number()};
        double out = 0;
        Tape(s.graph, s.symbols, std::span(&n, 1)).evaluate(in, std::span(&out, 1), scratch);
        const double expected = explained(s.graph, n, s.symbols, in);
        notNumbers += !std::isfinite(expected);
        ASSERT_TRUE(isSame(out, expected))
            << print(s.graph, n) << " is " << expected << ", the tape says " << out << " at "
            << in[0] << ' ' << in[1] << ' ' << in[2];
    }
    EXPECT_GT(notNumbers, repetitions(1000)); // the test means something
}

TEST(Print, ReadsBackToTheSameNode) {
    RandomExpressions random(2);
    for (int i = 0; i < repetitions(10'000); ++i) {
        Graph graph;
        const Node n = random.make(graph, 5);
        const std::string text = print(graph, n);
        ASSERT_EQ(parsed(graph, text), n) << text << "\n" << print(graph, parsed(graph, text));
    }
}

TEST(Print, ReadsBackWhereNumbersAreTooSmallToBeJoined) {
    for (const char* text : {"5e-324*x*3", "3*x*1e-310", "2*(1e-310*x)", "x/8/53/1e-320",
                             "2*x/8/53/1e-320", "x*1e-310/7/3", "-3*(-5e-324*(x*y))"}) {
        Graph graph;
        const Node n = parsed(graph, text);
        EXPECT_EQ(parsed(graph, print(graph, n)), n) << text << " is " << print(graph, n);
    }
}

TEST(Tape, SmallPowersAreWithinThreeUnitsInTheLastPlace) {
    for (const double exponent :
         {-4., -3.5, -3., -2.5, -2., -1.5, -1., -0.5, 0.5, 1.5, 2.5, 3., 4.})
        for (double base = 0.013; base < 50; base *= 1.37) {
            Xyz s;
            const Node n = s.graph.apply(Op::power, s.symbols[0], s.graph.constant(exponent));
            const double in[] = {base, 0, 0};
            double out = 0;
            Tape::Scratch scratch;
            Tape(s.graph, s.symbols, std::span(&n, 1)).evaluate(in, std::span(&out, 1), scratch);
            const auto exact = std::pow(static_cast<long double>(base), exponent);
            EXPECT_NEAR(static_cast<double>(out / exact - 1), 0, 3 * 1.2e-16)
                << base << '^' << exponent;
        }
}

// Central differences of a smooth expression, against the symbolic derivative.
TEST(Differentiate, AgreesWithFiniteDifferences) {
    RandomExpressions random(3, false);
    Tape::Scratch scratch;
    int compared = 0;
    for (int i = 0; i < repetitions(5000); ++i) {
        Xyz s;
        const Node n = random.make(s.graph, 3);
        const Node outputs[] = {n, differentiate(s.graph, n, s.symbols[0])};
        const Tape tape(s.graph, s.symbols, outputs);
        const double h = 1e-5, x = random.number();
        double in[] = {x, random.number(), random.number()}, out[2], at[2], below[2], above[2];
        tape.evaluate(in, out, scratch);
        const double slope = out[1];
        std::vector<Decision> branch(tape.decisions());
        tape.decide(in, branch, {}, scratch);
        if (std::ranges::count(branch, 0) > 0)
            continue; // on a switch there is no slope
        // The slope far away bounds how much a straight line may be off.
        const auto evaluateAt = [&](double place, double* values) {
            in[0] = place;
            tape.evaluate(in, std::span(values, 2), scratch, branch, {});
        };
        evaluateAt(x, at);
        evaluateAt(x - h, below);
        evaluateAt(x + h, above);
        const double bend = std::abs(below[1] - slope) + std::abs(above[1] - slope);
        const double size = std::abs(out[0]) + std::abs(slope);
        const double step = std::abs(above[0] - at[0]) + std::abs(below[0] - at[0]);
        const bool isJump = !(step < 0.3); // across a pole; h times the slopes allowed is 0.1
        if (isJump || !std::isfinite(bend) || !std::isfinite(size) || size > 1e4 ||
            bend > 1e-3 * (1 + size) || at[0] != out[0])
            continue;
        ++compared;
        ASSERT_NEAR((above[0] - below[0]) / (2 * h), slope, bend + 1e-5 * (1 + size))
            << print(s.graph, n) << "\nd/dx " << print(s.graph, outputs[1]) << " at " << x << ' '
            << in[1] << ' ' << in[2];
    }
    EXPECT_GT(compared, repetitions(2000));
}

TEST(Tape, EvaluatesSharedSubexpressionsOnce) {
    Xyz s;
    const Node outputs[] = {parsed(s.graph, "sin(x*y) + 2"), parsed(s.graph, "sin(x*y)*z")};
    const Tape tape(s.graph, s.symbols, outputs);
    EXPECT_EQ(tape.print(), "r0 = * in0 in1\n"
                            "r1 = sin r0\n"
                            "r2 = + r1 2\n"
                            "r3 = * r1 in2\n"
                            "out0 = r2\n"
                            "out1 = r3\n");
    EXPECT_EQ(tape.operations(), 4u);
}

TEST(Tape, OutputsMayBeInputsAndConstants) {
    Xyz s;
    const Node outputs[] = {s.symbols[1], s.graph.constant(7), s.symbols[1]};
    const double in[] = {1, 2, 3};
    double out[3];
    Tape::Scratch scratch;
    Tape(s.graph, s.symbols, outputs).evaluate(in, out, scratch);
    EXPECT_EQ(std::vector(out, out + 3), (std::vector<double>{2, 7, 2}));
}

struct SwitchRow {
    const char* text;
    double at; // where the branch is decided
    Decision decision;
    double guard; // there
    double away;  // where it is then evaluated
    double value, guardAway;
};

// The branch stays as decided while the guard tells that it was left.
TEST(Tape, FrozenBranchesAreSmoothAndTheirGuardsChangeSign) {
    const SwitchRow rows[] = {
        {"abs(x)", -1, -1, -1, 2, -2, 2},
        {"abs(x)", 1, 1, 1, -2, -2, -2},
        {"abs(x)", 0, 0, 0, -2, 2, -2},
        {"sign(x)", -1, -1, -1, 2, -1, 2},
        {"min(x, 1)", 0, -1, -1, 3, 3, 2},
        {"max(x, 1)", 0, -1, -1, 3, 1, 2},
        {"x < 1 ? 10 : 20", 0, -1, -1, 3, 10, 2},
        {"x >= 1 ? 10 : 20", 3, -1, -2, 0, 10, 1},
        {"x == 1", 1, 0, 0, 3, 1, 2},
        {"x != 1", 0, -1, -1, 1, 1, 0},
        {"floor(x)", 2.25, 2, 0.25, 3.5, 2, -0.5},
        {"ceil(x)", 2.25, 3, 0.25, 3.5, 3, -0.5},
        {"floor(x)", -0.5, -1, 0.5, 1, -1, -1},
        {"floor(x)", 1e300, noBranch, 1, 2.5, 2, 1},
    };
    for (const SwitchRow& row : rows) {
        Graph graph;
        const Node x = graph.symbol("x"), n = parsed(graph, row.text);
        const Tape tape(graph, std::span(&x, 1), std::span(&n, 1));
        ASSERT_EQ(tape.decisions(), 1u) << row.text;
        Tape::Scratch scratch;
        Decision decision = 77;
        double guard = 77, value = 77;
        tape.decide(std::span(&row.at, 1), std::span(&decision, 1), std::span(&guard, 1), scratch);
        EXPECT_EQ(decision, row.decision) << row.text;
        EXPECT_EQ(guard, row.guard) << row.text;
        tape.evaluate(std::span(&row.away, 1), std::span(&value, 1), scratch,
                      std::span(&decision, 1), std::span(&guard, 1));
        EXPECT_EQ(value, row.value) << row.text;
        EXPECT_EQ(guard, row.guardAway) << row.text;
    }
}

TEST(Tape, BranchesThatTheValuesImplyChangeNothing) {
    RandomExpressions random(4);
    Tape::Scratch scratch;
    for (int i = 0; i < repetitions(5000); ++i) {
        Xyz s;
        const Node n = random.make(s.graph, 5);
        const Tape tape(s.graph, s.symbols, std::span(&n, 1));
        const double in[] = {random.number(), random.number(), random.number()};
        std::vector<Decision> decisions(tape.decisions());
        tape.decide(in, decisions, {}, scratch);
        double free = 0, frozen = 0;
        tape.evaluate(in, std::span(&free, 1), scratch);
        tape.evaluate(in, std::span(&frozen, 1), scratch, decisions, {});
        ASSERT_TRUE(isSame(free, frozen)) << print(s.graph, n) << ' ' << free << ' ' << frozen;
    }
}

} // namespace
} // namespace expression
