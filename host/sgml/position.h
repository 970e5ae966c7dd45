// A place in a text: as bytes [from, to) and as line and column.
//
// Lines and columns count from 1, columns in characters. A line ends with LF, CR LF or CR. A
// byte-order mark at the start takes no column; a byte that is not valid UTF-8 takes one unless it
// looks like a continuation byte.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace sgml {

struct Range {
    std::size_t from = 0;
    std::size_t to = 0;
    [[nodiscard]] std::size_t size() const { return to - from; }
    [[nodiscard]] bool empty() const { return to == from; }
    [[nodiscard]] bool contains(std::size_t offset) const { return from <= offset && offset < to; }
    bool operator==(const Range&) const = default;
};

struct Position {
    int line = 0; // 0: no place is known
    int column = 0;
    bool operator==(const Position&) const = default;
    auto operator<=>(const Position&) const = default;
};

inline constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";

// The place of one offset, found by reading the text up to it.
[[nodiscard]] Position positionOf(std::string_view text, std::size_t offset);

// The same for many offsets, which must not decrease: reads the text once.
[[nodiscard]] std::vector<Position> positionsOf(std::string_view text,
                                                const std::vector<std::size_t>& offsets);

// The offset of a place; past the end of its line, the end of that line; past the last line, the
// end of the text.
[[nodiscard]] std::size_t offsetOf(std::string_view text, Position position);

// The same for many places, which must not decrease: reads the text once.
[[nodiscard]] std::vector<std::size_t> offsetsOf(std::string_view text,
                                                 const std::vector<Position>& positions);

} // namespace sgml
