// A formula as set: glyphs and rules with places.
//
// Method: The TeXbook, Appendix G, with the numbers that the font's MATH table has for its rules.
// Lengths are in the unit of `size` (layout: twips); x goes right from the left end, y down from
// the base line. Work is linear in the formula's nodes times the depth of their nesting.
#pragma once

#include "formulas/font.h"
#include "formulas/formula.h"

#include <QRectF>

namespace formulas {

struct PlacedGlyph {
    GlyphId glyph = 0;
    double x = 0, y = 0; // of its origin
    double size = 0;
    bool faulty = false;
};

// The frame of a part that waits to be written.
struct PlacedPart {
    QRectF frame;
    std::size_t place = 0; // in the source
};

struct Box {
    double width = 0, ascent = 0, descent = 0;
    double italic = 0;                 // in the width; subscripts begin before it
    std::optional<GlyphId> letter;     // when it is one sign: scripts stand as beside a letter
    std::optional<double> accentPlace; // of an accent over it; else its middle
    std::vector<PlacedGlyph> glyphs;
    std::vector<QRectF> rules;
    std::vector<PlacedPart> waiting;

    // Puts another box, whose origin comes to stand at the place, on this one.
    void put(const Box& box, double x, double y);
};

// A part that stays on one line. The space behind it is left out at the line's end.
struct Piece {
    Box box;
    double space = 0;
};

struct Set {
    double width = 0, ascent = 0, descent = 0; // on one line
    std::vector<Piece> pieces; // a line may end behind each; of a display there is one
    std::vector<Fault> faults; // letters that the font has not
};

// As one piece, which no line breaks.
[[nodiscard]] Set whole(const Set& set);

// `size`: of the letters, in any unit. Style::text is for the line, Style::display stands alone.
// Empty parts take room with Empty::framed, as while a formula is written.
enum class Empty { unseen, framed };
[[nodiscard]] Set typeset(const Formula& formula, Style style, double size, const Font& font,
                          Empty empty = Empty::unseen);

} // namespace formulas
