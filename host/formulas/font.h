// An OpenType font for mathematics: its glyphs and its MATH table. Lengths are in em, heights above
// the base line. Several threads may share one.
#pragma once

#include <QPainterPath>
#include <QString>
#include <hb-ot.h>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace formulas {

using GlyphId = std::uint32_t;

struct GlyphSize {
    double width = 0, ascent = 0, descent = 0; // of its ink but for the width
    double italic = 0;                         // what leans over its width
};

// A delimiter, a root or an accent of some length: one glyph, or pieces that overlap.
struct Grown {
    struct Piece {
        GlyphId glyph = 0;
        double from = 0; // from the bottom, or from the left
    };
    std::vector<Piece> pieces;
    double length = 0;
};

class Font {
public:
    // Null: there is no such file, or it is no font for mathematics.
    [[nodiscard]] static std::shared_ptr<const Font> load(const QString& file);
    // The first that is installed of those the program knows; null, when none is.
    [[nodiscard]] static const std::shared_ptr<const Font>& standard();
    // For the user who has none: what is missing, and which package has it.
    [[nodiscard]] static QString missing();

    [[nodiscard]] double constant(hb_ot_math_constant_t constant) const;
    [[nodiscard]] double percent(hb_ot_math_constant_t constant) const; // 1 is 100 %

    // `scriptLevel` 1 or 2: in a script, or in a script's script.
    [[nodiscard]] std::optional<GlyphId> glyph(char32_t code, int scriptLevel = 0) const;
    [[nodiscard]] std::optional<GlyphId> dotless(char32_t code) const; // of i and j
    // The glyphs of a text and their advances.
    [[nodiscard]] std::vector<std::pair<GlyphId, double>> shaped(const std::string& text) const;
    [[nodiscard]] GlyphSize size(GlyphId glyph) const;
    [[nodiscard]] double accentPlace(GlyphId glyph) const; // from its left
    [[nodiscard]] double kern(GlyphId glyph, hb_ot_math_kern_t corner, double height) const;
    // At least that long where the font can; else as long as it can.
    [[nodiscard]] Grown grown(GlyphId glyph, bool vertical, double atLeast) const;
    // The longest that is not longer, but the glyph itself at least.
    [[nodiscard]] GlyphId widest(GlyphId glyph, double atMost) const;
    [[nodiscard]] QPainterPath outline(GlyphId glyph) const; // y goes down, of one em

private:
    struct Free {
        void operator()(hb_font_t* font) const { hb_font_destroy(font); }
    };
    explicit Font(hb_font_t* font);
    [[nodiscard]] GlyphId withFeature(char32_t code, hb_tag_t feature, std::uint32_t value) const;
    [[nodiscard]] Grown assembled(GlyphId glyph, bool vertical, double atLeast) const;

    std::unique_ptr<hb_font_t, Free> font_;
    mutable std::mutex drawing_; // of outlines: those that were asked for
    mutable std::unordered_map<GlyphId, QPainterPath> outlines_;
    double em_ = 1000;
};

} // namespace formulas
