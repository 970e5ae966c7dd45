#include "source/shown_bytes.h"

#include "text/characters.h"
#include "text/printable.h"

#include <QStringList>

namespace source {

namespace {

constexpr char32_t sign = 0xFFFD;

// Signs that a text widget takes for something else than a letter.
bool isSpecial(char32_t code) {
    return code == 0x2028 || code == 0x2029 || code == 0xFDD0 || code == 0xFDD1 || code == 0xFFFC;
}

// The letter that a text begins with. `length` becomes its bytes.
char32_t letterOf(std::string_view text, std::size_t& length) {
    const auto first = static_cast<unsigned char>(text.front());
    length = 1;
    if ((first >= 0x20 && first < 0x7F) || first == '\t' || first == '\n')
        return first;
    if (first == '\r') {
        length = text.starts_with("\r\n") ? 2 : 1;
        return '\n';
    }
    const char32_t code = text::codePoint(text::shownFor(text, length));
    return isSpecial(code) ? sign : code;
}

int unitsOf(char32_t code) { return code > 0xFFFF ? 2 : 1; }

} // namespace

std::size_t& lettersRead() {
    thread_local std::size_t count = 0;
    return count;
}

QString shown(std::string_view bytes) {
    QString result;
    result.reserve(static_cast<qsizetype>(bytes.size()));
    for (std::size_t at = 0, length = 1; at < bytes.size(); at += length) {
        const char32_t code = letterOf(bytes.substr(at), length);
        if (code > 0xFFFF)
            result += QStringView(QChar::fromUcs4(code));
        else
            result += QChar(static_cast<char16_t>(code));
    }
    lettersRead() += static_cast<std::size_t>(result.size());
    return result;
}

int lettersIn(std::string_view bytes) {
    int count = 0;
    for (std::size_t at = 0, length = 1; at < bytes.size(); at += length)
        count += unitsOf(letterOf(bytes.substr(at), length));
    lettersRead() += static_cast<std::size_t>(count);
    return count;
}

std::size_t bytesOf(std::string_view bytes, int letters) {
    lettersRead() += static_cast<std::size_t>(letters);
    std::size_t at = 0;
    for (std::size_t length = 1; letters > 0 && at < bytes.size(); at += length)
        letters -= unitsOf(letterOf(bytes.substr(at), length));
    return at;
}

std::string spelled(const QString& letters, std::string_view lineEnd) {
    std::string result;
    for (const QString& line : letters.split(QLatin1Char('\n'))) {
        result += line.toStdString();
        result += lineEnd;
    }
    result.resize(result.size() - lineEnd.size());
    return result;
}

std::string_view lineEndOf(std::string_view bytes) {
    const std::size_t at = bytes.find_first_of("\r\n");
    if (at == std::string_view::npos)
        return "\n";
    return bytes.substr(at, bytes.substr(at).starts_with("\r\n") ? 2 : 1);
}

} // namespace source
