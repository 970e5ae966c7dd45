#include "typography/breaks.h"

#include "typography/tokens.h"

#include <algorithm>

namespace typography {

namespace {

constexpr int rather = 500; // than tear a line's end off here
constexpr int slightly = 150;
constexpr qsizetype mostRead = 64; // letters that are read of a word

constexpr QChar lineSeparator(QChar::LineSeparator);

bool isBlank(QChar sign) { return sign.isSpace() && sign != lineSeparator; }

QStringView wordBefore(QStringView text, qsizetype end) {
    qsizetype from = end;
    while (from > 0 && end - from < mostRead && !text[from - 1].isSpace())
        --from;
    return text.sliced(from, end - from);
}

QStringView wordFrom(QStringView text, qsizetype from) {
    qsizetype end = from;
    while (end < text.size() && end - from < mostRead && !text[end].isSpace())
        ++end;
    return text.sliced(from, end - from);
}

// As far as it is digits.
qsizetype digitsAt(QStringView word) {
    qsizetype count = 0;
    while (count < word.size() && isDigit(word[count]))
        ++count;
    return count;
}

qsizetype digitsBefore(QStringView word) {
    qsizetype count = 0;
    while (count < word.size() && isDigit(word[word.size() - 1 - count]))
        ++count;
    return count;
}

// "12" and "345" of 12 345, "678" and "901,5".
bool isOneNumber(QStringView before, QStringView behind) {
    const QStringView left = withoutBeginning(before);
    const qsizetype last = digitsBefore(left), next = digitsAt(behind);
    const bool isGroup = next == 3 || (last == 3 && next > 0 && next < 3 && left.size() > last);
    const bool isSigned = left.size() == last ||
                          (left.size() == last + 1 && QStringView(u"+-−–±$€£").contains(left[0]));
    return isGroup && last > 0 && last <= 3 &&
           (isSigned || left[left.size() - last - 1] == ',' || left[left.size() - last - 1] == '.');
}

// "J.", "e."
bool isInitial(QStringView word) {
    const QStringView bare = withoutBeginning(word);
    return bare.size() == 2 && bare[0].isLetter() && bare[1] == '.';
}

int besideNumber(QStringView before, QStringView behind) {
    if (isOneNumber(before, behind))
        return never;
    const QStringView word = withoutEnd(behind);
    if (isUnit(behind) || isUnit(word) || QStringView(u"%‰°").contains(behind.front()))
        return never;
    return isMonth(behind) && digitsBefore(before) <= 2 ? never : 0;
}

int atName(QStringView name, QStringView behind) {
    const QStringView number = withoutEnd(withoutBeginning(behind));
    if (number.isEmpty())
        return 0;
    const bool isNumber = isDigit(number.front()) || (number.size() == 1 && number[0].isUpper());
    return isNumber && namesANumber(name) ? never : 0;
}

bool beginsWithDigit(QStringView word) {
    const QStringView bare = withoutBeginning(word);
    return !bare.isEmpty() && isDigit(bare.front());
}

// At blanks between two words.
int atBlank(QStringView before, QStringView behind) {
    const QChar last = before.back(), first = behind.front();
    if (behind.size() == 1 && (isDash(first) || first == '-' || isOperator(first)))
        return never; // it goes with the word before
    if (behind == u"--" || behind == u"---" || QStringView(u"…»;:!?)]}").contains(first) ||
        behind.startsWith(QStringView(u"...")))
        return never;
    if (withoutBeginning(before).isEmpty() && before != u"\"" && before != u"'")
        return never; // an opening bracket or quote that stands alone
    if (before.size() == 1 && isOperator(last))
        return rather;
    if (isDigit(last))
        if (const int cost = besideNumber(before, behind); cost != 0)
            return cost;
    // 12. März
    if (last == '.' && isMonth(behind) && digitsBefore(before.chopped(1)) > 0)
        return never;
    const QStringView name = withoutBeginning(before);
    if (const int cost = atName(name, behind); cost != 0)
        return cost;
    if (isMonth(name) && beginsWithDigit(behind))
        return digitsAt(behind) <= 2 ? never : slightly;
    if (isTitle(name) && first.isUpper())
        return never;
    if (isInitial(before))
        return isInitial(behind.first(std::min<qsizetype>(behind.size(), 2))) ? never
               : first.isUpper()                                              ? rather
                                                                              : 0;
    // References in brackets: they go with their word, and are one.
    if (first == '[' && behind.size() > 1 && isDigit(behind[1]))
        return slightly;
    if (name.size() < before.size() && before.front() == '[' && last == ',' &&
        isDigit(behind.front()))
        return never;
    return 0;
}

// The part of a word behind its last hyphen.
QStringView lastPart(QStringView word) {
    qsizetype from = word.size();
    while (from > 0 && word[from - 1] != '-' && !isDash(word[from - 1]))
        --from;
    return word.sliced(from);
}

qsizetype lettersAt(QStringView word) {
    qsizetype count = 0;
    while (count < word.size() && word[count].isLetterOrNumber())
        ++count;
    return count;
}

// Within a word, behind a sign.
int inWord(QStringView before, QStringView behind) {
    const QChar last = before.back(), first = behind.front();
    if (isDash(first) || first == '/' || (first == '-' && isDash(last)))
        return never;
    const QStringView head = before.chopped(1);
    const bool isSign = QStringView(u"-−/:.,+×·").contains(last) || isDash(last);
    if (isSign && isDigit(first)) {
        if (head.isEmpty() || isDigit(head.back()))
            return never; // 2026-11-23, 10–20, 1/2
        // 3.5e-4
        const bool isPower = (head.back() == 'e' || head.back() == 'E') && head.size() > 1 &&
                             (isDigit(head[head.size() - 2]) || head[head.size() - 2] == '.');
        if (isPower || withoutBeginning(head).isEmpty() || last == u'−')
            return never;
    }
    if (last == '/' && isUnit(lastPart(head)) && isUnit(behind.first(lettersAt(behind))))
        return never; // km/h
    if (last == '-' || last == QChar(0x2010)) {
        const bool isSingle = lastPart(head).size() < 2 || lettersAt(behind) < 2;
        return isSingle ? never : atHyphen; // x-axis, 3-D
    }
    if (isDash(last) || last == '/' || last == QChar(QChar::SoftHyphen))
        return atHyphen;
    if (isDigit(last) && isDigit(first))
        return never;
    return 0;
}

} // namespace

int costOfBreak(QStringView text, qsizetype at) {
    if (at >= text.size() || at <= 0 || text[at - 1] == lineSeparator)
        return 0;
    if (text[at] == lineSeparator)
        return never; // the line ends behind it
    qsizetype end = at;
    while (end > 0 && isBlank(text[end - 1]))
        --end;
    const QStringView before = wordBefore(text, end), behind = wordFrom(text, at);
    if (before.isEmpty() || behind.isEmpty())
        return 0;
    return end < at ? atBlank(before, behind) : inWord(before, behind);
}

} // namespace typography
