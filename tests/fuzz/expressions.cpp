// Any text is an expression or an error at a place: an expression is printed, read back as itself,
// differentiated, and has the same value by its tape and by machine code.
#include "require.h"

#include "expression/assemble.h"
#include "expression/graph.h"
#include "expression/kernel.h"
#include "expression/parse.h"
#include "expression/tape.h"

#include <cmath>
#include <cstring>

namespace {

using expression::Graph;
using expression::Kernel;
using expression::Node;

// The names that there are; a call of B.px has its argument added.
expression::Meaning meaning(Graph& graph, std::string_view name, std::span<const Node> arguments,
                            bool isCall) {
    if (name.size() == 1 && name[0] >= 'x' && name[0] <= 'z' && !isCall)
        return {graph.symbol(name), "", ""};
    if (name == "B.px" && isCall && arguments.size() == 1)
        return {graph.add(graph.symbol("x"), arguments[0]), "", ""};
    return {std::nullopt, "there is no such name", ""};
}

bool isSame(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// Machine code that was made for it, as after many evaluations.
void checkCode(const expression::Tape& tape, std::span<const double> in, double expected) {
    const std::shared_ptr<Kernel> kernel = Kernel::of(tape.sequence());
    const auto* code = kernel->code(expression::Purpose::values, Kernel::Width::one, ~0u);
    if (!code)
        return;
    std::vector<double> scratch(code->scratch);
    double out = 0;
    code->entry(in.data(), &out, tape.constants().data(), nullptr, scratch.data());
    FUZZ_REQUIRE(isSame(out, expected));
}

void checkValues(const Graph& graph, Node node, std::span<const Node> symbols, bool withCode) {
    const expression::Tape tape(graph, symbols, std::span(&node, 1));
    expression::Tape::Scratch scratch;
    constexpr double places[][3] = {{0.5, -2, 3}, {0, 1, -1e300}, {-0.0, INFINITY, NAN}};
    for (const auto& place : places) {
        double out = 0;
        tape.evaluate(place, std::span(&out, 1), scratch);
        if (withCode)
            checkCode(tape, place, out);
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    Graph graph;
    const Node symbols[] = {graph.symbol("x"), graph.symbol("y"), graph.symbol("z")};
    const auto read = expression::parse(graph, text, meaning);
    if (const auto* error = std::get_if<expression::SyntaxError>(&read)) {
        FUZZ_REQUIRE(error->from <= error->to && error->to <= size && !error->message.empty());
        return 0;
    }
    const Node node = std::get<Node>(read);
    const std::string printed = expression::print(graph, node);
    // A sum of sums is printed without sharing: what is too long or too deep to read is no fault.
    if (printed.size() < 10'000) {
        const auto again = expression::parse(graph, printed, meaning);
        const Node* same = std::get_if<Node>(&again);
        if (!same && std::get<expression::SyntaxError>(again).message.find("nested more than") !=
                         std::string::npos)
            return 0;
        if (!same || *same != node)
            std::fprintf(stderr, "printed: %s\nread back: %s\n", printed.c_str(),
                         same ? expression::print(graph, *same).c_str()
                              : std::get<expression::SyntaxError>(again).message.c_str());
        FUZZ_REQUIRE(same && *same == node);
    }
    // Making code takes as long as a thousand other inputs.
    checkValues(graph, node, symbols, size % 8 == 0);
    if (graph.size() < 500)
        checkValues(graph, expression::differentiate(graph, node, symbols[0]), symbols, false);
    return 0;
}
