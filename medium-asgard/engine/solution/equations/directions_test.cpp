#include "equations/directions.h"

#include "expression/testing.h"

#include <gtest/gtest.h>

using namespace solution;
using expression::Graph;
using expression::Node;
using expression::testing::parsed;

namespace {

// Its directions, each with its parts and weights.
std::string directionsOf(const std::string& text) {
    Graph graph;
    const Node node = parsed(graph, text);
    const auto isNumber = [&](Node n) { return graph.op(n) == expression::Op::constant; };
    std::string found;
    for (const Node length : lengthsDividedBy(graph, std::span(&node, 1))) {
        const auto direction = directionOf(graph, length, isNumber);
        found += direction ? "[" : "none ";
        for (std::size_t k = 0; direction && k < direction->parts.size(); ++k) {
            const Direction::Part& part = direction->parts[k];
            found += (k > 0 ? " " : "") + expression::print(graph, part.node);
            found += part.weight ? "*" + expression::print(graph, *part.weight) : "";
        }
        found += direction ? "] " : "";
    }
    return found;
}

} // namespace

TEST(Directions, AreFoundInTheWaysInWhichTheyAreWritten) {
    const std::pair<std::string, std::string> cases[] = {
        {"-0.4*9.81*u/hypot(u,v)", "[u v] "},
        {"-u/sqrt(u*u+v*v)", "[u v] "},
        {"-u/sqrt(u^2+v^2)", "[u v] "},
        {"-u/(m*sqrt(u*u+v*v))", "[u v] "},
        {"-(1/hypot(u,v))*u", "[u v] "},
        {"w-0.3*u/hypot(u,v,w)", "[u v w] "},
        {"(u-p)/hypot(u-p,v-q)", "[u - p v - q] "},
        {"u/hypot(u,2*v)", "[u v*4] "},
        {"u/sqrt(u*u+3*v*v)", "[u v*3] "},
        {"u/hypot(u,v,1e-3)", "none "},
        {"u/sqrt(u*u+v*v+1e-6)", "none "},
        {"u/(hypot(u,v)+1e-6)", ""},
        {"u/hypot(u,v)^3", ""},
        {"u*hypot(u,v)", ""},
        {"u/sqrt(v)", ""},
        {"u/sqrt(m*u^2)", "none "},
        {"u/sqrt(m*v)", ""},
        {"-u*(u^2+v^2)^-0.5", "[u v] "},
    };
    for (const auto& [text, expected] : cases)
        EXPECT_EQ(directionsOf(text), expected) << text;
}

TEST(Directions, AreReplacedWhereTheyAreDividedByAndNowhereElse) {
    Graph graph;
    const Node node = parsed(graph, "sin(u)*hypot(u,v)-(2+abs(u))*u/hypot(u,v)");
    const Node length = parsed(graph, "hypot(u,v)"), u = parsed(graph, "u"), a = parsed(graph, "a"),
               l = parsed(graph, "l");
    const auto replaced = withDirections(graph, std::span(&node, 1), std::span(&length, 1),
                                         {{u.index, a}, {length.index, l}});
    EXPECT_EQ(expression::print(graph, replaced[0]),
              expression::print(graph, parsed(graph, "sin(u)*hypot(u,v)-(2+abs(u))*a/l")));
}
