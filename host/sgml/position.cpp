#include "sgml/position.h"

#include "sgml/work.h"

namespace sgml {

namespace {

// A place that walks forwards through a text.
class Cursor {
public:
    explicit Cursor(std::string_view text) : text_(text) {
        if (text.starts_with(byteOrderMark))
            at_ = byteOrderMark.size();
    }

    ~Cursor() { work().bytesPlaced += at_; }
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;

    [[nodiscard]] bool atEnd() const { return at_ >= text_.size(); }
    [[nodiscard]] std::size_t offset() const { return at_; }
    [[nodiscard]] Position position() const { return position_; }
    [[nodiscard]] bool atLineEnd() const { return text_[at_] == '\n' || text_[at_] == '\r'; }

    void step() {
        const char c = text_[at_++];
        const bool lineEnds = c == '\n' || (c == '\r' && (atEnd() || text_[at_] != '\n'));
        if (lineEnds) {
            ++position_.line;
            position_.column = 1;
        } else if (atEnd() || !continues(text_[at_])) {
            ++position_.column;
        }
    }

private:
    // The column grows at the last byte of a character, so that every byte of it has its place.
    static bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

    std::string_view text_;
    std::size_t at_ = 0;
    Position position_{1, 1};
};

} // namespace

Position positionOf(std::string_view text, std::size_t offset) {
    Cursor cursor(text);
    while (!cursor.atEnd() && cursor.offset() < offset)
        cursor.step();
    return cursor.position();
}

std::vector<Position> positionsOf(std::string_view text, const std::vector<std::size_t>& offsets) {
    std::vector<Position> positions;
    positions.reserve(offsets.size());
    Cursor cursor(text);
    for (const std::size_t offset : offsets) {
        while (!cursor.atEnd() && cursor.offset() < offset)
            cursor.step();
        positions.push_back(cursor.position());
    }
    return positions;
}

std::size_t offsetOf(std::string_view text, Position position) {
    return offsetsOf(text, {position}).front();
}

std::vector<std::size_t> offsetsOf(std::string_view text, const std::vector<Position>& positions) {
    std::vector<std::size_t> offsets;
    offsets.reserve(positions.size());
    Cursor cursor(text);
    for (const Position& position : positions) {
        while (!cursor.atEnd() && cursor.position() < position &&
               !(cursor.position().line == position.line && cursor.atLineEnd()))
            cursor.step();
        offsets.push_back(cursor.offset());
    }
    return offsets;
}

} // namespace sgml
