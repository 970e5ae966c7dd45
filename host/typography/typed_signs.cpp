#include "typography/typed_signs.h"

#include <QLocale>

namespace typography {

namespace {

constexpr QChar apostrophe(0x2019), minus(0x2212), enDash(0x2013), emDash(0x2014), ellipsis(0x2026),
    narrow(0x202F), fixed(0x00A0);

// "fr" and all that begin with "fr-".
bool isOf(QStringView language, QStringView base) {
    return language == base || (language.startsWith(base) && language.size() > base.size() &&
                                (language[base.size()] == u'-' || language[base.size()] == u'_'));
}
bool isFrench(QStringView language) { return isOf(language, u"fr"); }

// Languages for which Qt's tables have others than people write, or not the blanks.
struct Own {
    QStringView language;
    Quotes quotes;
};
const Own owns[] = {
    {u"de-CH", {"«", "»", "‹", "›"}},
    {u"fr", {QString("«") + narrow, narrow + QString("»"), "“", "”"}},
    {u"nl", {"“", "”", "‘", "’"}},
};

bool isLetter(QChar sign) { return sign.isLetter() || sign.isMark(); }

// Of a pair of quotes that may be one sign, only context tells.
bool isOpen(QStringView before, const QString& open, const QString& close) {
    if (open == close)
        return before.count(open) % 2 == 1;
    const qsizetype last = before.lastIndexOf(open);
    return last >= 0 && before.indexOf(close, last + open.size()) < 0;
}

// Behind these a word begins.
bool beginsWord(QStringView before, const Quotes& quotes) {
    if (before.isEmpty())
        return true;
    const QChar last = before.back();
    const auto opens = [&](const QString& open, const QString& close) {
        return before.endsWith(open) && isOpen(before, open, close);
    };
    return last.isSpace() || last == emDash || last == enDash || last == u'/' ||
           last.category() == QChar::Punctuation_Open || opens(quotes.open, quotes.close) ||
           opens(quotes.innerOpen, quotes.innerClose);
}

std::optional<SignMade> quoteTyped(QStringView before, QStringView language) {
    const Quotes quotes = quotesOf(language);
    const bool isOuter = before.back() == u'"';
    const QString& open = isOuter ? quotes.open : quotes.innerOpen;
    const QString& close = isOuter ? quotes.close : quotes.innerClose;
    const QStringView line = before.chopped(1);
    const auto made = [&](const QString& text) -> std::optional<SignMade> {
        if (text == QString(before.back()))
            return std::nullopt;
        return SignMade{1, text};
    };
    if (beginsWord(line, quotes))
        return made(open);
    if (isOpen(line, open, close))
        return made(close);
    if (line.back().isDigit()) // inches and feet
        return std::nullopt;
    return made(isOuter ? close : QString(apostrophe));
}

// A quote that was closed within a word is an apostrophe.
std::optional<SignMade> letterTyped(QStringView before, QStringView language) {
    if (before.size() < 3 || !isLetter(before[before.size() - 3]))
        return std::nullopt;
    const QChar sign = before[before.size() - 2];
    if (sign == apostrophe || quotesOf(language).innerClose != sign)
        return std::nullopt;
    return SignMade{2, QString(apostrophe) + before.back()};
}

std::optional<SignMade> dashTyped(QStringView before) {
    if (before.endsWith(QString(enDash) + '-'))
        return SignMade{2, QString(emDash)};
    if (before.endsWith(u"--") && !before.endsWith(u"---"))
        return SignMade{2, QString(enDash)};
    return std::nullopt;
}

// Of a number that follows a blank, a bracket or a sign that compares or calculates.
std::optional<SignMade> digitTyped(QStringView before) {
    const qsizetype at = before.size() - 2;
    if (at < 0 || before[at] != u'-')
        return std::nullopt;
    const bool isAlone = at == 0 || before[at - 1].isSpace() ||
                         before[at - 1].category() == QChar::Punctuation_Open ||
                         QStringView(u"=<>≤≥≈≠±×·").contains(before[at - 1]);
    return isAlone ? std::optional(SignMade{2, QString(minus) + before.back()}) : std::nullopt;
}

std::optional<SignMade> pointTyped(QStringView before) {
    if (!before.endsWith(u"...") || before.endsWith(u"...."))
        return std::nullopt;
    return SignMade{3, QString(ellipsis)};
}

// French sets a blank before these, where a line must not end.
std::optional<SignMade> highSignTyped(QStringView before) {
    if (before.size() < 3 || before[before.size() - 2] != u' ' ||
        before[before.size() - 3].isSpace())
        return std::nullopt;
    const QChar blank = before.back() == u':' ? fixed : narrow;
    return SignMade{2, QString(blank) + before.back()};
}

} // namespace

Quotes quotesOf(QStringView language) {
    for (const Own& own : owns)
        if (isOf(language, own.language))
            return own.quotes;
    const QLocale locale(language.isEmpty() ? QStringLiteral("en") : language.toString());
    const auto around = [&](QLocale::QuotationStyle style) {
        const QString quoted = locale.quoteString(u"|", style);
        const qsizetype at = quoted.indexOf('|');
        return std::pair(quoted.left(at), quoted.mid(at + 1));
    };
    const auto [open, close] = around(QLocale::StandardQuotation);
    const auto [innerOpen, innerClose] = around(QLocale::AlternateQuotation);
    return {open, close, innerOpen, innerClose};
}

std::optional<SignMade> signTyped(QStringView before, QStringView language) {
    if (before.isEmpty())
        return std::nullopt;
    const QChar typed = before.back();
    if (typed == u'"' || typed == u'\'')
        return quoteTyped(before, language);
    if (typed == u'-')
        return dashTyped(before);
    if (typed == u'.')
        return pointTyped(before);
    if (typed.isDigit())
        return digitTyped(before);
    if (QStringView(u";:!?").contains(typed))
        return isFrench(language) ? highSignTyped(before) : std::nullopt;
    return isLetter(typed) ? letterTyped(before, language) : std::nullopt;
}

} // namespace typography
