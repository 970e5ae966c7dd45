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

bool Paragraph::isRightToLeft() const {
    if (direction_ != Qt::LayoutDirectionAuto)
        return direction_ == Qt::RightToLeft;
    return !lines_.empty() && layoutOf(0).text().isRightToLeft();
}

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

Paragraph::InSegment Paragraph::segmentAt(int letter) const {
    const int index = lines_[static_cast<std::size_t>(lineOf(letter))].segment;
    return {layoutOf(index), segments_[static_cast<std::size_t>(index)].from};
}

int Paragraph::endOfLine(int line) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    if (static_cast<std::size_t>(line) + 1 == lines_.size())
        return of.to;
    const auto [layout, from] = segmentAt(of.from);
    return std::max(of.from, from + layout.previousCursorPosition(of.to - from));
}

int Paragraph::placeAt(int line, double x) const {
    const Line& of = lines_[static_cast<std::size_t>(line)];
    const int from = segments_[static_cast<std::size_t>(of.segment)].from;
    const int place = from + drawn(line).xToCursor(x, QTextLine::CursorBetweenCharacters);
    return std::clamp(place, of.from, endOfLine(line));
}

// LIMIT: at the border of two segments the caret goes by the order of the text.
int Paragraph::placeBeside(int letter, Side side) const {
    const auto [layout, from] = segmentAt(letter);
    const int next = from + (side == Side::left ? layout.leftCursorPosition(letter - from)
                                                : layout.rightCursorPosition(letter - from));
    const bool onward = (side == Side::right) != isRightToLeft();
    if (next != letter || letter == 0 || onward)
        return next;
    const auto before = segmentAt(letter - 1);
    return before.from + before.layout.previousCursorPosition(letter - before.from);
}

int Paragraph::nextWord(int letter) const {
    const auto [layout, from] = segmentAt(letter);
    return from + layout.nextCursorPosition(letter - from, QTextLayout::SkipWords);
}

int Paragraph::previousWord(int letter) const {
    const auto [layout, from] = segmentAt(std::max(0, letter - 1));
    return from + layout.previousCursorPosition(letter - from, QTextLayout::SkipWords);
}

std::pair<double, double> Paragraph::edgesOf(int line, int letter) const {
    const int from =
        segments_[static_cast<std::size_t>(lines_[static_cast<std::size_t>(line)].segment)].from;
    const QTextLine of = drawn(line);
    const double leading = of.cursorToX(letter - from, QTextLine::Leading);
    const double trailing = of.cursorToX(letter - from, QTextLine::Trailing);
    return std::minmax(leading, trailing);
}

} // namespace layout
