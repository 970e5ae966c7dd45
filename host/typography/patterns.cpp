#include "typography/patterns.h"

#include <QFile>

#include <iconv.h>

#include <algorithm>
#include <cstring>

namespace typography {

namespace {

// From the signs of that name; "" when they are not known.
QString decoded(QByteArray bytes, const QByteArray& signs) {
    if (signs.startsWith("UTF-8"))
        return QString::fromUtf8(bytes);
    const iconv_t state = iconv_open("UTF-8", signs.constData());
    if (state == iconv_t(-1)) // NOLINT(performance-no-int-to-ptr): what iconv says
        return {};
    std::string result(static_cast<std::size_t>(bytes.size()) * 4, '\0');
    char *from = bytes.data(), *to = result.data();
    auto left = static_cast<std::size_t>(bytes.size());
    std::size_t room = result.size();
    const bool read = iconv(state, &from, &left, &to, &room) != static_cast<std::size_t>(-1);
    iconv_close(state);
    result.resize(result.size() - room);
    return read ? QString::fromStdString(result) : QString();
}

} // namespace

Patterns::Patterns(const QString& name) {
    QFile file(name);
    constexpr qint64 most = 16 << 20;
    if (!file.open(QIODevice::ReadOnly))
        return;
    const QByteArray signs = file.readLine(64).trimmed();
    const QString text = decoded(file.read(most), signs);
    for (const QString& line : text.split('\n', Qt::SkipEmptyParts))
        add(line.trimmed());
}

void Patterns::add(const QString& line) {
    const auto tell = [&](const char* word, int& target) {
        if (line.startsWith(QLatin1String(word)))
            target = std::max(2, line.mid(static_cast<qsizetype>(std::strlen(word))).toInt());
    };
    tell("LEFTHYPHENMIN ", leastBefore_);
    tell("RIGHTHYPHENMIN ", leastBehind_);
    const bool isPattern = !line.isEmpty() && line[0] != '#' && line[0] != '%' &&
                           !line.contains('/') && !line.contains(' ') && !line[0].isUpper();
    if (!isPattern)
        return;
    std::u16string letters;
    std::string numbers(1, 0);
    for (const QChar sign : line) {
        if (sign >= '0' && sign <= '9') {
            numbers.back() = static_cast<char>(sign.unicode() - '0');
        } else {
            letters += static_cast<char16_t>(sign.unicode());
            numbers += '\0';
        }
    }
    longest_ = std::max(longest_, letters.size());
    numbers_.emplace(std::move(letters), std::move(numbers));
}

std::vector<int> Patterns::placesIn(const QString& word) const {
    const std::u16string text = u'.' + word.toStdU16String() + u'.';
    std::string found(text.size() + 1, '\0'); // before each letter
    for (std::size_t from = 0; from < text.size(); ++from)
        for (std::size_t length = 1; length <= std::min(longest_, text.size() - from); ++length) {
            const auto known = numbers_.find(std::u16string_view(text).substr(from, length));
            if (known == numbers_.end())
                continue;
            for (std::size_t i = 0; i < known->second.size(); ++i)
                found[from + i] = std::max(found[from + i], known->second[i]);
        }
    std::vector<int> result;
    for (int i = leastBefore_; i <= static_cast<int>(word.size()) - leastBehind_; ++i)
        if (found[static_cast<std::size_t>(i) + 1] % 2 != 0)
            result.push_back(i);
    return result;
}

} // namespace typography
