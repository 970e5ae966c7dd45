// Geometry against the numbers of the font's MATH table.
#include "formulas/paint.h"

#include <QImage>
#include <QPainter>
#include <cmath>
#include <gtest/gtest.h>

namespace formulas {
namespace {

constexpr double size = 200; // twips: letters of 10 pt
constexpr double near = 1e-6;

const Font& font() { return *Font::standard(); }
double constant(hb_ot_math_constant_t which) { return font().constant(which) * size; }
double axis() { return constant(HB_OT_MATH_CONSTANT_AXIS_HEIGHT); }

Set set(std::string_view source, Style style = Style::display) {
    const Formula formula = read(source);
    EXPECT_TRUE(formula.faults.empty()) << source << ": " << formula.faults[0].message;
    return typeset(formula, style, size, font());
}
Box box(std::string_view source, Style style = Style::display) {
    Set made = set(source, style);
    return made.pieces.front().box;
}
GlyphId glyph(char32_t code) { return font().glyph(code).value_or(0); }
const PlacedGlyph& find(const Box& in, GlyphId wanted) {
    for (const PlacedGlyph& placed : in.glyphs)
        if (placed.glyph == wanted)
            return placed;
    ADD_FAILURE() << "the glyph is not there";
    static const PlacedGlyph nothing;
    return nothing;
}

class Typesetting : public testing::Test {
protected:
    void SetUp() override { ASSERT_NE(Font::standard(), nullptr) << Font::missing().toStdString(); }
};

TEST_F(Typesetting, AFileThatIsNoFontForMathematicsIsNone) {
    EXPECT_EQ(Font::load("/nowhere.otf"), nullptr);
    EXPECT_EQ(Font::load("/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"), nullptr);
    EXPECT_TRUE(Font::missing().contains("fonts-texgyre-math"));
}

TEST_F(Typesetting, EmptyPartsHaveAFrameWhileOneWrites) {
    const Formula formula = read(R"(\frac{}{b})");
    const Box plain = typeset(formula, Style::display, size, font()).pieces.front().box;
    const Box framed =
        typeset(formula, Style::display, size, font(), Empty::framed).pieces.front().box;
    EXPECT_TRUE(plain.waiting.empty());
    ASSERT_EQ(framed.waiting.size(), 1U);
    EXPECT_EQ(framed.waiting[0].place, 6U);
    EXPECT_LT(framed.waiting[0].frame.bottom(), -axis()); // over the line
    EXPECT_GT(framed.waiting[0].frame.width(), 0.3 * size);
    EXPECT_GT(framed.ascent, plain.ascent);
}

TEST_F(Typesetting, LettersAreItalicAndAsWideAsTheFontSays) {
    const Box x = box("x");
    const GlyphSize own = font().size(glyph(0x1D465));
    ASSERT_EQ(x.glyphs.size(), 1U);
    EXPECT_EQ(x.glyphs[0].glyph, glyph(0x1D465));
    EXPECT_NEAR(x.width, (own.width + own.italic) * size, near);
    EXPECT_NEAR(x.ascent, own.ascent * size, near);
    EXPECT_EQ(box(R"(\mathrm{x})").glyphs[0].glyph, glyph('x'));
    EXPECT_EQ(box(R"(\mathbf{x})").glyphs[0].glyph, glyph(0x1D431));
    EXPECT_EQ(box(R"(\mathbb{R})").glyphs[0].glyph, glyph(0x211D));
}

TEST_F(Typesetting, SpacesAreThoseOfAtoms) {
    const double one = box("1").width, plus = box("+").width, equals = box("=").width;
    EXPECT_NEAR(box("1+1").width, 2 * one + plus + 2 * 4.0 / 18 * size, near);
    EXPECT_NEAR(box("1=1").width, 2 * one + equals + 2 * 5.0 / 18 * size, near);
    EXPECT_NEAR(box("+1").width, plus + one, near); // a sign, no operator
    EXPECT_NEAR(box("1=+1").width, 2 * one + plus + equals + 2 * 5.0 / 18 * size, near);
    EXPECT_NEAR(box(R"(1\,1\quad 1)").width, 3 * one + (3.0 / 18 + 1) * size, near);
    // None in a script.
    EXPECT_NEAR(box("{}^{1+1}").width, box(R"({}^{1\mathord{+}1})").width, near);
    EXPECT_GT(box("1+1").width, box(R"(1\mathord{+}1)").width + 1);
}

TEST_F(Typesetting, AFractionStandsOnTheAxis) {
    const Box half = box(R"(\frac{1}{22})");
    const double thickness = constant(HB_OT_MATH_CONSTANT_FRACTION_RULE_THICKNESS);
    ASSERT_EQ(half.rules.size(), 1U);
    const QRectF line = half.rules[0];
    EXPECT_NEAR(line.center().y(), -axis(), near);
    EXPECT_NEAR(line.height(), thickness, near);
    EXPECT_NEAR(line.width(), box("22").width, near);
    EXPECT_NEAR(half.width, line.width() + 2 * 0.12 * size, near);
    const PlacedGlyph& one = find(half, glyph('1'));
    EXPECT_NEAR(one.x + box("1").width / 2, line.center().x(), near); // centred
    EXPECT_NEAR(-one.y, constant(HB_OT_MATH_CONSTANT_FRACTION_NUMERATOR_DISPLAY_STYLE_SHIFT_UP),
                near);
    EXPECT_NEAR(find(half, glyph('2')).y,
                constant(HB_OT_MATH_CONSTANT_FRACTION_DENOMINATOR_DISPLAY_STYLE_SHIFT_DOWN), near);
    EXPECT_EQ(one.size, size);
    const double script = font().percent(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN);
    EXPECT_NEAR(box(R"(\frac{1}{22})", Style::text).glyphs[0].size, size * script, near);
    EXPECT_NEAR(box(R"(\dfrac{1}{22})", Style::text).width, half.width, near);
}

TEST_F(Typesetting, ScriptsAreShiftedAsTheFontSays) {
    const double up = constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP);
    const double cramped = constant(HB_OT_MATH_CONSTANT_SUPERSCRIPT_SHIFT_UP_CRAMPED);
    EXPECT_NEAR(-box("x^1").glyphs[1].y, up, near);
    EXPECT_NEAR(box("x_1").glyphs[1].y, constant(HB_OT_MATH_CONSTANT_SUBSCRIPT_SHIFT_DOWN), near);
    EXPECT_NEAR(-box(R"(\overline{x^1})").glyphs[1].y, cramped, near); // under a line
    // Both: at least the gap is between them.
    const Box both = box("x_1^1");
    ASSERT_EQ(both.glyphs.size(), 3U);
    const double script = font().percent(HB_OT_MATH_CONSTANT_SCRIPT_PERCENT_SCALE_DOWN);
    const Box one = box("1");
    const double bottom = -both.glyphs[2].y - one.descent * script;
    const double top = -both.glyphs[1].y + one.ascent * script;
    EXPECT_GE(bottom - top + 1e-3, constant(HB_OT_MATH_CONSTANT_SUB_SUPERSCRIPT_GAP_MIN));
    // The subscript of a letter that leans stands nearer than its superscript.
    const Box leaning = box("f_1^1");
    EXPECT_NEAR(leaning.glyphs[2].x - leaning.glyphs[1].x,
                font().size(glyph(0x1D453)).italic * size, near);
    EXPECT_EQ(box("x^1_1").width, both.width); // in any order
}

TEST_F(Typesetting, OperatorsOfADisplayAreLargerAndHaveLimits) {
    const Box sum = box(R"(\sum_1^1)"), inLine = box(R"(\sum_1^1)", Style::text);
    EXPECT_GT(box(R"(\sum)").ascent, box(R"(\sum)", Style::text).ascent * 1.2);
    const Box alone = box(R"(\sum)");
    EXPECT_NEAR((alone.ascent - alone.descent) / 2, axis(), near);
    EXPECT_NEAR(sum.glyphs[1].x, sum.glyphs[2].x, near); // above each other, in the middle
    EXPECT_NEAR(sum.width, alone.width, near);
    EXPECT_GT(inLine.glyphs[1].x, inLine.glyphs[0].x + box(R"(\sum)", Style::text).width - 1);
    const double least =
        std::max(constant(HB_OT_MATH_CONSTANT_UPPER_LIMIT_BASELINE_RISE_MIN), 0.2 * size);
    EXPECT_GE(-sum.glyphs[1].y - alone.ascent + near, least);
    // An integral's stand beside it, unless it is told otherwise.
    EXPECT_GT(box(R"(\int_1^1)").width, box(R"(\int)").width + 1);
    EXPECT_NEAR(box(R"(\int\limits_1^1)").width, box(R"(\int)").width, 1);
    EXPECT_GE(box(R"(\int)").ascent + box(R"(\int)").descent, 2 * size);
}

TEST_F(Typesetting, ARootCoversWhatIsInIt) {
    for (const char* inside : {"x", R"(\frac{1}{2})", R"(\frac{\frac{1}{2}}{\frac{1}{2}})",
                               R"(\begin{matrix}1\cr 2\cr 3\cr 4\cr 5\cr 6\end{matrix})"}) {
        const Box part = box(inside);
        const Box root = box(std::string(R"(\sqrt{)") + inside + "}");
        const QRectF line = root.rules[0];
        const double gap = constant(HB_OT_MATH_CONSTANT_RADICAL_DISPLAY_STYLE_VERTICAL_GAP);
        EXPECT_GE(-line.bottom() - part.ascent + near, gap) << inside;
        EXPECT_NEAR(line.right(), root.width, near) << inside;
        EXPECT_GE(root.descent + near, part.descent) << inside;
    }
    EXPECT_GT(box(R"(\sqrt[10]{x})").width, box(R"(\sqrt{x})").width);
}

TEST_F(Typesetting, DelimitersAreAsHighAsWhatIsBetweenThem) {
    for (int rows = 1; rows <= 20; ++rows) {
        std::string matrix = R"(\begin{matrix})";
        for (int i = 0; i < rows; ++i)
            matrix += R"(1\\)";
        matrix += R"(\end{matrix})";
        const Box part = box(matrix);
        const Box fence = box(R"(\left()" + matrix + R"(\right))");
        const double far = std::max(part.ascent - axis(), part.descent + axis());
        EXPECT_GE(fence.ascent - axis() + 0.5, far * 0.901) << rows;
        EXPECT_NEAR(fence.ascent - axis(), fence.descent + axis(), 0.5) << rows;
        EXPECT_LE(fence.ascent - axis(), far * 1.35 + 0.35 * size) << rows;
    }
    EXPECT_LT(box(R"(\bigl()").ascent, box(R"(\Bigl()").ascent);
    EXPECT_LT(box(R"(\Bigl()").ascent, box(R"(\biggl()").ascent);
    EXPECT_GE(box(R"(\bigl()").ascent + box(R"(\bigl()").descent, 1.2 * size - near);
}

TEST_F(Typesetting, PiecesThatAreJoinedHaveNoGap) {
    const Grown grown = font().grown(glyph('('), true, 9);
    ASSERT_GT(grown.pieces.size(), 3U);
    EXPECT_GE(grown.length, 9 - near);
    for (std::size_t i = 1; i < grown.pieces.size(); ++i) {
        const GlyphSize below = font().size(grown.pieces[i - 1].glyph);
        const double end = grown.pieces[i - 1].from + below.ascent + below.descent;
        EXPECT_LE(grown.pieces[i].from, end + near);
    }
}

TEST_F(Typesetting, AnAccentStandsOverTheMiddleItIsMeantFor) {
    const Box hat = box(R"(\hat{x})");
    const GlyphId letter = glyph(0x1D465), sign = glyph(0x302);
    EXPECT_NEAR(find(hat, sign).x + font().accentPlace(sign) * size,
                font().accentPlace(letter) * size, near);
    EXPECT_NEAR(hat.width, box("x").width, near);
    EXPECT_EQ(find(hat, sign).y, 0); // a low letter: where the font drew it
    EXPECT_LT(find(box(R"(\hat{X})"), sign).y, 0);
    EXPECT_NE(box(R"(\hat{\imath})").glyphs[0].glyph, box("i").glyphs[0].glyph);
    EXPECT_NE(box(R"(\hat{i})").glyphs[0].glyph, box("i").glyphs[0].glyph); // its dot is away
}

TEST_F(Typesetting, ColumnsStandInLine) {
    const Box lines = box(R"(\begin{aligned} 1 &= 22 \\ 111 &= 2 \end{aligned})");
    std::vector<double> signs;
    for (const PlacedGlyph& placed : lines.glyphs)
        if (placed.glyph == glyph('='))
            signs.push_back(placed.x);
    ASSERT_EQ(signs.size(), 2U);
    EXPECT_NEAR(signs[0], signs[1], near);
    EXPECT_NEAR(signs[0], box("111").width + 5.0 / 18 * size, near);
    EXPECT_NEAR((lines.ascent - lines.descent) / 2, axis(), near);
    const Box matrix = box(R"(\begin{matrix} 1 & 22 \\ 111 & 2 \end{matrix})");
    EXPECT_NEAR(matrix.glyphs[0].x, box("111").width / 2 - box("1").width / 2, near);
    EXPECT_NEAR(matrix.width, box("111").width + box("22").width + size, near);
}

TEST_F(Typesetting, ALineMayEndBehindRelationsAndOperators) {
    const Set line = set("a+b=c", Style::text);
    ASSERT_EQ(line.pieces.size(), 3U);
    EXPECT_NEAR(line.pieces[0].space, 4.0 / 18 * size, near);
    EXPECT_NEAR(line.pieces[1].space, 5.0 / 18 * size, near);
    EXPECT_NEAR(line.width, set("a+b=c").width, near);
    EXPECT_EQ(set("a+b=c").pieces.size(), 1U); // a display stays whole
    const Set one = whole(line);
    ASSERT_EQ(one.pieces.size(), 1U);
    EXPECT_NEAR(one.pieces[0].box.width, line.width, near);
    EXPECT_EQ(one.pieces[0].box.glyphs.size(), 5U);
    EXPECT_EQ(set("{a+b=c}", Style::text).pieces.size(), 1U);
    EXPECT_EQ(set("(-a)", Style::text).pieces.size(), 1U);
}

TEST_F(Typesetting, WhatIsWrongHasAColourOfItsOwn) {
    const Set broken = typeset(read(R"(x+\nosuchthing)"), Style::display, size, font());
    const auto& glyphs = broken.pieces[0].box.glyphs;
    ASSERT_GT(glyphs.size(), 2U);
    EXPECT_FALSE(glyphs.front().faulty);
    EXPECT_TRUE(glyphs.back().faulty);
    const auto painted = [&](QRgb color) {
        QImage image(400, 60, QImage::Format_RGB32);
        image.fill(Qt::white);
        QPainter painter(&image);
        painter.scale(0.1, 0.1);
        paint(painter, broken.pieces[0].box, {100, 400}, font(), Qt::black, Qt::red);
        painter.end();
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                if (image.pixel(x, y) == color)
                    return true;
        return false;
    };
    EXPECT_TRUE(painted(qRgb(255, 0, 0)));
    EXPECT_TRUE(painted(qRgb(0, 0, 0)));
    EXPECT_FALSE(painted(qRgb(0, 0, 255)));
    const Set strange = typeset(read("x 中"), Style::display, size, font());
    ASSERT_EQ(strange.faults.size(), 1U);
    EXPECT_EQ(strange.faults[0].offset, 2U);
}

TEST_F(Typesetting, WorkGrowsWithTheSource) {
    std::string sum = "1";
    for (int i = 0; i < 1000; ++i)
        sum += "+\\frac{1}{2}";
    const Formula formula = read(sum);
    EXPECT_LE(formula.nodes.size(), sum.size());
    EXPECT_EQ(typeset(formula, Style::display, size, font()).pieces[0].box.glyphs.size(), 3001U);
}

} // namespace
} // namespace formulas
