#include "expression/chained_comparison.h"

#include "expression/tokens.h"

#include <algorithm>
#include <array>

namespace expression {
namespace {

bool isOneOf(const Token& token, std::span<const std::string_view> signs) {
    return token.kind == TokenKind::sign && std::ranges::find(signs, token.text) != signs.end();
}

} // namespace

std::optional<SyntaxError> chainedComparison(std::string_view text) {
    static constexpr std::array<std::string_view, 4> orders{"<", "<=", ">", ">="};
    // What binds less tightly ends the operands of a comparison.
    static constexpr std::array<std::string_view, 7> ends{"==", "!=", "&&", "||", "?", ":", ","};
    std::vector<std::optional<Token>> before{std::nullopt}; // in each pair of parentheses
    for (Tokens tokens(text); tokens.now().kind != TokenKind::end; tokens.advance()) {
        const Token& now = tokens.now();
        if (tokens.isSign("(")) {
            before.emplace_back();
        } else if (tokens.isSign(")")) {
            if (before.size() > 1)
                before.pop_back();
        } else if (isOneOf(now, ends)) {
            before.back().reset();
        } else if (isOneOf(now, orders)) {
            if (before.back())
                return SyntaxError{before.back()->from, now.to,
                                   "of two comparisons in a row the second compares what the first "
                                   "gives, which is 0 or 1",
                                   "join them by &&, as in 0 < x && x < 1"};
            before.back() = now;
        }
    }
    return std::nullopt;
}

} // namespace expression
