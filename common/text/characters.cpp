#include "text/characters.h"

namespace text {

namespace {

unsigned char byteAt(std::string_view text, std::size_t at) {
    return static_cast<unsigned char>(text[at]);
}

// The bytes that may follow a lead byte: how many bytes there are, and the bounds of the second.
struct Form {
    std::size_t length;
    unsigned char low, high;
};

Form formOf(unsigned char lead) {
    if (lead < 0x80)
        return {1, 0, 0};
    if (lead >= 0xC2 && lead <= 0xDF)
        return {2, 0x80, 0xBF};
    if (lead == 0xE0)
        return {3, 0xA0, 0xBF};
    if (lead == 0xED)
        return {3, 0x80, 0x9F};
    if (lead >= 0xE1 && lead <= 0xEF)
        return {3, 0x80, 0xBF};
    if (lead == 0xF0)
        return {4, 0x90, 0xBF};
    if (lead >= 0xF1 && lead <= 0xF3)
        return {4, 0x80, 0xBF};
    if (lead == 0xF4)
        return {4, 0x80, 0x8F};
    return {0, 0, 0};
}

} // namespace

std::size_t characterLength(std::string_view text) {
    if (text.empty())
        return 0;
    const Form form = formOf(byteAt(text, 0));
    if (form.length <= 1)
        return form.length;
    if (text.size() < form.length)
        return 0;
    for (std::size_t i = 1; i < form.length; ++i) {
        const unsigned char byte = byteAt(text, i);
        if (byte < (i == 1 ? form.low : 0x80) || byte > (i == 1 ? form.high : 0xBF))
            return 0;
    }
    return form.length;
}

char32_t codePoint(std::string_view character) {
    constexpr unsigned char leadBits[] = {0, 0x7F, 0x1F, 0x0F, 0x07};
    char32_t code = byteAt(character, 0) & leadBits[character.size()];
    for (std::size_t i = 1; i < character.size(); ++i)
        code = (code << 6) | (byteAt(character, i) & 0x3F);
    return code;
}

std::size_t characterStart(std::string_view text, std::size_t at) {
    while (at > 0 && isInsideCharacter(text, at))
        --at;
    return at;
}

Range illFormed(std::string_view text, std::size_t from) {
    while (from < text.size()) {
        const std::size_t length = characterLength(text.substr(from));
        if (length == 0)
            break;
        from += length;
    }
    std::size_t to = from;
    while (to < text.size() && characterLength(text.substr(to)) == 0)
        ++to;
    return {from, to};
}

std::string asUtf8(std::string_view text) {
    std::string valid(text);
    for (Range bad = illFormed(text); !bad.empty(); bad = illFormed(text, bad.to))
        valid.replace(bad.from, bad.size(), bad.size(), '?');
    return valid;
}

} // namespace text
