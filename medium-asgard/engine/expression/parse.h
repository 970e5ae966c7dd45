// Infix text of the scene language into a graph (docs/scene-language.md, "Expressions").
#pragma once

#include "expression/graph.h"
#include "expression/syntax_error.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace expression {

// The meaning of a name, or of a call that is no built-in function ("B.px" with its argument
// nodes). Returns the node, or the sentence that says why there is none.
struct Meaning {
    std::optional<Node> node;
    std::string message, suggestion;
};
using Names = std::function<Meaning(Graph&, std::string_view name, std::span<const Node> arguments,
                                    bool isCall)>;

// Numbers are decimal and finite. At most 200 levels of nesting and 100,000 bytes.
[[nodiscard]] std::variant<Node, SyntaxError> parse(Graph& graph, std::string_view text,
                                                    const Names& names);

// The names of the built-in functions, for messages and completion.
[[nodiscard]] const std::vector<std::string>& functionNames();

} // namespace expression
