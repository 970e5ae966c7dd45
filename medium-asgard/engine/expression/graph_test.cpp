#include "expression/graph.h"

#include "expression/parts.h"
#include "expression/rate_along.h"
#include "expression/tape.h"
#include "expression/testing.h"
#include "expression/visited.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace expression {
namespace {

using testing::parsed;

struct Row {
    std::string given, expected;
};

TEST(Simplify, LocalAlgebraAsAnAuthorWouldWriteIt) {
    const Row rows[] = {
        {"x*0 + y", "y"},
        {"0*q + 0/q - 0", "0"},
        {"x - x", "0"},
        {"x + x", "2*x"},
        {"x/x", "1"},
        {"--x", "x"},
        {"-(a - b)", "b - a"},
        {"a + -b", "a - b"},
        {"a - -b", "a + b"},
        {"-a + b", "b - a"},
        {"a + -2*b", "a - 2*b"},
        {"a - -2/b", "a + 2/b"},
        {"x + -3", "x - 3"},
        {"0 - x", "-x"},
        {"x*1", "x"},
        {"x*-1", "-x"},
        {"x*2", "2*x"},
        {"-x*-y", "x*y"},
        {"-x*y", "-x*y"},
        {"2*(3*x)", "6*x"},
        {"2*x*3*y", "6*x*y"},
        {"6*x/3", "2*x"},
        {"-10*3/3", "-10"},
        {"x/-2", "-x/2"},
        {"x*x*x", "x^3"},
        {"x^2*x", "x^3"},
        {"(x^2)^3", "x^6"},
        {"x^1 + x^0", "x + 1"},
        {"x^0.5", "sqrt(x)"},
        {"x^-1", "1/x"},
        {"x^-0.5", "1/sqrt(x)"},
        {"sqrt(x^2)", "sqrt(x^2)"},
        {"sin(-x) + cos(-x) + abs(-x)", "cos(x) - sin(x) + abs(x)"},
        {"1/2", "0.5"},
        {"2^3^2", "512"},
        {"-2^2", "-4"},
        {"2^-1", "0.5"},
        {"2**3", "8"},
        {"1 < 2 ? x : y", "x"},
        {"x < 0 ? y : y", "y"},
        {"min(x, x)", "x"},
        {"1 && x < 2", "x < 2"},
        {"0 || !(!(x < 2))", "x < 2"},
        {"x && 0", "0"},
        {"x > y", "y < x"},
        {"x >= y", "y <= x"},
        {"1/0", "1/0"},
        {"log(-1)", "log(-1)"},
        {"(x - 1000000) + 0.1", "x - 1000000 + 0.1"},
        {"pow(x, 3) + hypot(x, y, z)", "x^3 + hypot(hypot(x, y), z)"},
        {"hypot(x, y, 0)", "hypot(x, y)"},
        {"hypot(0, abs(x))", "abs(x)"},
        {"hypot(x, 0)", "hypot(x, 0)"},
        {"pi", "3.141592653589793"},
        {"B.x*A.mass", "B.x*A.mass"},
    };
    for (const Row& row : rows)
        EXPECT_EQ(testing::simplified(row.given), row.expected) << row.given;
}

// So that what switches at the same place is seen to.
TEST(Simplify, WritesSwitchesInOneWay) {
    const Row rows[] = {
        {"sign(3*(x - y))", "sign(x - y)"},
        {"sign(3*x - 3*y)", "sign(x - y)"},
        {"sign(-3*x + 3*y)", "-sign(x - y)"},
        {"sign((x - y)/-2)", "-sign(x - y)"},
        {"abs(3*x)", "3*abs(x)"},
        {"abs(-x)", "abs(x)"},
        {"max(0, 3*x)", "3*max(0, x)"},
        {"max(0, -3*x)", "-3*min(0, x)"},
        {"min(2*x, 2*y)", "2*min(x, y)"},
        {"min(2*x, 3*y)", "min(2*x, 3*y)"},
        {"max(1, 3*x)", "max(1, 3*x)"},
        {"3*x < 3*y", "x < y"},
        {"-3*x < -3*y", "y < x"},
        {"3*x > 0", "0 < x"},
        {"-3*x > 0", "x < 0"},
        {"3*x < 1", "3*x < 1"},
        {"sign(x*abs(x))", "sign(x)"},
        {"sign(sign(x)*sqrt(abs(x)))", "sign(x)"},
        {"sign(sign(x)*abs(x)^1.5)", "sign(x)"},
        {"sign(x^3)", "sign(x)"},
        {"sign(x^2)", "sign(x^2)"},
        {"sign(max(0, x)^2)", "sign(max(0, x))"},
        {"x*abs(x) > 0", "0 < x"},
        {"sign(x*abs(y))", "sign(x*abs(y))"},
        {"floor(-sign(x))", "-sign(x)"},
        {"x/abs(x)", "sign(x)"},
        {"-3*(2*x + y)*z/abs(2*x + y)", "-3*z*sign(2*x + y)"},
        {"-y*x/abs(2*x)", "-y*sign(x)/2"},
        {"x/abs(y)", "x/abs(y)"},
        {"-2*x/hypot(x, 0)", "-2*sign(x)"},
        {"x/hypot(x, y)", "x/hypot(x, y)"},
        {"2*x/(hypot(x, 0) + 1e-300)", "2*sign(x)"},
        {"x/(abs(x) + 1e-6)", "x/(abs(x) + 1e-06)"},
        {"-2*x/sqrt(x*x)", "-2*sign(x)"},
        {"x/sqrt((-x)^2)", "sign(x)"},
        {"-3*y*x/sqrt(4*x^2)", "-1.5*y*sign(x)"},
        {"-2*x*(x^2)^-0.5", "-2*sign(x)"},
        {"-2*(x^2)^-0.5*x", "-2*sign(x)"},
        {"x/sqrt(y^2)", "x/sqrt(y^2)"},
        {"-x^2*x/abs(x)", "-x^2*sign(x)"},
        {"x^2/hypot(x, 0)", "x*sign(x)"},
        {"x*(x^2 + y^2)^-0.5", "x*(1/sqrt(x^2 + y^2))"},
        {"ceil(2*floor(x) - (x < y))", "2*floor(x) - (x < y)"},
        {"floor(0.5*sign(x))", "floor(0.5*sign(x))"},
        {"floor(max(x, 1))", "floor(max(x, 1))"},
    };
    for (const Row& row : rows)
        EXPECT_EQ(testing::simplified(row.given), row.expected) << row.given;
}

TEST(Graph, EqualExpressionsAreOneNode) {
    Graph graph;
    EXPECT_EQ(parsed(graph, "a*b + sin(c)"), parsed(graph, "sin(c) + b*a"));
    EXPECT_EQ(parsed(graph, "2*x - 2*x"), graph.constant(0));
    const std::size_t before = graph.size();
    (void)parsed(graph, "sin(c) + a*b");
    EXPECT_EQ(graph.size(), before);
}

TEST(Graph, ParametersAreNumbersThatShapeNothing) {
    Graph graph;
    const Node x = graph.symbol("x"), owner = graph.symbol("owner");
    const Node none = graph.parameter(0, owner), half = graph.parameter(0.5, owner);
    EXPECT_NE(graph.add(x, none), x);
    EXPECT_NE(half, graph.constant(0.5));
    EXPECT_EQ(half, graph.parameter(0.5, owner));
    EXPECT_NE(half, graph.parameter(0.5, owner, 1));
    EXPECT_NE(half, graph.parameter(0.5, x));
    EXPECT_EQ(print(graph, graph.multiply(half, x)), "0.5*x");
    EXPECT_EQ(differentiate(graph, graph.multiply(half, x), x), half);
    EXPECT_TRUE(symbolsOf(graph, std::span(&half, 1)).empty());
    const Node sum = graph.add(graph.multiply(half, x), none);
    Tape::Scratch scratch;
    double three = 3, value = 0;
    Tape(graph, std::span(&x, 1), std::span(&sum, 1)).evaluate({&three, 1}, {&value, 1}, scratch);
    EXPECT_EQ(value, 1.5);
}

TEST(Graph, ConstantsThatAreNotFiniteStayQuotients) {
    Graph graph;
    EXPECT_EQ(print(graph, graph.constant(std::numeric_limits<double>::infinity())), "1/0");
    EXPECT_EQ(print(graph, graph.constant(-std::numeric_limits<double>::infinity())), "-1/0");
    EXPECT_EQ(print(graph, graph.constant(std::nan(""))), "0/0");
}

TEST(Print, UsesOnlyTheParenthesesThatAreNeeded) {
    const Row rows[] = {
        {"a - (b - c)", "a - (b - c)"},
        {"(a - b) - c", "a - b - c"},
        {"a/(b/c)", "a/(b/c)"},
        {"(a*b)/c", "a*b/c"},
        {"a*(b*c)", "a*(b*c)"},
        {"(a + b)*c", "(a + b)*c"},
        {"(-a)^2", "(-a)^2"},
        {"-a^2", "-a^2"},
        {"a^(-(b*c))", "a^-(b*c)"},
        {"a^b^c", "a^b^c"},
        {"(a^b)^c", "(a^b)^c"},
        {"(-2)^x", "(-2)^x"},
        {"-(a*b)", "-a*b"},
        {"-((a - b)*c)", "-((a - b)*c)"},
        {"!(a < b)", "!(a < b)"},
        {"(a ? b : c) ? d : e", "(a ? b : c) ? d : e"},
        {"a ? b : c ? d : e", "a ? b : c ? d : e"},
        {"(a < b) == (c < d)", "a < b == c < d"},
        {"a < (b == c)", "a < (b == c)"},
        {"a && (b || c)", "a && (b || c)"},
        {"2*(x/y)", "2*x/y"},
        {"-(a + b)", "-(a + b)"},
    };
    for (const Row& row : rows)
        EXPECT_EQ(testing::simplified(row.given), row.expected) << row.given;
}

TEST(Differentiate, AsATextbookWouldWriteIt) {
    const Row rows[] = {
        {"y", "0"},
        {"x", "1"},
        {"3*x + 2", "3"},
        {"x^3", "3*x^2"},
        {"x*y", "y"},
        {"1/x", "-1/x^2"},
        {"sin(x^2)", "2*cos(x^2)*x"},
        {"cos(2*x)", "-2*sin(2*x)"},
        {"exp(-x)", "-exp(-x)"},
        {"log(x)", "1/x"},
        {"sqrt(x)", "1/(2*sqrt(x))"},
        {"y^x", "log(y)*y^x"},
        {"abs(x)", "sign(x)"},
        {"sign(x) + floor(x)", "0"},
        {"min(x, y)", "x < y"},
        {"max(x, 2*y)", "2*y < x"},
        {"x < y ? x^2 : 3*x", "x < y ? 2*x : 3"},
        {"hypot(x, y)", "x/hypot(x, y)"},
        {"atan2(y, x)", "-y/(x^2 + y^2)"},
        {"tan(x)", "1 + tan(x)^2"},
        {"tanh(x)", "1 - tanh(x)^2"},
    };
    for (const Row& row : rows) {
        Graph graph;
        const Node derivative = differentiate(graph, parsed(graph, row.given), graph.symbol("x"));
        EXPECT_EQ(print(graph, derivative), row.expected) << row.given;
    }
}

TEST(Substitute, ReplacesSymbolsAtOnceAndSimplifies) {
    Graph graph;
    const Node x = graph.symbol("x"), y = graph.symbol("y");
    const Node swapped = substitute(graph, parsed(graph, "x - 2*y"), {{x.index, y}, {y.index, x}});
    EXPECT_EQ(print(graph, swapped), "y - 2*x");
    const Node gone = substitute(graph, parsed(graph, "x*y + 1"), {{x.index, graph.constant(0)}});
    EXPECT_EQ(print(graph, gone), "1");
    const Node both[] = {parsed(graph, "x*y + 1"), y, x};
    const auto replaced = substitute(graph, both, {{x.index, graph.constant(0)}});
    EXPECT_EQ(print(graph, replaced[0]), "1");
    EXPECT_EQ(replaced[1], y);
    EXPECT_EQ(replaced[2], graph.constant(0));
}

// Each node once, and in which of the formulas it is; x is left out, and what only x reads.
TEST(PartsOf, NameTheFormulasThatReadANode) {
    Graph graph;
    const Node x = parsed(graph, "sin(c)");
    const std::vector<std::vector<Node>> formulas{
        {parsed(graph, "a*b"), parsed(graph, "a + sin(c)")}, {parsed(graph, "a*b + d")}, {}};
    std::string found;
    for (const auto& [node, bits] : partsOf(graph, formulas, [&](Node n) { return n == x; })) {
        found += print(graph, node) + ":";
        eachFormula(bits, [&](std::size_t f) { found += " " + std::to_string(f); });
        found += "; ";
    }
    EXPECT_EQ(found, "a*b + d: 1; d: 1; a + sin(c): 0; a*b: 0 1; b: 0 1; a: 0 1; ");
    EXPECT_TRUE(partsOf(graph, {}).empty());
}

TEST(SymbolsOf, NamesWhatIsReadAndNothingElse) {
    Graph graph;
    const Node nodes[] = {parsed(graph, "b + 0*c"), parsed(graph, "a*b")};
    std::string names;
    for (const Node n : symbolsOf(graph, nodes))
        names += graph.name(n) + ' ';
    EXPECT_EQ(names, "b a ");
}

// A walk within a walk, and one after both, know nothing of each other.
TEST(Visited, SeesEachNodeOnceInEachWalk) {
    const Node few{3}, many{5000};
    for (int walk = 0; walk < 3; ++walk) {
        Visited seen;
        EXPECT_TRUE(seen.insert(few));
        {
            Visited within;
            EXPECT_TRUE(within.insert(many));
            EXPECT_TRUE(within.insert(few));
            EXPECT_FALSE(within.insert(many));
        }
        EXPECT_TRUE(seen.insert(many));
        EXPECT_FALSE(seen.insert(few));
    }
}

// Few nodes far apart are put in order by comparing, many side by side by a bit for each.
TEST(Reachable, IsInOrderOfIndexHoweverTheNodesLie) {
    Graph graph;
    const Node far = parsed(graph, "a*b");
    Node sum = graph.constant(1);
    for (int i = 0; i < 3000; ++i)
        sum = graph.add(graph.symbol("s" + std::to_string(i)), graph.multiply(sum, sum));
    const Node late = parsed(graph, "a + c");
    const Node apart[] = {late, far};
    const std::vector<Node> few = reachable(graph, apart),
                            all = reachable(graph, std::span(&sum, 1));
    EXPECT_EQ(few.size(), 5u);
    EXPECT_TRUE(std::ranges::is_sorted(few));
    EXPECT_GT(all.size(), 9000u);
    EXPECT_TRUE(std::ranges::is_sorted(all));
    EXPECT_EQ(std::ranges::adjacent_find(all), all.end());
}

// 100,000 bytes of one sum are about 50,000 levels of a graph.
TEST(Graph, DepthDoesNotExhaustTheStack) {
    Graph graph;
    Node sum = graph.symbol("x");
    for (int i = 0; i < 50'000; ++i)
        sum = graph.apply(i % 2 ? Op::sin : Op::cos, graph.add(sum, graph.constant(i + 1)));
    const Node x = graph.symbol("x");
    EXPECT_GT(print(graph, sum).size(), 400'000u);
    EXPECT_NE(differentiate(graph, sum, x), graph.constant(0));
    EXPECT_EQ(symbolsOf(graph, std::span(&sum, 1)).size(), 1u);
    EXPECT_NE(substitute(graph, sum, {{x.index, graph.symbol("y")}}), sum);
}

TEST(Gradients, HaveOneRateAlongAWay) {
    Graph graph;
    const Node roots[] = {parsed(graph, "sin(x*y) + z"), parsed(graph, "7"), parsed(graph, "z")};
    const Node symbols[] = {graph.symbol("x"), graph.symbol("y")};
    const Node rates[] = {graph.symbol("u"), graph.constant(1)};
    const auto along = ratesAlong(graph, roots, symbols, rates);
    ASSERT_EQ(along.size(), 3u);
    EXPECT_EQ(print(graph, along[0]), "cos(x*y)*(u*y + x)");
    EXPECT_EQ(along[1], graph.constant(0));
    EXPECT_EQ(along[2], graph.constant(0)); // z does not change
}

// The rows of a Jacobian are the derivatives one by one; what roots share is derived once.
TEST(Gradients, AreTheDerivativesThatAreNotZeroInTheOrderOfTheSymbols) {
    Graph graph;
    const Node roots[] = {parsed(graph, "y*sin(x*y) + z"), parsed(graph, "7"),
                          parsed(graph, "sin(x*y)^2")};
    const Node symbols[] = {graph.symbol("z"), graph.symbol("y"), graph.symbol("x")};
    const auto rows = gradients(graph, roots, symbols);
    const std::size_t size = graph.size();
    ASSERT_EQ(rows.size(), 3u);
    std::string text;
    for (std::size_t row = 0; row < 3; ++row)
        for (const auto& [symbol, derivative] : rows[row]) {
            EXPECT_EQ(differentiate(graph, roots[row], symbols[symbol]), derivative);
            text += std::to_string(row) + " by " + graph.name(symbols[symbol]) + ": " +
                    print(graph, derivative) + '\n';
        }
    EXPECT_EQ(text, "0 by z: 1\n"
                    "0 by y: sin(x*y) + y*(cos(x*y)*x)\n"
                    "0 by x: y*(cos(x*y)*y)\n"
                    "2 by y: 2*sin(x*y)*(cos(x*y)*x)\n"
                    "2 by x: 2*sin(x*y)*(cos(x*y)*y)\n");
    EXPECT_EQ(graph.size(), size); // nothing was new
}

TEST(Graph, CopiesGoTheirOwnWays) {
    Graph graph;
    Node sum = graph.symbol("x");
    for (int i = 1; i < 1000; ++i) // more than one block
        sum = graph.apply(Op::sin, graph.add(sum, graph.constant(i)));
    Graph copy = graph;
    EXPECT_EQ(copy.apply(Op::cos, sum).index, graph.size());
    EXPECT_EQ(copy.size(), graph.size() + 1);
    EXPECT_EQ(graph.apply(Op::tan, sum).index, copy.size() - 1);
    EXPECT_EQ(graph.op(Node{static_cast<std::uint32_t>(graph.size() - 1)}), Op::tan);
    EXPECT_EQ(copy.op(Node{static_cast<std::uint32_t>(copy.size() - 1)}), Op::cos);
    EXPECT_EQ(copy.symbol("x"), graph.symbol("x"));
}

} // namespace
} // namespace expression
