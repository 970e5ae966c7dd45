// Expressions for tests: any plain name is a symbol.
#pragma once

#include "expression/graph.h"
#include "expression/parse.h"

#include <stdexcept>
#include <string_view>

namespace expression::testing {

inline Meaning symbolOf(Graph& graph, std::string_view name, std::span<const Node> /*arguments*/,
                        bool isCall) {
    if (isCall)
        return {std::nullopt, "there is no function " + std::string(name), ""};
    return {graph.symbol(name), "", ""};
}

inline Node parsed(Graph& graph, std::string_view text) {
    const auto result = parse(graph, text, symbolOf);
    if (const auto* error = std::get_if<SyntaxError>(&result))
        throw std::invalid_argument(std::string(text) + ": " + error->message);
    return std::get<Node>(result);
}

inline std::string simplified(std::string_view text) {
    Graph graph;
    return print(graph, parsed(graph, text));
}

} // namespace expression::testing
