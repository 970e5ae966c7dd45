// Scripts beside a base (rule 18), and above and below it (rule 13a).
#include "formulas/typesetter.h"

#include <algorithm>

namespace formulas {

namespace {

// The distances that TeX's own fonts ask for, in em; a font that asks for less makes limits touch
// their operator.
constexpr double leastRise = 0.2, leastGapAbove = 0.111, leastDrop = 0.6, leastGapBelow = 0.167;

Style smaller(Style style) {
    return style == Style::display || style == Style::text ? Style::script : Style::scriptscript;
}

} // namespace

// How far the two may go into each other's corners: the table of both, at the heights where one
// ends and the other begins.
double Typesetter::corner(const Box& base, const Box& script, bool above, double shift) const {
    if (!base.letter || base.glyphs.empty())
        return 0;
    const double size = base.glyphs.front().size;
    const auto baseCorner = above ? HB_OT_MATH_KERN_TOP_RIGHT : HB_OT_MATH_KERN_BOTTOM_RIGHT;
    const auto scriptCorner = above ? HB_OT_MATH_KERN_BOTTOM_LEFT : HB_OT_MATH_KERN_TOP_LEFT;
    const auto kernAt = [&](double height) { // above the base's base line
        double kern = font_.kern(*base.letter, baseCorner, height / size) * size;
        if (script.letter && !script.glyphs.empty()) {
            const double small = script.glyphs.front().size;
            kern += font_.kern(*script.letter, scriptCorner, (height - shift) / small) * small;
        }
        return kern;
    };
    if (above)
        return std::max(kernAt(shift - script.descent), kernAt(base.ascent));
    return std::max(kernAt(shift + script.ascent), kernAt(-base.descent));
}

Typesetter::Place Typesetter::scriptPlace(const Box& base, const Box* above, const Box* below,
                                          Setting setting) const {
    Place place;
    if (!base.letter) {
        place.up = base.ascent - length(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BASELINE_DROP_MAX, setting);
        place.down =
            base.descent + length(HB_OT_MATH_CONSTANT_SUBSCRIPT_BASELINE_DROP_MIN, setting);
    }
    if (below != nullptr) {
        place.down =
            std::max(place.down, length(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN, setting));
        if (above == nullptr)
            place.down = std::max(
                place.down, below->ascent - length(HB_OT_MATH_CONSTANT_SUBSCRIPT_TOP_MAX, setting));
    }
    if (above == nullptr)
        return place;
    const Constant usual = setting.cramped ? HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED
                                           : HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP;
    place.up =
        std::max({place.up, length(usual, setting),
                  above->descent + length(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MIN, setting)});
    if (below == nullptr)
        return place;
    const double gap = (place.up - above->descent) - (below->ascent - place.down);
    const double lacks = length(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN, setting) - gap;
    if (lacks <= 0)
        return place;
    place.down += lacks;
    const double most = length(HB_OT_MATH_CONSTANT_SUPERSCRIPT_BOTTOM_MAX_WITH_SUBSCRIPT, setting);
    if (const double rises = most - (place.up - above->descent); rises > 0) {
        const double moved = std::min(rises, lacks);
        place.up += moved;
        place.down -= moved;
    }
    return place;
}

Box Typesetter::scripts(const Node& node, Setting setting) {
    const Box base = this->node(node.children[0], setting);
    const Style style = smaller(setting.style);
    const bool isBelow = node.children[1] != none, isAbove = node.children[2] != none;
    const Box below = isBelow ? this->node(node.children[1], {style, true}) : Box();
    const Box above = isAbove ? this->node(node.children[2], {style, setting.cramped}) : Box();
    const Place place =
        scriptPlace(base, isAbove ? &above : nullptr, isBelow ? &below : nullptr, setting);
    const double after = length(HB_OT_MATH_CONSTANT_SPACE_AFTER_SCRIPT, setting);
    Box box = base;
    box.letter.reset();
    box.accentPlace.reset();
    box.italic = 0;
    if (isBelow) {
        const double x = base.width - base.italic + corner(base, below, false, -place.down);
        box.put(below, x, place.down);
        box.width = std::max(box.width, x + below.width + after);
        if (!isAbove) // the letter's lean is room for nothing
            box.width = x + below.width + after;
    }
    if (isAbove) {
        const double x = base.width + corner(base, above, true, place.up);
        box.put(above, x, -place.up);
        box.width = std::max(box.width, x + above.width + after);
    }
    return box;
}

Box Typesetter::limits(const Node& node, Setting setting) {
    const Box base = this->node(node.children[0], setting);
    const Style style = smaller(setting.style);
    const bool isBelow = node.children[1] != none, isAbove = node.children[2] != none;
    const Box below = isBelow ? this->node(node.children[1], {style, true}) : Box();
    const Box above = isAbove ? this->node(node.children[2], {style, setting.cramped}) : Box();
    const double lean = base.letter ? 0 : base.italic / 2;
    const double middle =
        std::max({base.width / 2, above.width / 2 - lean, below.width / 2 + lean});
    Box box;
    box.put(base, middle - base.width / 2, 0);
    box.width = 2 * middle;
    box.glyphs.reserve(box.glyphs.size() + above.glyphs.size() + below.glyphs.size());
    const double size = sizeOf(setting);
    const auto atLeast = [&](Constant constant, double least) {
        return std::max(length(constant, setting), least * size);
    };
    if (isAbove) {
        const double rise = atLeast(HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN, leastRise);
        const double gap = atLeast(HB_OT_MATH_CONSTANT_UPPER_LIMIT_GAP_MIN, leastGapAbove);
        const double up = base.ascent + std::max(rise, gap + above.descent);
        box.put(above, middle + lean - above.width / 2, -up);
    }
    if (isBelow) {
        const double drop = atLeast(HB_OT_MATH_CONSTANT_LOWER_LIMIT_BASELINE_DROP_MIN, leastDrop);
        const double gap = atLeast(HB_OT_MATH_CONSTANT_LOWER_LIMIT_GAP_MIN, leastGapBelow);
        const double down = base.descent + std::max(drop, gap + below.ascent);
        box.put(below, middle - lean - below.width / 2, down);
    }
    return box;
}

} // namespace formulas
