#include "editing/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace editing {

namespace {

constexpr int mostDecimals = 17;

std::string shortest(double value) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
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
        return shortest(value);
    const int needed =
        std::clamp(static_cast<int>(std::ceil(-std::log10(resolution) - 1e-9)), 0, mostDecimals);
    if (needed == mostDecimals || (size > 0 && size < 1e-6 && resolution < 1e-6))
        return shortest(value);
    const int kept = isPlain(before) ? std::min(decimalsOf(before), needed) : 0;
    std::string text = withoutZeros(fixed(value, needed), kept);
    if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-')
        text.erase(0, 1);
    return text;
}

} // namespace editing
