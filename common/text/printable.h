// Text that somebody else wrote, as a terminal may get it.
//
// A terminal obeys control characters: they move its cursor, name its window, and answer for the
// reader. So each of them is shown as one visible sign: U+2400 to U+241F for what is below a space
// ("␛" for an escape), "␡" for U+007F, and U+FFFD for U+0080 to U+009F and for a byte that is no
// part of UTF-8. Line ends and tabs stay; a carriage return before a line end is part of it.
#pragma once

#include <string>
#include <string_view>

namespace text {

// Characters that order the letters around them from right to left, or back.
enum class Direction {
    shown, // as U+FFFD: in a line of ours they would move our words, too
    kept   // in lines that are the document's own
};

[[nodiscard]] std::string printable(std::string_view text, Direction direction = Direction::shown);

// The text of the character that `text` begins with, or a sign in its place.
// A line end and a tab are shown as signs. `length` becomes the bytes that it has.
[[nodiscard]] std::string_view shownFor(std::string_view text, std::size_t& length);

// Without line ends: each is shown as "␊". For names within a line.
[[nodiscard]] std::string oneLine(std::string_view text);

// One message, with a line end behind it: printable, and its lines after the first begin with four
// blanks, so that none of them looks like the first line of another.
[[nodiscard]] std::string message(std::string_view text);

} // namespace text
