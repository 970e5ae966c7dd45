// Typed letters as good typography has them: quotes by the language, apostrophes, dashes, minus
// signs, ellipses, the narrow blanks of French. Only where no other sign can be meant.
#pragma once

#include <QString>

#include <optional>

namespace typography {

struct Quotes {
    QString open, close;           // of the key "
    QString innerOpen, innerClose; // of the key '
};
// By the tables of Qt (the Unicode Consortium's), save a few; with the blanks inside. `language` is
// as documents spell it, "" is English.
[[nodiscard]] Quotes quotesOf(QStringView language);

// So many letters before the caret become that text.
struct SignMade {
    int letters = 0;
    QString text;
    bool operator==(const SignMade&) const = default;
};
// `before` is the line up to the caret, its last letter typed just now; what is no letter in it,
// as a figure, is U+FFFC.
[[nodiscard]] std::optional<SignMade> signTyped(QStringView before, QStringView language);

} // namespace typography
