// Delimiters as high as what is between them (rule 19), and rows of columns.
#include "formulas/typesetter.h"

#include <algorithm>

namespace formulas {

namespace {

// TeX's: a delimiter covers 901/1000 of what is between, and lacks at most half an em.
constexpr double covered = 0.901, shortest = 0.5;

constexpr double apart = 0.15; // em: more between rows that are higher than a line

struct ArrayLook {
    Style style = Style::text;
    double above = 0.84, below = 0.36; // em: a row is at least that high, as TeX's strut
    double between = 1;                // em: columns
    double rows = 0;                   // em: more between rows
};

ArrayLook lookOf(ArrayForm form, Style around) {
    switch (form) {
    case ArrayForm::matrix:
        return {};
    case ArrayForm::small:
        return {Style::script, 0.7, 0.25, 0.5, 0};
    case ArrayForm::cases:
        return {Style::text, 1.008, 0.432, 1, 0};
    case ArrayForm::aligned:
        return {Style::display, 0.84, 0.36, 2, 0.3};
    case ArrayForm::gathered:
        return {Style::display, 0.84, 0.36, 1, 0.3};
    case ArrayForm::stack:
        return {around, 0.7, 0.25, 0.5, 0};
    }
    return {};
}

struct Cells {
    std::vector<Box> boxes; // row by row
    std::vector<double> widths, above, below;
};

} // namespace

Box Typesetter::grownBox(const Grown& grown, bool vertical, double size) const {
    Box box;
    for (const Grown::Piece& piece : grown.pieces) {
        const Box part = glyphBox(piece.glyph, size);
        const double x = vertical ? 0 : piece.from * size;
        box.put(part, x, vertical ? -piece.from * size - part.descent : 0);
        box.width = std::max(box.width, part.width);
    }
    if (!vertical)
        box.width = grown.length * size;
    box.ascent = box.descent = grown.pieces.empty() ? 0 : -1e9; // the base line is not in its ink
    for (const PlacedGlyph& glyph : box.glyphs) {
        const GlyphSize own = font_.size(glyph.glyph);
        box.ascent = std::max(box.ascent, own.ascent * size - glyph.y);
        box.descent = std::max(box.descent, own.descent * size + glyph.y);
    }
    return box;
}

Box Typesetter::delimiter(char32_t code, double atLeast, Setting setting) {
    const double size = sizeOf(setting);
    Box box;
    if (code == U'.') {
        box.width = 0.12 * size;
        return box;
    }
    const std::optional<GlyphId> glyph = font_.glyph(code);
    if (!glyph)
        return box;
    box = grownBox(font_.grown(*glyph, true, atLeast / size), true, size);
    centre(box, setting);
    return box;
}

Box Typesetter::fenced(const Node& node, Setting setting) {
    std::vector<Box> parts;
    double far = 0; // from the axis
    for (const NodeId child : node.children) {
        parts.push_back(this->node(child, setting));
        far = std::max(
            {far, parts.back().ascent - axis(setting), parts.back().descent + axis(setting)});
    }
    const double atLeast = std::max(2 * far * covered, 2 * far - shortest * sizeOf(setting));
    Box box;
    double x = 0;
    for (std::size_t i = 0; i < node.delimiters.size(); ++i) {
        const Box sign = delimiter(node.delimiters[i], atLeast, setting);
        box.put(sign, x, 0);
        x += sign.width;
        if (i < parts.size()) {
            box.put(parts[i], x, 0);
            x += parts[i].width;
        }
    }
    box.width = x;
    return box;
}

Box Typesetter::array(const Node& node, Setting setting) {
    const ArrayLook look = lookOf(node.form, setting.style);
    const std::size_t columns = node.text.size();
    const std::size_t rows = columns == 0 ? 0 : node.children.size() / columns;
    const Setting inside{look.style, setting.cramped};
    const double size = sizeOf(inside);
    Cells cells;
    cells.widths.assign(columns, 0);
    cells.above.assign(rows, look.above * size);
    cells.below.assign(rows, look.below * size);
    for (std::size_t i = 0; i < rows * columns; ++i) {
        const bool second = node.form == ArrayForm::aligned && i % columns % 2 == 1;
        const NodeId id = node.children[i];
        Box box = id == none ? Box() : joined(row(id, inside, second));
        cells.widths[i % columns] = std::max(cells.widths[i % columns], box.width);
        cells.above[i / columns] = std::max(cells.above[i / columns], box.ascent);
        cells.below[i / columns] = std::max(cells.below[i / columns], box.descent);
        cells.boxes.push_back(std::move(box));
    }
    Box box;
    double y = 0;
    for (std::size_t r = 0; r < rows; ++r) {
        const bool high =
            r > 0 && (cells.above[r] > look.above * size || cells.below[r - 1] > look.below * size);
        y += cells.above[r] + (r > 0 ? look.rows * size : 0) + (high ? apart * size : 0);
        double x = 0;
        for (std::size_t c = 0; c < columns; ++c) {
            const bool pair = node.form == ArrayForm::aligned && c % 2 == 1;
            x += c == 0 || pair ? 0 : look.between * size;
            const Box& cell = cells.boxes[r * columns + c];
            const double room = cells.widths[c] - cell.width;
            const double aside = node.text[c] == 'l' ? 0 : node.text[c] == 'r' ? room : room / 2;
            box.put(cell, x + aside, y);
            x += cells.widths[c];
            box.width = x;
        }
        y += cells.below[r];
    }
    box.ascent = 0;
    box.descent = y;
    centre(box, setting);
    return box;
}

} // namespace formulas
