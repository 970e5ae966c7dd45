// Places between the letters of a paragraph, for a caret.
#include "paragraphs/paragraph.h"

#include <algorithm>

namespace paragraphs {

bool Paragraph::isRightToLeft() const { return direction_ == Qt::RightToLeft; }

int Paragraph::lineOf(int letter) const {
    const auto endsBefore = [](int at, const Line& line) { return at < line.to; };
    const auto found = std::upper_bound(lines_.begin(), lines_.end(), letter, endsBefore);
    return static_cast<int>(found == lines_.end() ? lines_.size() - 1 : found - lines_.begin());
}

int Paragraph::endOfLine(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    if (static_cast<std::size_t>(line) + 1 == lines_.size())
        return of.to;
    if (of.end < of.to)
        return std::max(of.from, of.to - 1);
    const Drawn& drawn = drawnOf(line);
    return fromLayout(line, drawn.layout->previousCursorPosition(inLayout(line, of.end)));
}

int Paragraph::placeAt(int line, double x) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    const int place =
        fromLayout(line, drawn(line).xToCursor(x, QTextLine::CursorBetweenCharacters));
    return std::clamp(place, of.from, endOfLine(line));
}

// From line to line the caret goes by the order of the text.
int Paragraph::placeBeside(int letter, Side side) const {
    const int line = lineOf(letter);
    const Line& of = lines_[static_cast<std::size_t>(line)];
    const bool onward = (side == Side::right) != isRightToLeft();
    const bool isLast = static_cast<std::size_t>(line) + 1 == lines_.size();
    if (letter < of.end || (!onward && letter == of.end)) {
        const QTextLayout& layout = *drawnOf(line).layout;
        const int at = inLayout(line, letter);
        const int next = fromLayout(line, side == Side::left ? layout.leftCursorPosition(at)
                                                             : layout.rightCursorPosition(at));
        if (next != letter && (isLast || next <= endOfLine(line)))
            return next;
    } else if (letter < of.to) { // among blanks that are not shown
        const int next = onward ? letter + 1 : letter - 1;
        return isLast || next < of.to ? next : of.to;
    }
    if (onward)
        return isLast ? letter : of.to;
    return line == 0 ? letter : endOfLine(line - 1);
}

namespace {

// The next word and the one before are looked for in so many letters. LIMIT: a longer word ends
// there.
constexpr int around = 4096;

} // namespace

int Paragraph::nextWord(int letter) const {
    const QTextLayout layout(text(letter, around));
    return letter + layout.nextCursorPosition(0, QTextLayout::SkipWords);
}

int Paragraph::previousWord(int letter) const {
    const int from = std::max(0, letter - around);
    const QTextLayout layout(text(from, letter - from));
    return from + layout.previousCursorPosition(letter - from, QTextLayout::SkipWords);
}

std::pair<double, double> Paragraph::edgesOf(int line, int letter) const {
    const QTextLine of = drawn(line);
    const int at = inLayout(line, letter);
    const double leading = of.cursorToX(at, QTextLine::Leading);
    const double trailing = of.cursorToX(at, QTextLine::Trailing);
    return std::minmax(leading, trailing);
}

} // namespace paragraphs
