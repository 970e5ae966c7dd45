#include "formulas/typesetter.h"

#include "formulas/atoms.h"
#include "formulas/symbols.h"

#include <algorithm>
#include <array>

namespace formulas {

namespace {

// Between two atoms, in eighteenths of an em: TeX's table. Negative: not in scripts.
// clang-format off
constexpr std::array<std::array<int, 8>, 8> spacing{{
    //           ord  op  bin  rel open close punct inner
    /* ord   */ {0,   3,  -4,  -5,  0,   0,    0,   -3},
    /* op    */ {3,   3,   0,  -5,  0,   0,    0,   -3},
    /* bin   */ {-4, -4,   0,   0, -4,   0,    0,   -4},
    /* rel   */ {-5, -5,   0,   0, -5,   0,    0,   -5},
    /* open  */ {0,   0,   0,   0,  0,   0,    0,    0},
    /* close */ {0,   3,  -4,  -5,  0,   0,    0,   -3},
    /* punct */ {-3, -3,   0,  -3, -3,  -3,   -3,   -3},
    /* inner */ {-3,  3,  -4,  -5, -3,   0,   -3,   -3},
}};
// clang-format on

// An integral of a display is two lines high, as in TeX's own fonts, where the font can.
constexpr double integralHeight = 2; // em

double between(Atom left, Atom right, Style style) {
    const int space = spacing[static_cast<std::size_t>(left)][static_cast<std::size_t>(right)];
    return space < 0 ? (isScriptStyle(style) ? 0 : -space / 18.0) : space / 18.0;
}

} // namespace

void Box::put(const Box& box, double x, double y) {
    for (PlacedGlyph glyph : box.glyphs) {
        glyph.x += x;
        glyph.y += y;
        glyphs.push_back(glyph);
    }
    for (const QRectF& rule : box.rules)
        rules.push_back(rule.translated(x, y));
    for (const PlacedPart& part : box.waiting)
        waiting.push_back({part.frame.translated(x, y), part.place});
    ascent = std::max(ascent, box.ascent - y);
    descent = std::max(descent, box.descent + y);
}

double Typesetter::sizeOf(Setting setting) const {
    if (setting.style == Style::script)
        return size_ * font_.percent(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN);
    if (setting.style == Style::scriptscript)
        return size_ * font_.percent(HB_OT_MATH_CONSTANT_SCRIPT_SCRIPT_PERCENT_SCALE_DOWN);
    return size_;
}

double Typesetter::length(Constant constant, Setting setting) const {
    return font_.constant(constant) * sizeOf(setting);
}

double Typesetter::axis(Setting setting) const {
    return length(HB_OT_MATH_CONSTANT_AXIS_HEIGHT, setting);
}

void Typesetter::report(const Node& node, const std::string& letter) {
    if (faults_.size() < mostFaults)
        faults_.push_back(
            {node.offset, node.end, "The font for formulas has no letter " + letter + "."});
}

std::optional<GlyphId> Typesetter::glyphOf(char32_t code, Setting setting) {
    const int level = setting.style == Style::script         ? 1
                      : setting.style == Style::scriptscript ? 2
                                                             : 0;
    return font_.glyph(code, level);
}

Box Typesetter::glyphBox(GlyphId glyph, double size) const {
    const GlyphSize own = font_.size(glyph);
    Box box;
    box.width = own.width * size;
    box.ascent = own.ascent * size;
    box.descent = own.descent * size;
    box.glyphs.push_back({glyph, 0, 0, size, false});
    return box;
}

std::vector<Typesetter::Item> Typesetter::row(NodeId id, Setting setting, bool afterOrdinary) {
    const Node& list = formula_.node(id);
    const std::vector<Atom> atoms = atomsOf(formula_, id, afterOrdinary);
    std::vector<Item> items;
    items.reserve(atoms.size());
    std::size_t next = 0;
    double space = 0;
    for (const NodeId child : list.children) {
        const Node& node = formula_.node(child);
        if (node.kind == Kind::style) {
            setting.style = node.style;
        } else if (node.kind == Kind::space) {
            space += node.amount * sizeOf(setting);
        } else {
            if (next > 0 || afterOrdinary) {
                const Atom before = next > 0 ? atoms[next - 1] : Atom::ordinary;
                space += between(before, atoms[next], setting.style) * sizeOf(setting);
            }
            items.push_back({this->node(child, setting), atoms[next], space});
            space = 0;
            ++next;
        }
    }
    if (space != 0) {
        Box blank;
        items.push_back({blank, Atom::ordinary, space});
    }
    return items;
}

Box Typesetter::joined(const std::vector<Item>& items) {
    if (items.size() == 1 && items.front().before == 0)
        return items.front().box;
    Box box;
    double x = 0;
    for (const Item& item : items) {
        x += item.before;
        box.put(item.box, x, 0);
        x += item.box.width;
    }
    box.width = x;
    return box;
}

Box Typesetter::list(NodeId id, Setting setting) {
    const auto empty = std::ranges::find(framed_, id, &EmptyPart::node);
    return empty == framed_.end() ? joined(row(id, setting)) : frame(empty->place, setting);
}

// As high as a capital letter, and as wide as most are.
Box Typesetter::frame(std::size_t place, Setting setting) const {
    constexpr double width = 0.6, height = 0.7, beside = 0.08; // em
    const double size = sizeOf(setting);
    Box box;
    box.width = (width + 2 * beside) * size;
    box.ascent = height * size;
    box.waiting.push_back({{beside * size, -height * size, width * size, height * size}, place});
    return box;
}

Box Typesetter::node(NodeId id, Setting setting) {
    if (id == none)
        return {};
    const Node& node = formula_.node(id);
    switch (node.kind) {
    case Kind::symbol:
        return symbol(node, setting);
    case Kind::text:
        return words(node, setting);
    case Kind::list:
        return list(id, setting);
    case Kind::scripts: {
        const bool above = node.limits == Limits::always ||
                           (node.limits == Limits::byStyle && setting.style == Style::display);
        return above ? limits(node, setting) : scripts(node, setting);
    }
    case Kind::fraction:
        return fraction(node, setting);
    case Kind::root:
        return root(node, setting);
    case Kind::accent:
        return accent(node, setting);
    case Kind::bar:
        return bar(node, setting);
    case Kind::stretch:
        return stretch(node, setting);
    case Kind::arrow:
        return arrow(node, setting);
    case Kind::fenced:
        return fenced(node, setting);
    case Kind::delimiter:
        return delimiter(node.code, node.amount * sizeOf(setting), setting);
    case Kind::array:
        return array(node, setting);
    case Kind::phantom:
        return phantom(node, setting);
    case Kind::room:
        return inRoom(node, setting);
    case Kind::space:
    case Kind::style:
        break;
    }
    return {};
}

Box Typesetter::symbol(const Node& node, Setting setting) {
    std::optional<GlyphId> glyph = glyphOf(node.code, setting);
    if (!glyph && node.code != node.letter)
        glyph = glyphOf(node.letter, setting);
    if (!glyph) {
        std::string letter;
        append(letter, node.letter);
        report(node, letter);
        glyph = GlyphId{0};
    }
    if (node.atom == Atom::operation)
        return bigOperator(node, *glyph, setting);
    const double size = sizeOf(setting);
    Box box = glyphBox(*glyph, size);
    box.italic = font_.size(*glyph).italic * size;
    box.width += box.italic;
    box.letter = glyph;
    box.accentPlace = font_.accentPlace(*glyph) * size;
    box.glyphs.front().faulty = node.faulty;
    return box;
}

// Larger in a display, and centred about the axis (rule 13).
Box Typesetter::bigOperator(const Node& node, GlyphId glyph, Setting setting) {
    const double size = sizeOf(setting);
    if (setting.style == Style::display) {
        const double usual = font_.constant(HB_OT_MATH_CONSTANT_DISPLAY_OPERATOR_MIN_HEIGHT);
        const bool integral = node.code >= U'∫' && node.code <= U'∳';
        const double least = integral ? std::max(usual, integralHeight) : usual;
        const Grown grown = font_.grown(glyph, true, least);
        if (grown.pieces.size() == 1)
            glyph = grown.pieces.front().glyph;
    }
    Box box = glyphBox(glyph, size); // its width has the lean in it, unlike a letter's
    box.italic = font_.size(glyph).italic * size;
    box.glyphs.front().faulty = node.faulty;
    centre(box, setting);
    return box;
}

void Typesetter::centre(Box& box, Setting setting) const {
    const double shift = (box.ascent - box.descent) / 2 - axis(setting); // down
    for (PlacedGlyph& glyph : box.glyphs)
        glyph.y += shift;
    for (QRectF& rule : box.rules)
        rule.translate(0, shift);
    box.ascent -= shift;
    box.descent += shift;
}

Box Typesetter::words(const Node& node, Setting setting) {
    const double size = sizeOf(setting);
    std::string text;
    if (node.alphabet == Alphabet::bold || node.alphabet == Alphabet::italic) {
        for (const char c : node.text)
            if (static_cast<unsigned char>(c) < 0x80)
                append(text, styled(static_cast<unsigned char>(c), node.alphabet));
            else
                text += c;
    } else {
        text = node.text;
    }
    Box box;
    bool missing = false;
    for (const auto& [glyph, advance] : font_.shaped(text)) {
        missing = missing || glyph == 0;
        Box letter = glyphBox(glyph, size);
        letter.glyphs.front().faulty = node.faulty;
        box.put(letter, box.width, 0);
        box.width += advance * size;
    }
    if (missing)
        report(node, "for all of “" + node.text + "”");
    return box;
}

Box Typesetter::phantom(const Node& node, Setting setting) {
    Box box = this->node(node.children.front(), setting);
    box.glyphs.clear();
    box.rules.clear();
    if (node.code == U'h')
        box.ascent = box.descent = 0;
    if (node.code == U'v')
        box.width = 0;
    return box;
}

Box Typesetter::inRoom(const Node& node, Setting setting) {
    const Box number = this->node(node.children[0], setting);
    const double width = std::max(number.width, this->node(node.children[1], setting).width);
    Box box;
    box.put(number, width - number.width, 0);
    box.width = width;
    return box;
}

Set whole(const Set& set) {
    Set result = set;
    result.pieces.assign(1, {});
    Box& box = result.pieces.front().box;
    double x = 0;
    for (const Piece& piece : set.pieces) {
        box.put(piece.box, x, 0);
        x += piece.box.width + piece.space;
    }
    box.width = x;
    return result;
}

Set typeset(const Formula& formula, Style style, double size, const Font& font, Empty empty) {
    Typesetter typesetter(formula, size, font,
                          empty == Empty::framed ? emptyParts(formula) : std::vector<EmptyPart>());
    const auto items = typesetter.row(formula.root, {style, false});
    Set set;
    std::vector<Typesetter::Item> line;
    for (std::size_t i = 0; i < items.size(); ++i) {
        line.push_back(items[i]);
        if (line.size() == 1 && i > 0)
            line.front().before = 0; // it is the space behind the piece before
        const bool last = i + 1 == items.size();
        const bool breaks = items[i].atom == Atom::binary || items[i].atom == Atom::relation;
        if (last || (style != Style::display && breaks && items[i + 1].atom != Atom::relation)) {
            set.pieces.push_back({Typesetter::joined(line), last ? 0 : items[i + 1].before});
            line.clear();
        }
    }
    if (set.pieces.empty())
        set.pieces.emplace_back();
    for (const Piece& piece : set.pieces) {
        set.width += piece.box.width + piece.space;
        set.ascent = std::max(set.ascent, piece.box.ascent);
        set.descent = std::max(set.descent, piece.box.descent);
    }
    set.faults = typesetter.takeFaults();
    return set;
}

} // namespace formulas
