#include "script/numbers.h"

#include <charconv>
#include <cmath>

namespace script {

namespace {

// Of a number that no double can hold: is it too small, not too large?
bool isTiny(std::string_view text) {
    const auto exponent = text.find_first_of("eE");
    if (exponent != std::string_view::npos)
        return exponent + 1 < text.size() && text[exponent + 1] == '-';
    return text.starts_with('.') || text.starts_with("0.");
}

} // namespace

std::optional<double> decimalNumber(std::string_view text) {
    constexpr std::string_view blanks = " \t\n\r\v\f";
    const auto from = text.find_first_not_of(blanks);
    if (from == std::string_view::npos)
        return std::nullopt;
    text = text.substr(from, text.find_last_not_of(blanks) - from + 1);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    const std::string_view unsignedPart = text.starts_with('-') ? text.substr(1) : text;
    // The library also reads "nan" and "inf".
    if (unsignedPart.empty() ||
        unsignedPart.find_first_not_of("0123456789.eE+-") != std::string_view::npos ||
        unsignedPart.starts_with('-') || unsignedPart.starts_with('+'))
        return std::nullopt;
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end != text.data() + text.size())
        return std::nullopt;
    if (error == std::errc::result_out_of_range && isTiny(unsignedPart))
        return 0.0;
    if (error != std::errc{} || !std::isfinite(value))
        return std::nullopt;
    return value;
}

std::string numberText(double value, bool whole) {
    char bytes[40];
    const auto end = std::to_chars(bytes, bytes + sizeof bytes, value).ptr;
    std::string text(bytes, end);
    if (text.find_first_of(".en") != std::string::npos || whole)
        return text;
    return text + ".0";
}

} // namespace script
