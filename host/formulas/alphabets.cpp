// The mathematical alphabets of Unicode, U+1D400 and on. Some of their letters were in Unicode
// before them, and have kept those places.
#include "formulas/symbols.h"

#include <array>

namespace formulas {

namespace {

struct Places {
    char32_t capitals = 0, letters = 0, digits = 0, greekCapitals = 0, greek = 0;
};

Places placesOf(Alphabet alphabet) {
    switch (alphabet) {
    case Alphabet::normal:
        return {0x1D434, 0x1D44E, 0, 0, 0x1D6FC};
    case Alphabet::italic:
        return {0x1D434, 0x1D44E, 0, 0x1D6E2, 0x1D6FC};
    case Alphabet::bold:
        return {0x1D400, 0x1D41A, 0x1D7CE, 0x1D6A8, 0x1D6C2};
    case Alphabet::boldItalic:
        return {0x1D468, 0x1D482, 0x1D7CE, 0x1D71C, 0x1D736};
    case Alphabet::calligraphic:
        return {0x1D49C, 0x1D4B6, 0, 0, 0};
    case Alphabet::blackboard:
        return {0x1D538, 0x1D552, 0x1D7D8, 0, 0};
    case Alphabet::fraktur:
        return {0x1D504, 0x1D51E, 0, 0, 0};
    case Alphabet::sans:
        return {0x1D5A0, 0x1D5BA, 0x1D7E2, 0, 0};
    case Alphabet::mono:
        return {0x1D670, 0x1D68A, 0x1D7F6, 0, 0};
    case Alphabet::upright:
        break;
    }
    return {};
}

constexpr std::array<std::array<char32_t, 2>, 24> elsewhere{{
    {0x1D455, 0x210E}, {0x1D49D, 0x212C}, {0x1D4A0, 0x2130}, {0x1D4A1, 0x2131}, {0x1D4A3, 0x210B},
    {0x1D4A4, 0x2110}, {0x1D4A7, 0x2112}, {0x1D4A8, 0x2133}, {0x1D4AD, 0x211B}, {0x1D4BA, 0x212F},
    {0x1D4BC, 0x210A}, {0x1D4C4, 0x2134}, {0x1D506, 0x212D}, {0x1D50B, 0x210C}, {0x1D50C, 0x2111},
    {0x1D515, 0x211C}, {0x1D51D, 0x2128}, {0x1D53A, 0x2102}, {0x1D53F, 0x210D}, {0x1D545, 0x2115},
    {0x1D547, 0x2119}, {0x1D548, 0x211A}, {0x1D549, 0x211D}, {0x1D551, 0x2124},
}};

char32_t placed(char32_t first, char32_t offset) {
    const char32_t code = first + offset;
    for (const auto& letter : elsewhere)
        if (letter[0] == code)
            return letter[1];
    return code;
}

// Behind ω, and before that place as behind capital Ω: ∂ ϵ ϑ ϰ ϕ ϱ ϖ.
char32_t variantOffset(char32_t letter) {
    constexpr std::u32string_view variants = U"∂ϵϑϰϕϱϖ";
    const std::size_t at = variants.find(letter);
    return at == std::u32string_view::npos ? 0 : 25 + static_cast<char32_t>(at);
}

} // namespace

char32_t styled(char32_t letter, Alphabet alphabet) {
    const Places places = placesOf(alphabet);
    if (letter >= U'A' && letter <= U'Z' && places.capitals != 0)
        return placed(places.capitals, letter - U'A');
    if (letter >= U'a' && letter <= U'z' && places.letters != 0)
        return placed(places.letters, letter - U'a');
    if (letter >= U'0' && letter <= U'9' && places.digits != 0)
        return places.digits + (letter - U'0');
    if (letter >= 0x391 && letter <= 0x3A9 && places.greekCapitals != 0)
        return places.greekCapitals + (letter - 0x391);
    if (letter >= 0x3B1 && letter <= 0x3C9 && places.greek != 0)
        return places.greek + (letter - 0x3B1);
    if (const char32_t offset = variantOffset(letter); offset != 0 && places.greek != 0)
        return places.greek + offset;
    if (letter == U'∇' && (alphabet == Alphabet::bold || alphabet == Alphabet::boldItalic))
        return places.greekCapitals + 25;
    if (letter == U'ı' && places.letters == 0x1D44E)
        return 0x1D6A4;
    if (letter == U'ȷ' && places.letters == 0x1D44E)
        return 0x1D6A5;
    return letter;
}

} // namespace formulas
