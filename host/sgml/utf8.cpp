#include "sgml/utf8.h"

namespace sgml {

namespace {

// What may follow a lead byte: how many continuation bytes, and the bounds of the first of them.
struct Form {
    int length;
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

// Bytes of the character that begins at `at`, 0 when none does.
int wellFormedLength(std::string_view text, std::size_t at) {
    const Form form = formOf(static_cast<unsigned char>(text[at]));
    if (form.length <= 1)
        return form.length;
    if (text.size() - at < static_cast<std::size_t>(form.length))
        return 0;
    for (int i = 1; i < form.length; ++i) {
        const auto c = static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
        if (c < (i == 1 ? form.low : 0x80) || c > (i == 1 ? form.high : 0xBF))
            return 0;
    }
    return form.length;
}

} // namespace

Range illFormed(std::string_view text, std::size_t from) {
    while (from < text.size()) {
        const int length = wellFormedLength(text, from);
        if (length == 0)
            break;
        from += static_cast<std::size_t>(length);
    }
    std::size_t to = from;
    while (to < text.size() && wellFormedLength(text, to) == 0)
        ++to;
    return {from, to};
}

} // namespace sgml
