// Places between the letters of a paragraph, for a caret.
#include "layout/paragraph.h"

#include "text/characters.h"

#include <algorithm>

namespace layout {

namespace {

// Letters of UTF-16 that a character of UTF-8 becomes, and its bytes.
struct Character {
    int letters = 1;
    std::size_t bytes = 1;
};

Character characterAt(const std::string& text, std::size_t at) {
    const std::size_t length = text::characterLength(std::string_view(text).substr(at));
    if (length == 0)
        return {};
    return {length == 4 ? 2 : 1, length};
}

} // namespace

bool Paragraph::isRightToLeft() const { return direction_ == Qt::RightToLeft; }

int Paragraph::startOfRun(std::size_t run) const { return read(0, run + 1).runStarts[run]; }

int Paragraph::endOfRun(std::size_t run) const {
    if (run + 1 < block_->runs.size())
        return startOfRun(run + 1);
    return static_cast<int>(read(0, run + 1).text.size());
}

int Paragraph::letterAt(std::size_t run, std::size_t byte) const {
    const std::string& text = block_->runs[run].text;
    int letter = startOfRun(run);
    for (std::size_t at = 0; at < std::min(byte, text.size());) {
        const Character character = characterAt(text, at);
        at += character.bytes;
        if (at <= byte)
            letter += character.letters;
    }
    return letter;
}

std::size_t Paragraph::byteAt(std::size_t run, int letter) const {
    const std::string& text = block_->runs[run].text;
    std::size_t at = 0;
    for (int left = letter - startOfRun(run); left > 0 && at < text.size();) {
        const Character character = characterAt(text, at);
        at += character.bytes;
        left -= character.letters;
    }
    return at;
}

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

} // namespace layout
