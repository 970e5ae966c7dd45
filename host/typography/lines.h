// Of the places where lines may end, those that make the best paragraph together.
//
// Method: Knuth and Plass, "Breaking Paragraphs into Lines" (1981). Each line has a badness, the
// cube of how far its blanks are stretched or shrunk; its demerits are the square of that and of
// what its end costs. The lines with the fewest demerits in all are found by dynamic programming
// over the ends that can be reached. Only ends within the width of one line before it count for an
// end, so the work grows with the length of the text.
//
// Ragged lines are chosen the same way: there the space behind the line is what stretches.
#pragma once

#include "typography/breaks.h"

#include <optional>
#include <span>
#include <vector>

namespace typography {

// A place where a line may end. Widths are those of all letters before it.
struct Break {
    int next = 0;                              // the letter that the next line begins with
    double end = 0;                            // without the blanks at the line's end
    double begin = 0;                          // with them
    double blanksAtEnd = 0, blanksAtBegin = 0; // the blanks in these, which stretch and shrink
    double hyphen = 0;                         // width of what the line's end adds; 0: nothing
    int cost = 0;
    bool forced = false; // a line ends here whatever it looks like
};

struct Column {
    double firstWidth = 0, width = 0; // of the first line, and of the others
    bool ragged = false;
    bool even = false;      // ragged: the last line counts as the others do
    double leastOfLast = 0; // a last line that is shorter is a short syllable
};

// How far a blank may go, in parts of its natural width.
inline constexpr double stretchOfBlank = 0.5, shrinkOfBlank = 1.0 / 3;

// The stretch that a line may have: up to so many times `stretchOfBlank`. Ragged: up to so many
// times Column::width / 5 is free. No last line shorter than Column::leastOfLast is fine.
inline constexpr double fine = 1, anything = 1e9;

// The places of `breaks`, by index, where lines end, the last one included, which counts as forced.
// Nothing: some line would go beyond `most`. With `anything` there is always an answer; a line that
// nothing can make short enough is too long. `goesOn`: the text does, so the last line may be
// short.
[[nodiscard]] std::optional<std::vector<std::size_t>>
bestLines(std::span<const Break> breaks, const Column& column, double most, bool goesOn = false);

// By how much the blanks of a line must grow, in parts of their width, to fill `width`; 0 where
// there are none. Never more than a blank can shrink.
[[nodiscard]] double stretchOf(double natural, double blanks, double width);

// Comparisons of two ends of lines so far, for tests.
[[nodiscard]] std::size_t comparisons();

} // namespace typography
