#include "typography/numbers.h"

#include "typography/tokens.h"

#include <QLocale>

#include <algorithm>

namespace typography {

namespace {

bool mayDivideGroups(QChar sign, QChar point) {
    return sign == ' ' || sign == QChar(0x00A0) || sign == QChar(0x202F) || sign == QChar(0x2009) ||
           sign == '\'' || (sign == ',' && point == '.') || (sign == '.' && point == ',');
}

qsizetype digitsIn(QStringView text, qsizetype at) {
    const qsizetype from = at;
    while (at < text.size() && isDigit(text[at]))
        ++at;
    return at - from;
}

// Behind the whole digits; in groups every one but the first has three.
qsizetype afterWhole(QStringView text, qsizetype at, QChar point) {
    qsizetype count = digitsIn(text, at);
    at += count;
    while (count > 0 && count <= 3 && at + 1 < text.size() && mayDivideGroups(text[at], point) &&
           digitsIn(text, at + 1) == 3) {
        at += 4;
        count = 3;
    }
    return at;
}

// Behind "e-4", "·10^-4", "×10⁻⁴".
qsizetype afterPower(QStringView text, qsizetype at) {
    const QStringView rest = text.sliced(at);
    const auto isOfPower = [](QChar sign) {
        return isDigit(sign) || QStringView(u"+-−–^{}⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹").contains(sign);
    };
    qsizetype end = 0;
    if (rest.startsWith(u'e') || rest.startsWith(u'E'))
        end = 1;
    else
        for (const QStringView times : {u"·10", u"×10", u" · 10", u" × 10"})
            if (rest.startsWith(times))
                end = times.size();
    const qsizetype sign = end;
    while (end > 0 && end < rest.size() && isOfPower(rest[end]))
        ++end;
    return end > sign ? at + end : at;
}

std::optional<qsizetype> pointBy(QStringView text, QChar point) {
    qsizetype at = 0;
    while (at < text.size() && QStringView(u"+-−–±<>≤≥≈~=$€£ \u00A0(").contains(text[at]))
        ++at;
    qsizetype end = afterWhole(text, at, point);
    const qsizetype place = end;
    if (end < text.size() && text[end] == point && (end > at || digitsIn(text, end + 1) > 0))
        end += 1 + digitsIn(text, end + 1);
    if (end == at)
        return std::nullopt;
    end = afterPower(text, end);
    const QStringView rest = text.sliced(end).trimmed();
    const bool isWhole = rest.isEmpty() || isUnit(rest) || rest == u")" || rest == u"*";
    return isWhole ? std::optional(place) : std::nullopt;
}

} // namespace

std::optional<qsizetype> pointOf(QStringView text, const QString& language) {
    while (!text.isEmpty() && text.back().isSpace())
        text.chop(1);
    // A language that Qt does not know has the point of English.
    const QChar point = language.isEmpty() ? u'.' : QLocale(language).decimalPoint().front();
    const QChar first = point == ',' ? ',' : '.', second = point == ',' ? '.' : ',';
    const auto place = pointBy(text, first);
    return place ? place : pointBy(text, second);
}

bool isNoNumber(QStringView text) {
    return std::ranges::all_of(text, [](QChar sign) {
        return sign.isSpace() || isDash(sign) || sign == '-' || sign == u'−' || sign == u'…';
    });
}

} // namespace typography
