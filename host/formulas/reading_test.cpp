// The meaning of a source: as plain text, as words, and which faults it has where.
#include "formulas/empty_parts.h"
#include "formulas/plain_words.h"
#include "formulas/typeset.h"

#include <gtest/gtest.h>
#include <random>

namespace formulas {
namespace {

struct Said {
    const char* source;
    const char* plain;
    const char* spoken;
};

TEST(Reading, PlainTextAndWords) {
    const Said table[] = {
        {"E = mc^2", "E = mc²", "E equals m c squared"},
        {R"(\frac{-b \pm \sqrt{b^2-4ac}}{2a})", "(−b ± √(b² − 4ac))/(2a)",
         "the fraction minus b plus or minus the square root of b squared minus 4 a c end root "
         "over 2 a end fraction"},
        {R"(\sum_{i=1}^{n} i)", "∑_(i=1)ⁿ i", "sum from i equals 1 to n of i"},
        {R"(\int_0^\infty e^{-x}\,dx)", "∫₀^∞ e^(−x) dx",
         "integral from 0 to infinity of e to the power minus x end power d x"},
        {R"(\lim_{x\to 0} \frac{\sin x}{x})", "lim_(x→0) (sin x)/x",
         "limit as x to 0 of the fraction sine x over x end fraction"},
        {R"(\begin{pmatrix} a & b \\ c & d \end{pmatrix})", "(a, b; c, d)",
         "the 2 by 2 matrix: row 1: a, b; row 2: c, d; end matrix"},
        {R"(\begin{cases} x & x \ge 0 \cr -x & \text{otherwise} \end{cases})",
         "{x, x ≥ 0; −x, otherwise}", "cases: x, x is at least 0; minus x, otherwise; end cases"},
        {R"(\ddot\theta + \omega_0^2\theta = 0)", "θ̈ + ω₀²θ = 0",
         "theta double dot plus omega sub 0 squared theta equals 0"},
        {R"(\vec F = m\vec a)", "F⃗ = ma⃗", "vector F equals m vector a"},
        {R"(\sqrt[3]{x+1})", "³√(x + 1)", "the cube root of x plus 1 end root"},
        {R"(f'(x) + f'')", "f′(x) + f′′",
         "f prime open parenthesis x close parenthesis plus f double prime"},
        {R"(\binom{n}{k})", "(n choose k)", "n choose k"},
        {R"(\left|\frac{a}{b}\right|)", "|a/b|",
         "the absolute value of a over b end absolute value"},
        {R"(\mathbb{R}^n \to \mathbb{C})", "ℝⁿ → ℂ", "R to the power n to C"},
        {R"(v = 3.25\,\mathrm{m\,s^{-2}})", "v = 3.25 m s⁻²",
         "v equals 3.25 m s to the power minus 2 end power"},
        {R"(a \not= b)", "a ≠ b", "a is not equal to b"},
        {R"(\underbrace{a+b}_{2})", "(a + b)₂", "a plus b with, below, 2"},
        {R"(\frac{g}{l}x + \frac{1}{2})", "(g/l)x + 1/2", "g over l x plus 1 over 2"},
        {R"(-\sin\varphi)", "−sin φ", "minus sine phi"},
        {R"(\operatorname*{arg\,max}_x f)", "arg max_x f", "arg max as x of f"},
    };
    for (const Said& row : table) {
        const Formula formula = read(row.source);
        EXPECT_TRUE(formula.faults.empty()) << row.source << ": " << formula.faults[0].message;
        EXPECT_EQ(plain(formula), row.plain) << row.source;
        EXPECT_EQ(spoken(formula), row.spoken) << row.source;
    }
}

// | stands where Tab leads to, one after the other, from the start of the source on.
TEST(Reading, OneGoesOnInTheEmptyPartsAndBehindThem) {
    const std::pair<const char*, std::vector<std::size_t>> table[] = {
        {"\\frac{}{}", {6, 8, 9}},
        {"\\frac{a}{ }", {9, 11}},
        {"2\\sqrt{}+1", {7, 8}},
        {"x^{}_{}", {3, 6, 7}},
        {"\\sum_{}^{}", {6, 9, 10}},
        {"\\left(\\right)", {6, 13}},
        {"\\begin{pmatrix}&a\\end{pmatrix}", {15, 30}},
        {"\\begin{aligned}&=a\\end{aligned}", {}},
        {"{}^{14}C", {}},
        {"\\vec{}\\frac{\\sqrt{}}{}", {5, 18, 21, 22}},
        {"\\frac{", {6}},
    };
    for (const auto& [source, places] : table) {
        const Formula formula = read(source);
        std::vector<std::size_t> way;
        for (auto at = nextPlace(formula, 0); at; at = nextPlace(formula, *at))
            way.push_back(*at);
        EXPECT_EQ(way, places) << source;
    }
    EXPECT_EQ(placeBefore(read("\\frac{}{}"), 8), 6U);
    EXPECT_EQ(placeBefore(read("\\frac{}{}"), 6), std::nullopt);
}

TEST(Reading, PlainWordsAreProposedAsTexWritesThem) {
    const std::pair<const char*, const char*> table[] = {
        {"2 pi sqrt(L/g", "2 \\pi \\sqrt{L/g}"},
        {"T = 2pi sqrt((L+pi)/g) + 1", "T = 2\\pi \\sqrt{(L+\\pi)/g} + 1"},
        {"sin(alpha) <= 1", "\\sin(\\alpha) \\le  1"},
        {"e^(-x) + x^10 + x^-1 + v_max + v_end + x^* + a_ij + x_pi",
         "e^{-x} + x^{10} + x^{-1} + v_\\max + v_{\\mathrm{end}} + x^* + a_{ij} + x_\\pi"},
        {"a*b ... infinity", "a\\cdot b \\dots  \\infty"},
        // Text that is TeX's already is left as it is.
        {R"(\frac{1}{2} m v^2 \sin\alpha \text{for pi} \mathrm{sin} x^{10} ab x_i2 \begin{cases} 1 \end{cases})",
         nullptr},
        {R"(\value[2 decimals]{pi}{sin} \left( x \right) n! = 1)", nullptr},
    };
    for (const auto& [source, tex] : table)
        EXPECT_EQ(withTex(source, plainWords(source)), tex ? tex : source);
    const std::vector<PlainWord> found = plainWords("2 pi sqrt(L/g");
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].message, "TeX writes \\pi for pi.");
    EXPECT_EQ(found[1].message, "TeX writes \\sqrt{L/g} for sqrt(L/g.");
    EXPECT_EQ(found[1].range.from, 5u);
}

TEST(Reading, ValuesAreSuppliedAsPartsOfTheFormula) {
    const auto supply = [](const ValueCall& call) -> SuppliedValue {
        if (call.of != "ball")
            return {"", true};
        return {call.options == "2 decimals" ? "-4.20" : "1.5\\times 10^{-7}"};
    };
    const Formula fall = read(R"(v = \value[2 decimals]{ball}{ball.dy} \,\mathrm{m/s})", supply);
    EXPECT_TRUE(fall.faults.empty());
    EXPECT_EQ(plain(fall), "v = −4.20 m/s");
    EXPECT_EQ(spoken(fall), "v equals minus 4.20 m over s");
    ASSERT_EQ(fall.values.size(), 1u);
    EXPECT_EQ(fall.values[0].expression, "ball.dy");
    EXPECT_EQ(fall.values[0].offset, 4u);
    EXPECT_EQ(fall.values[0].end, 37u);
    EXPECT_EQ(plain(read(R"(\frac{\value{ball}{E}}{2})", supply)), "(1.5 × 10⁻⁷)/2");
    EXPECT_EQ(plain(read(R"(\value{ball}{E}^2)")), "[E]²"); // nobody supplies it
    const Formula other = read(R"(\value{bell}{x})", supply);
    EXPECT_TRUE(other.alone(other.root).faulty);
}

TEST(Reading, AValueWithoutItsPartsIsAFault) {
    const auto faultOf = [](const char* source) {
        std::string all;
        for (const Fault& fault : read(source).faults)
            all += fault.message;
        return all;
    };
    EXPECT_NE(faultOf(R"(\value{ball})").find("each in braces"), std::string::npos);
    EXPECT_NE(faultOf(R"(\value[2 decimals{ball}{x})").find("no ]"), std::string::npos);
    EXPECT_TRUE(read(R"(\value{ball})").values.empty());
    EXPECT_EQ(faultOf(R"(\value{a}{x[0] + \{2\} $})"), "");
}

TEST(Reading, SignsOfUnicodeAreThemselves) {
    EXPECT_EQ(plain(read("α ≤ β² − γ₁₂")), plain(read(R"(\alpha \le \beta^2 - \gamma_{12})")));
    EXPECT_EQ(plain(read("α ≤ β² − γ₁₂")), "α ≤ β² − γ₁₂");
    EXPECT_EQ(spoken(read("a·b ⇒ ∇f′")), spoken(read(R"(a\centerdot b \Rightarrow \nabla f')")));
}

struct Faulty {
    const char* source;
    std::size_t offset, end;
    const char* message;
};

TEST(Reading, FaultsHaveAPlaceAndASentence) {
    const Faulty table[] = {
        {R"(\frac{1})", 0, 5, R"(\frac needs two parts; the second is missing.)"},
        {R"(a + \frac)", 4, 9, R"(\frac needs two parts; the first is missing.)"},
        {R"(\sqrt)", 0, 5, R"(\sqrt needs a part in braces; it is missing.)"},
        {R"(x \alhpa)", 2, 8, R"(There is no command \alhpa. Is \alpha meant?)"},
        {R"(a \over b)", 2, 7, R"(Instead of \over write \frac{above}{below}.)"},
        {"{a", 0, 1, "This { has no } that ends it."},
        {"a}b", 1, 2, "This } ends nothing."},
        {"x^", 1, 2, "^ has nothing behind it."},
        {"x^2^3", 3, 4, "A base has one superscript: write {x^a}^b or x^{ab}."},
        {R"(\left( a)", 0, 5, R"(\left has no \right; \right. ends it without a sign.)"},
        {R"(a \right))", 2, 8, R"(\right has no \left before it.)"},
        {R"(\left a \right))", 0, 5,
         R"(\left needs a delimiter behind it: ( ) [ ] \{ \} | or . for none.)"},
        {R"(a & b)", 2, 3, R"(& stands only between \begin and \end, as in a matrix.)"},
        {R"(\begin{pmatrix} a)", 0, 6, R"(\begin{pmatrix} has no \end{pmatrix}.)"},
        {R"(\begin{matrix} a \end{pmatrix})", 17, 21,
         R"(\end{pmatrix} stands where \end{matrix} is awaited.)"},
        {"$x$", 0, 1, R"(A formula needs no $ around it; the sign itself is \$.)"},
        {"5%", 1, 2, R"(For the sign write \%.)"},
        {"a\xFF", 1, 2, "These bytes are no UTF-8."},
    };
    for (const Faulty& row : table) {
        const Formula formula = read(row.source);
        ASSERT_FALSE(formula.faults.empty()) << row.source;
        const Fault& fault = formula.faults.front();
        EXPECT_EQ(fault.message, row.message) << row.source;
        EXPECT_EQ(fault.offset, row.offset) << row.source;
        EXPECT_EQ(fault.end, row.end) << row.source;
    }
}

TEST(Reading, WhatCouldNotBeReadIsShown) {
    EXPECT_EQ(plain(read(R"(x + \nosuchthing)")), R"(x + \nosuchthing)");
    EXPECT_EQ(plain(read(R"(\frac{a})")), "a/□");
}

TEST(Reading, NestingAndLengthAreBounded) {
    const std::string deep(10000, '{');
    const Formula nested = read(deep);
    ASSERT_EQ(nested.faults.size(), 1U);
    EXPECT_EQ(nested.faults[0].message,
              "The formula nests more than 60 parts in each other; the rest is left out.");
    EXPECT_EQ(nested.faults[0].offset, 60U);
    std::string roots;
    for (int i = 0; i < 3000; ++i)
        roots += "\\sqrt";
    EXPECT_EQ(read(roots).faults.size(), 1U);
    const Formula longer = read(std::string(longestSource + 1, 'x'));
    ASSERT_EQ(longer.faults.size(), 1U);
    EXPECT_EQ(longer.node(longer.root).children.size(), longestSource);
    std::string wide = "\\begin{matrix}" + std::string(5000, '&');
    for (int i = 0; i < 3000; ++i)
        wide += "\\cr ";
    EXPECT_LE(read(wide).nodes.size(), longestSource);
}

// Sources made of the pieces of formulas, in any order.
std::string broken(std::mt19937& random) {
    static const char* const pieces[] = {
        "{",
        "}",
        "\\frac",
        "^",
        "_",
        "\\sqrt",
        "[",
        "]",
        "\\left",
        "\\right",
        "\\middle",
        "(",
        ")",
        ".",
        "&",
        "\\\\",
        "\\cr",
        "\\begin",
        "\\end",
        "{matrix}",
        "{cases}",
        "{array}",
        "x",
        "1",
        "+",
        "=",
        "\\sum",
        "\\lim",
        "\\text",
        "'",
        "\\hat",
        "\\overbrace",
        "²",
        "₀",
        "α",
        "\\",
        "\xE2",
        "\\limits",
        "\\substack",
        "\\not",
        "\\Bigl",
        "\\over",
        "\\mathbf",
        " ",
        "\\binom",
        "\\overset",
        "\\displaystyle",
        "\\operatorname",
        "\\xrightarrow",
        "\\phantom",
        "\\pmod",
        "\\rm",
        "$",
        "%",
    };
    std::string source;
    const unsigned length = random() % 40;
    for (unsigned i = 0; i < length; ++i)
        source += pieces[random() % std::size(pieces)];
    return source;
}

TEST(Reading, BrokenSourcesHaveFaultsAndAResult) {
    const auto font = Font::standard();
    ASSERT_NE(font, nullptr) << Font::missing().toStdString();
    std::mt19937 random(17);
    std::size_t faults = 0;
    for (int i = 0; i < 4000; ++i) {
        const std::string source = broken(random);
        const Formula formula = read(source);
        ASSERT_NE(formula.root, none);
        for (const Node& node : formula.nodes) {
            ASSERT_LE(node.offset, source.size()) << source;
            ASSERT_LE(node.end, source.size()) << source;
        }
        for (const Fault& fault : formula.faults) {
            ASSERT_LE(fault.offset, fault.end) << source;
            ASSERT_LE(fault.end, source.size()) << source;
            ASSERT_FALSE(fault.message.empty());
        }
        faults += formula.faults.size();
        (void)plain(formula);
        (void)spoken(formula);
        const Set set = typeset(formula, i % 2 == 0 ? Style::display : Style::text, 200, *font);
        ASSERT_TRUE(std::isfinite(set.width) && std::isfinite(set.ascent + set.descent)) << source;
        ASSERT_LT(std::abs(set.width) + set.ascent + set.descent, 1e6) << source;
    }
    EXPECT_GT(faults, 4000U);
}

} // namespace
} // namespace formulas
