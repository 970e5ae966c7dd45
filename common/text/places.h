// Places of a text as lines and columns, and back.
//
// Lines and columns count from 1, columns in characters. A line ends with LF, CR LF or CR. A
// byte-order mark at the start takes no column; a byte that is not valid UTF-8 takes one unless it
// looks like one behind the first of a character.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace text {

struct Position {
    int line = 0; // 0: no place is known
    int column = 0;
    bool operator==(const Position&) const = default;
    auto operator<=>(const Position&) const = default;
};

// Reads the text once; then each place costs next to nothing. The text must stay where it is.
class Places {
public:
    explicit Places(std::string_view text);

    // Of the character that the byte belongs to; past the text's end, that of the end.
    [[nodiscard]] Position at(std::size_t offset) const;
    // Past the end of its line, the end of that line; past the last line, the end of the text.
    [[nodiscard]] std::size_t offset(Position position) const;

private:
    [[nodiscard]] std::size_t charactersBefore(std::size_t offset) const;
    [[nodiscard]] std::size_t endOfLine(std::size_t line) const; // from 0

    static constexpr std::size_t blockSize = 256;
    std::string_view text_;
    std::vector<std::size_t> lines_;  // where each starts
    std::vector<std::size_t> blocks_; // characters before each block of bytes
};

// Bytes that this thread has read for places, for tests.
[[nodiscard]] std::size_t& bytesPlaced();

} // namespace text
