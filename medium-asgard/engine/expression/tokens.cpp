#include "expression/tokens.h"

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace expression {
namespace {

bool isDigit(char c) { return c >= '0' && c <= '9'; }

bool isLetter(char c) {
    const auto byte = static_cast<unsigned char>(c); // all beyond ASCII: names in any language
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || byte >= 0x80;
}

std::size_t digitsFrom(std::string_view text, std::size_t at) {
    while (at < text.size() && isDigit(text[at]))
        ++at;
    return at;
}

// Infinity when it is too large; 0 when it is too small to be told from it.
double decimalValue(const std::string& word) {
    double value = 0;
    const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc{})
        return value;
    std::istringstream stream(word); // tells the two apart, where from_chars does not
    stream.imbue(std::locale::classic());
    stream >> value;
    return value > 1 ? std::numeric_limits<double>::infinity() : value;
}

std::string adviceFor(std::string_view sign) {
    if (sign == "$")
        return "write a parameter's name without $";
    if (sign == "=")
        return "== compares";
    if (sign == "%")
        return "the rest of a / b is a - b*floor(a/b)";
    if (sign == "&" || sign == "|")
        return "write " + std::string(2, sign[0]);
    return "";
}

} // namespace

void Tokens::take(TokenKind kind, std::size_t length) {
    now_ = {kind, at_, at_ + length, text_.substr(at_, length), 0};
    at_ += length;
}

void Tokens::fail(std::size_t length, std::string message, std::string suggestion) {
    if (!fault_)
        fault_ = SyntaxError{at_, at_ + length, std::move(message), std::move(suggestion)};
    at_ = text_.size();
    now_ = {TokenKind::end, at_, at_, "", 0};
}

void Tokens::advance() {
    while (at_ < text_.size() && std::string_view(" \t\r\n\f\v").find(text_[at_]) != text_.npos)
        ++at_;
    if (at_ == text_.size()) {
        now_ = {TokenKind::end, at_, at_, "", 0};
        return;
    }
    const char c = text_[at_];
    const bool startsFraction = c == '.' && at_ + 1 < text_.size() && isDigit(text_[at_ + 1]);
    if (isDigit(c) || startsFraction)
        readNumber();
    else if (isLetter(c))
        readName();
    else
        readSign();
}

void Tokens::readNumber() {
    std::size_t end = digitsFrom(text_, at_);
    if (end < text_.size() && text_[end] == '.')
        end = digitsFrom(text_, end + 1);
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) {
        std::size_t digits = end + 1;
        if (digits < text_.size() && (text_[digits] == '+' || text_[digits] == '-'))
            ++digits;
        if (digitsFrom(text_, digits) > digits)
            end = digitsFrom(text_, digits);
    }
    std::size_t wordEnd = end;
    while (wordEnd < text_.size() && (isLetter(text_[wordEnd]) || isDigit(text_[wordEnd])))
        ++wordEnd;
    const std::string word(text_.substr(at_, wordEnd - at_));
    if (wordEnd > end)
        return fail(wordEnd - at_, "\"" + word + "\" is not a decimal number");
    const double value = decimalValue(word);
    if (!std::isfinite(value))
        return fail(wordEnd - at_, "\"" + word + "\" is too large for a number");
    take(TokenKind::number, end - at_);
    now_.value = value;
}

// Letters, digits and single dots between them: B, B.x, arm.px.
void Tokens::readName() {
    std::size_t end = at_;
    while (end < text_.size()) {
        const bool isInner = isLetter(text_[end]) || isDigit(text_[end]);
        const bool isDot = text_[end] == '.' && end + 1 < text_.size() && isLetter(text_[end + 1]);
        if (!isInner && !isDot)
            break;
        ++end;
    }
    take(TokenKind::name, end - at_);
}

void Tokens::readSign() {
    static constexpr std::array<std::string_view, 20> signs{
        "**", "<=", ">=", "==", "!=", "&&", "||", "+", "-", "*",
        "/",  "^",  "<",  ">",  "!",  "?",  ":",  "(", ")", ","};
    for (const std::string_view sign : signs)
        if (text_.substr(at_, sign.size()) == sign)
            return take(TokenKind::sign, sign.size());
    const std::string_view sign = text_.substr(at_, 1);
    fail(1, "\"" + std::string(sign) + "\" has no meaning in an expression", adviceFor(sign));
}

} // namespace expression
