// Fractions (rule 15), roots (11), bars (9, 10), accents (12), and what is as wide as its base.
#include "formulas/typesetter.h"

#include <algorithm>

namespace formulas {

namespace {

constexpr double besideFraction = 0.12; // em: TeX's \nulldelimiterspace

Style inFraction(Style style) {
    switch (style) {
    case Style::display:
        return Style::text;
    case Style::text:
        return Style::script;
    default:
        return Style::scriptscript;
    }
}

} // namespace

Typesetter::Place Typesetter::fractionPlace(const Box& above, const Box& below, bool line,
                                            Setting setting) const {
    const bool display = setting.style == Style::display;
    const auto choose = [&](Constant inDisplay, Constant inText) {
        return length(display ? inDisplay : inText, setting);
    };
    Place place;
    if (!line) {
        place.up = choose(HB_OT_MATH_CONSTANT_STACK_TOP_DISPLAY_STYLE_SHIFT_UP,
                          HB_OT_MATH_CONSTANT_STACK_TOP_SHIFT_UP);
        place.down = choose(HB_OT_MATH_CONSTANT_STACK_BOTTOM_DISPLAY_STYLE_SHIFT_DOWN,
                            HB_OT_MATH_CONSTANT_STACK_BOTTOM_SHIFT_DOWN);
        const double least = choose(HB_OT_MATH_CONSTANT_STACK_DISPLAY_STYLE_GAP_MIN,
                                    HB_OT_MATH_CONSTANT_STACK_GAP_MIN);
        const double gap = (place.up - above.descent) - (below.ascent - place.down);
        const double lacks = std::max(0.0, least - gap);
        return {place.up + lacks / 2, place.down + lacks / 2};
    }
    const double half = length(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS, setting) / 2;
    const double overLine = choose(HB_OT_MATH_CONSTANT_FRACTION_NUM_DISPLAY_STYLE_GAP_MIN,
                                   HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_GAP_MIN);
    const double underLine = choose(HB_OT_MATH_CONSTANT_FRACTION_DENOM_DISPLAY_STYLE_GAP_MIN,
                                    HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_GAP_MIN);
    place.up = choose(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP,
                      HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_SHIFT_UP);
    place.down = choose(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN,
                        HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_SHIFT_DOWN);
    place.up = std::max(place.up, axis(setting) + half + overLine + above.descent);
    place.down = std::max(place.down, half + underLine + below.ascent - axis(setting));
    return place;
}

Box Typesetter::fraction(const Node& node, Setting setting) {
    if (node.styled)
        setting.style = node.style;
    const Style style = inFraction(setting.style);
    const Box above = this->node(node.children[0], {style, setting.cramped});
    const Box below = this->node(node.children[1], {style, true});
    const bool line = node.amount > 0;
    const Place place = fractionPlace(above, below, line, setting);
    const double width = std::max(above.width, below.width);
    const double beside = line ? besideFraction * sizeOf(setting) : 0;
    Box box;
    box.put(above, beside + (width - above.width) / 2, -place.up);
    box.put(below, beside + (width - below.width) / 2, place.down);
    if (line) {
        const double thickness = length(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS, setting);
        const double top = -axis(setting) - thickness / 2;
        box.rules.emplace_back(beside, top, width, thickness);
    }
    box.width = width + 2 * beside;
    return box;
}

Box Typesetter::root(const Node& node, Setting setting) {
    const Box inside = this->node(node.children[0], {setting.style, true});
    const double thickness = length(HB_OT_MATH_CONSTANT_RADICAL_RULE_THICKNESS, setting);
    double gap = length(setting.style == Style::display
                            ? HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP
                            : HB_OT_MATH_CONSTANT_RADICAL_VERTICAL_GAP,
                        setting);
    const double needed = inside.ascent + inside.descent + gap + thickness;
    const double size = sizeOf(setting);
    const Grown grown = font_.grown(font_.glyph(U'√').value_or(0), true, needed / size);
    const Box sign = grownBox(grown, true, size);
    const double height = sign.ascent + sign.descent;
    if (height > needed)
        gap += (height - needed) / 2;
    const double top = inside.ascent + gap + thickness; // of the line, above the base line
    Box box;
    double x = 0;
    if (node.children[1] != none) {
        const Box degree = this->node(node.children[1], {Style::scriptscript, true});
        const double raise =
            font_.percent(HB_OT_MATH_CONSTANT_RADICAL_DEGREE_BOTTOM_RAISE_PERCENT) * height;
        const double before = length(HB_OT_MATH_CONSTANT_RADICAL_KERN_BEFORE_DEGREE, setting);
        const double after = length(HB_OT_MATH_CONSTANT_RADICAL_KERN_AFTER_DEGREE, setting);
        box.put(degree, before, height - top - raise - degree.descent);
        x = std::max(0.0, before + degree.width + after);
    }
    box.put(sign, x, sign.ascent - top);
    x += sign.width;
    box.rules.emplace_back(x, -top, inside.width, thickness);
    box.put(inside, x, 0);
    box.width = x + inside.width;
    box.ascent =
        std::max(box.ascent, top + length(HB_OT_MATH_CONSTANT_RADICAL_EXTRA_ASCENDER, setting));
    return box;
}

Box Typesetter::bar(const Node& node, Setting setting) {
    const bool over = node.code == 0x305;
    Box box = this->node(node.children.front(), {setting.style, over || setting.cramped});
    const auto choose = [&](Constant above, Constant below) {
        return length(over ? above : below, setting);
    };
    const double gap =
        choose(HB_OT_MATH_CONSTANT_OVERBAR_VERTICAL_GAP, HB_OT_MATH_CONSTANT_UNDERBAR_VERTICAL_GAP);
    const double thickness = choose(HB_OT_MATH_CONSTANT_OVERBAR_RULE_THICKNESS,
                                    HB_OT_MATH_CONSTANT_UNDERBAR_RULE_THICKNESS);
    const double extra = choose(HB_OT_MATH_CONSTANT_OVERBAR_EXTRA_ASCENDER,
                                HB_OT_MATH_CONSTANT_UNDERBAR_EXTRA_DESCENDER);
    if (over) {
        box.rules.emplace_back(0, -box.ascent - gap - thickness, box.width, thickness);
        box.ascent += gap + thickness + extra;
    } else {
        box.rules.emplace_back(0, box.descent + gap, box.width, thickness);
        box.descent += gap + thickness + extra;
    }
    box.letter.reset();
    box.italic = 0;
    return box;
}

// The letter under the accent: i and j without their dots.
Box Typesetter::accented(const Node& node, Setting setting) {
    const Node& base = formula_.node(node.children.front());
    Box box = this->node(node.children.front(), {setting.style, true});
    if (base.kind == Kind::symbol && (base.letter == U'i' || base.letter == U'j'))
        if (const auto glyph = font_.dotless(base.code)) {
            const Box plain = glyphBox(*glyph, sizeOf(setting));
            box.glyphs = plain.glyphs;
            box.ascent = plain.ascent;
            box.accentPlace = font_.accentPlace(*glyph) * sizeOf(setting);
        }
    return box;
}

Box Typesetter::accent(const Node& node, Setting setting) {
    Box box = accented(node, setting);
    const double size = sizeOf(setting);
    const std::optional<GlyphId> sign = font_.glyph(node.code);
    if (!sign)
        return box;
    const double inkWidth = box.width - box.italic;
    const GlyphId glyph = node.amount > 0 ? font_.widest(*sign, box.width / size) : *sign;
    Box over = glyphBox(glyph, size);
    const double up =
        std::max(0.0, box.ascent - length(HB_OT_MATH_CONSTANT_ACCENT_BASE_HEIGHT, setting));
    const double place = box.accentPlace.value_or(inkWidth / 2);
    const double width = box.width;
    box.put(over, place - font_.accentPlace(glyph) * size, -up);
    box.width = width;
    box.accentPlace = place;
    return box;
}

Box Typesetter::stretch(const Node& node, Setting setting) {
    const bool below = node.code == U'⏟' || node.code == U'⎵';
    const bool arrow = node.code == U'→' || node.code == U'←' || node.code == U'↔';
    Box base = this->node(node.children.front(), {setting.style, setting.cramped});
    const double size = sizeOf(setting);
    const std::optional<GlyphId> glyph = font_.glyph(node.code);
    if (!glyph)
        return base;
    const Box sign = grownBox(font_.grown(*glyph, false, base.width / size), false, size);
    const double gap =
        (arrow ? 0.5 : 1) * length(HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_BELOW_MIN, setting);
    const double width = std::max(base.width, sign.width);
    Box box;
    box.put(base, (width - base.width) / 2, 0);
    const double y = below ? base.descent + gap + sign.ascent : -(base.ascent + gap + sign.descent);
    box.put(sign, (width - sign.width) / 2, y);
    box.width = width;
    return box;
}

Box Typesetter::arrow(const Node& node, Setting setting) {
    const Style style = isScriptStyle(setting.style) ? Style::scriptscript : Style::script;
    const Box above = this->node(node.children[0], {style, setting.cramped});
    const Box below = this->node(node.children[1], {style, true});
    const double size = sizeOf(setting);
    const double least = std::max({above.width, below.width, size * 0.6}) + size * 0.6;
    const Grown grown = font_.grown(font_.glyph(node.code).value_or(0), false, least / size);
    const Box sign = grownBox(grown, false, size);
    const double gap = length(HB_OT_MATH_CONSTANT_STRETCH_STACK_GAP_ABOVE_MIN, setting);
    Box box;
    box.put(sign, 0, 0);
    box.width = std::max(sign.width, least);
    box.put(above, (box.width - above.width) / 2, -(sign.ascent + gap + above.descent));
    if (node.children[1] != none)
        box.put(below, (box.width - below.width) / 2, sign.descent + gap + below.ascent);
    return box;
}

} // namespace formulas
