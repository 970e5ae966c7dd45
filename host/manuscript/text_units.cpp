#include "manuscript/text_units.h"

#include "text/characters.h"

#include <QTextBoundaryFinder>

#include <algorithm>

namespace manuscript {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

} // namespace

TextUnits::TextUnits(std::string_view text, bool isFlowing) : text_(text), isFlowing_(isFlowing) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = text::characterLength(text.substr(at));
        const QString character =
            length == 0 ? QString(QChar::ReplacementCharacter)
                        : QString::fromUtf8(text.data() + at, static_cast<qsizetype>(length));
        string_ += character;
        offsets_.insert(offsets_.end(), static_cast<std::size_t>(character.size()), at);
        at += std::max(length, std::size_t{1});
    }
    offsets_.push_back(text.size());
}

qsizetype TextUnits::index(std::size_t at) const {
    return std::lower_bound(offsets_.begin(), offsets_.end(), at) - offsets_.begin();
}

std::size_t TextUnits::beside(std::size_t at, Direction direction, Unit unit) const {
    const bool isAtEnd = direction == Direction::forward ? at >= text_.size() : at == 0;
    if (isAtEnd)
        return std::min(at, text_.size());
    return unit == Unit::word ? wordBeside(at, direction) : characterBeside(at, direction);
}

std::size_t TextUnits::characterBeside(std::size_t at, Direction direction) const {
    const std::size_t blanks = isFlowing_ ? besideBlanks(at, direction) : at;
    if (blanks != at)
        return blanks;
    QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, string_);
    finder.setPosition(index(at));
    const qsizetype to =
        direction == Direction::forward ? finder.toNextBoundary() : finder.toPreviousBoundary();
    return offsets_[static_cast<std::size_t>(std::max<qsizetype>(to, 0))];
}

// The other end of the blanks beside a place, if there is a line end among them.
std::size_t TextUnits::besideBlanks(std::size_t at, Direction direction) const {
    std::size_t from = at, to = at;
    if (direction == Direction::forward)
        while (to < text_.size() && isBlank(text_[to]))
            ++to;
    else
        while (from > 0 && isBlank(text_[from - 1]))
            --from;
    if (text_.substr(from, to - from).find_first_of("\r\n") == std::string_view::npos)
        return at;
    return direction == Direction::forward ? to : from;
}

std::size_t TextUnits::wordBeside(std::size_t at, Direction direction) const {
    QTextBoundaryFinder finder(QTextBoundaryFinder::Word, string_);
    finder.setPosition(index(at));
    const auto wanted = direction == Direction::forward ? QTextBoundaryFinder::EndOfItem
                                                        : QTextBoundaryFinder::StartOfItem;
    for (;;) {
        const qsizetype to =
            direction == Direction::forward ? finder.toNextBoundary() : finder.toPreviousBoundary();
        if (to < 0)
            return direction == Direction::forward ? text_.size() : 0;
        if (finder.boundaryReasons().testFlag(wanted))
            return offsets_[static_cast<std::size_t>(to)];
    }
}

std::size_t TextUnits::snapped(std::size_t at, Direction direction) const {
    at = std::min(at, text_.size());
    QTextBoundaryFinder finder(QTextBoundaryFinder::Grapheme, string_);
    const qsizetype from = index(at);
    finder.setPosition(from);
    if (offsets_[static_cast<std::size_t>(from)] == at && finder.isAtBoundary())
        return at;
    return characterBeside(at, direction);
}

} // namespace manuscript
