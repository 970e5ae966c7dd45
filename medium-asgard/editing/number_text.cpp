#include "editing/number_text.h"

#include "script/numbers.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace editing {

namespace {

constexpr int mostDecimals = 17;

std::string shortest(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

double read(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

// A number of few digits that was worked out is next to itself: so near, relatively, are no two
// numbers of so few digits.
std::string exactly(double value) {
    constexpr int few = 12;
    constexpr double rounding = 1e-14;
    const double near = read(inDigits(value, few));
    return shortest(std::abs(near - value) <= rounding * std::abs(value) ? near : value);
}

std::string fixed(double value, int decimals) {
    char buffer[400];
    return {buffer,
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, decimals)
                .ptr};
}

bool isPlain(std::string_view text) {
    return text.find_first_not_of("+-.0123456789") == std::string_view::npos;
}

int decimalsOf(std::string_view text) {
    const std::size_t point = text.find('.');
    return point == std::string_view::npos ? 0 : static_cast<int>(text.size() - point - 1);
}

std::string withoutZeros(std::string text, int keep) {
    while (decimalsOf(text) > keep && text.back() == '0')
        text.pop_back();
    if (!text.empty() && text.back() == '.')
        text.pop_back();
    return text;
}

} // namespace

std::string numberText(double value, double resolution, std::string_view before) {
    if (value == 0)
        value = 0; // not -0
    const double size = std::abs(value);
    if (!(resolution > 0) || size >= 1e15)
        return exactly(value);
    const int needed =
        std::clamp(static_cast<int>(std::ceil(-std::log10(resolution) - 1e-9)), 0, mostDecimals);
    if (needed == mostDecimals || (size > 0 && size < 1e-6 && resolution < 1e-6))
        return exactly(value);
    const int kept = isPlain(before) ? std::min(decimalsOf(before), needed) : 0;
    int decimals = kept;
    while (decimals < needed &&
           !(std::abs(read(fixed(value, decimals)) - value) <= 0.5 * resolution))
        ++decimals;
    std::string text = withoutZeros(fixed(value, decimals), kept);
    if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-')
        text.erase(0, 1);
    return text;
}

namespace {

// The end of the number without a sign that begins here; `from` itself: none does.
std::size_t numberEnd(std::string_view text, std::size_t from) {
    std::size_t at = from;
    bool digits = false;
    while (at < text.size() && (isDigit(text[at]) || text[at] == '.')) {
        digits = digits || isDigit(text[at]);
        ++at;
    }
    if (!digits)
        return from;
    if (at < text.size() && (text[at] == 'e' || text[at] == 'E')) {
        std::size_t end = at + 1;
        if (end < text.size() && (text[end] == '-' || text[end] == '+'))
            ++end;
        if (end < text.size() && isDigit(text[end])) {
            while (end < text.size() && isDigit(text[end]))
                ++end;
            at = end;
        }
    }
    return at;
}

// Part of a name, a variable or a colour: what follows is no number of its own.
bool belongs(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '$' ||
           c == '#' || (static_cast<unsigned char>(c) & 0x80) != 0;
}

// A sign is the number's own where no term stands before it.
bool isSign(std::string_view text, std::size_t at) {
    if (text[at] != '-' && text[at] != '+')
        return false;
    return at == 0 ||
           std::string_view(" \t\n{(\"[,*/=<>").find(text[at - 1]) != std::string_view::npos;
}

} // namespace

std::optional<scene::Range> numberAt(std::string_view text, std::size_t place) {
    place = std::min(place, text.size());
    std::size_t at = text.rfind('\n', place == 0 ? 0 : place - 1);
    at = at == std::string_view::npos || at > place ? 0 : at;
    while (at < text.size() && at <= place + 1) {
        const std::size_t end = at > 0 && belongs(text[at - 1]) ? at : numberEnd(text, at);
        if (end == at) {
            ++at;
            continue;
        }
        const std::size_t from = at > 0 && isSign(text, at - 1) ? at - 1 : at;
        const bool whole = end == text.size() || !belongs(text[end]);
        if (whole && from <= place && place <= end &&
            script::decimalNumber(text.substr(from, end - from)))
            return scene::Range{from, end};
        at = end;
    }
    return std::nullopt;
}

double decimalStep(double length) {
    return length > 0 ? std::pow(10, std::floor(std::log10(length) + 1e-9)) : 0;
}

double roundedTo(double value, double step) {
    if (step <= 0)
        return value;
    const std::string text = inDigits(std::round(value / step) * step, 12);
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

std::string inDigits(double value, int digits) {
    char buffer[400];
    return {buffer,
            std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits)
                .ptr};
}

} // namespace editing
