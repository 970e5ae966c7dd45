// The words of an expression's text, one at a time.
#pragma once

#include "expression/syntax_error.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace expression {

enum class TokenKind { number, name, sign, end };

struct Token {
    TokenKind kind = TokenKind::end;
    std::size_t from = 0, to = 0; // bytes of the text
    std::string_view text;
    double value = 0; // of a number
};

class Tokens {
public:
    explicit Tokens(std::string_view text) : text_(text) { advance(); }

    [[nodiscard]] const Token& now() const { return now_; }
    [[nodiscard]] bool isSign(std::string_view sign) const {
        return now_.kind == TokenKind::sign && now_.text == sign;
    }
    void advance();
    // A character or number that no expression has; reading then stands at its end.
    [[nodiscard]] const std::optional<SyntaxError>& fault() const { return fault_; }

private:
    void readNumber();
    void readName();
    void readSign();
    void take(TokenKind kind, std::size_t length);
    void fail(std::size_t length, std::string message, std::string suggestion = "");

    std::string_view text_;
    std::size_t at_ = 0;
    Token now_;
    std::optional<SyntaxError> fault_;
};

} // namespace expression
