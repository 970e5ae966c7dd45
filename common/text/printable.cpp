#include "text/printable.h"

#include "text/characters.h"

#include <algorithm>
#include <array>

namespace text {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD
constexpr std::string_view margin = "    ";

// The Bidi_Control characters of Unicode 15.
bool isDirection(char32_t c) {
    return c == 0x061C || c == 0x200E || c == 0x200F || (c >= 0x202A && c <= 0x202E) ||
           (c >= 0x2066 && c <= 0x2069);
}

// U+2400 and what follows it: a picture of each control character.
std::string_view pictureOf(unsigned char control) {
    static const auto pictures = [] {
        std::array<std::array<char, 3>, 0x22> all{};
        for (std::size_t i = 0; i < all.size(); ++i)
            all[i] = {'\xE2', '\x90', static_cast<char>(0x80 + i)};
        return all;
    }();
    const auto& picture = pictures[control == 0x7F ? 0x21 : control];
    return {picture.data(), picture.size()};
}

std::string_view shown(std::string_view text, std::size_t& length, Direction direction) {
    length = characterLength(text);
    if (length == 0) {
        length = 1;
        return replacement;
    }
    const std::string_view character = text.substr(0, length);
    const char32_t code = codePoint(character);
    if (code < 0x20 || code == 0x7F)
        return pictureOf(static_cast<unsigned char>(code));
    if ((code >= 0x80 && code <= 0x9F) || (direction == Direction::shown && isDirection(code)))
        return replacement;
    return character;
}

} // namespace

std::string_view shownFor(std::string_view text, std::size_t& length) {
    return shown(text, length, Direction::shown);
}

std::string printable(std::string_view text, Direction direction) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0, length = 1; at < text.size(); at += length) {
        length = 1;
        if (text.substr(at).starts_with("\r\n"))
            continue;
        if (text[at] == '\n' || text[at] == '\t')
            result += text[at];
        else
            result += shown(text.substr(at), length, direction);
    }
    return result;
}

std::string oneLine(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0, length = 1; at < text.size(); at += length)
        result += shownFor(text.substr(at), length);
    return result;
}

std::string message(std::string_view text) {
    const std::string lines = printable(text);
    std::string result;
    result.reserve(lines.size() + 1);
    for (std::size_t from = 0; from < lines.size();) {
        const std::size_t end = std::min(lines.find('\n', from), lines.size());
        const std::string_view line = std::string_view(lines).substr(from, end - from);
        if (from > 0 && !line.empty() && !line.starts_with(margin))
            result += margin;
        result += line;
        result += '\n';
        from = end + 1;
    }
    return result;
}

} // namespace text
