// The meaning of each property of a presentation (docs/schemas.md lists them).
#include "schemas/presentation.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

namespace schemas {

namespace {

using Words = std::vector<Property::Word>;

// --- values ---------------------------------------------------------------------------------

std::optional<double> number(std::string_view text, std::string_view& unit) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value))
        return std::nullopt;
    unit = std::string_view(end, static_cast<std::size_t>(text.data() + text.size() - end));
    return value;
}

// Points. LIMIT: lengths up to 10,000 pt, what no paper reaches.
std::optional<double> length(const Property::Word& word) {
    constexpr std::pair<std::string_view, double> units[] = {
        {"pt", 1}, {"mm", 72 / 25.4}, {"cm", 72 / 2.54}, {"in", 72}, {"px", 0.75}};
    std::string_view unit;
    const auto value = word.quoted ? std::nullopt : number(word.text, unit);
    if (!value || std::abs(*value) > 10'000)
        return std::nullopt;
    for (const auto& [name, points] : units)
        if (unit == name)
            return *value * points;
    return *value == 0 && unit.empty() ? value : std::nullopt;
}

std::optional<bool> yesNo(const Words& words) {
    if (words.size() != 1 || (words[0].text != "yes" && words[0].text != "no"))
        return std::nullopt;
    return words[0].text == "yes";
}

int hexDigit(char c) {
    if (c >= '0' && c <= '9')
        return c - '0';
    if (c >= 'a' && c <= 'f')
        return c - 'a' + 10;
    return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
}

std::optional<Color> color(std::string_view text) {
    constexpr std::pair<std::string_view, Color> names[] = {
        {"black", {0, 0, 0}}, {"white", {255, 255, 255}}, {"grey", {128, 128, 128}},
        {"red", {192, 0, 0}}, {"green", {0, 128, 0}},     {"blue", {0, 0, 160}}};
    for (const auto& [name, value] : names)
        if (text == name)
            return value;
    if ((text.size() != 7 && text.size() != 4) || text[0] != '#' ||
        !std::all_of(text.begin() + 1, text.end(), [](char c) { return hexDigit(c) >= 0; }))
        return std::nullopt;
    const auto channel = [&](std::size_t i) {
        const int high = hexDigit(text.size() == 4 ? text[1 + i] : text[1 + 2 * i]);
        const int low = hexDigit(text.size() == 4 ? text[1 + i] : text[2 + 2 * i]);
        return static_cast<std::uint8_t>(16 * high + low);
    };
    return Color{channel(0), channel(1), channel(2)};
}

// Generic names and quoted ones.
bool isFamily(const Property::Word& word) {
    return word.quoted || word.text == "serif" || word.text == "sans" || word.text == "mono";
}

std::optional<double> fontSize(const Property::Word& word, double outer) {
    std::string_view unit;
    const auto value = word.quoted ? std::nullopt : number(word.text, unit);
    const auto size = value && unit == "%" ? std::optional(outer * *value / 100) : length(word);
    return size && *size >= 1 && *size <= 500 ? size : std::nullopt;
}

std::string setFont(TextStyle& text, const Words& words, double outer) {
    for (const Property::Word& word : words) {
        if (isFamily(word))
            text.family = word.text;
        else if (const auto size = fontSize(word, outer))
            text.size = *size;
        else if (word.text == "bold" || word.text == "regular")
            text.bold = word.text == "bold";
        else if (word.text == "italic" || word.text == "upright")
            text.italic = word.text == "italic";
        else if (word.text == "underline")
            text.underline = true;
        else
            return "\"" + word.text +
                   "\" is no size (1pt to 500pt, or %), family, bold, regular, italic, upright or "
                   "underline";
    }
    return words.empty() ? "a value is missing" : "";
}

std::string setBorder(Border& border, const Words& words) {
    constexpr std::string_view sides[] = {"top", "right", "bottom", "left"};
    bool* const ofBorder[] = {&border.top, &border.right, &border.bottom, &border.left};
    border = {};
    if (words.size() == 1 && words[0].text == "none")
        return "";
    bool someSides = false;
    for (const Property::Word& word : words) {
        const auto side = std::find(std::begin(sides), std::end(sides), word.text);
        if (side != std::end(sides)) {
            if (!someSides)
                border.top = border.right = border.bottom = border.left = false;
            someSides = true;
            *ofBorder[side - std::begin(sides)] = true;
        } else if (const auto width = length(word); width && *width >= 0) {
            border.width = *width;
        } else if (const auto value = color(word.text)) {
            border.color = *value;
        } else {
            return "\"" + word.text + "\" is no width, colour or side (top, right, bottom, left)";
        }
    }
    return border.width > 0 ? "" : "a width is missing";
}

std::optional<Align> align(std::string_view text) {
    constexpr std::pair<std::string_view, Align> names[] = {{"left", Align::left},
                                                            {"center", Align::center},
                                                            {"right", Align::right},
                                                            {"justify", Align::justify}};
    for (const auto& [name, value] : names)
        if (text == name)
            return value;
    return std::nullopt;
}

std::optional<Display> display(std::string_view text) {
    constexpr std::pair<std::string_view, Display> names[] = {
        {"block", Display::block},       {"inline", Display::inlined},
        {"verbatim", Display::verbatim}, {"table", Display::table},
        {"row", Display::row},           {"cell", Display::cell},
        {"image", Display::image},       {"page-break", Display::pageBreak},
        {"rule", Display::rule},         {"footnote", Display::footnote},
        {"link", Display::link},         {"reference", Display::reference},
        {"slider", Display::slider},     {"value", Display::value},
        {"chart", Display::chart},       {"formula", Display::formula},
        {"equation", Display::equation}, {"contents", Display::contents}};
    for (const auto& [name, value] : names)
        if (text == name)
            return value;
    return std::nullopt;
}

// --- setters: each takes one kind of value ---------------------------------------------------

std::string setLength(double& target, const Words& words, double least = -10'000) {
    const auto value = words.size() == 1 ? length(words[0]) : std::nullopt;
    if (!value || *value < least)
        return least < 0 ? "wants a length (pt, mm, cm, in, px)"
                         : "wants a length of at least 0 (pt, mm, cm, in, px)";
    target = *value;
    return "";
}

std::string setFlag(bool& target, const Words& words) {
    const auto value = yesNo(words);
    target = value.value_or(target);
    return value ? "" : "wants yes or no";
}

std::string setText(std::string& target, const Words& words) {
    if (words.size() == 1 && words[0].text == "none" && !words[0].quoted) {
        target.clear();
        return "";
    }
    if (words.size() != 1 || !words[0].quoted)
        return "wants a string in quotes, or none";
    target = words[0].text;
    return "";
}

std::string setName(std::string& target, const Words& words) {
    if (words.size() != 1)
        return "wants one name, or none";
    target = words[0].text == "none" ? "" : words[0].text;
    return "";
}

std::string setColor(Color& target, const Words& words) {
    const auto value = words.size() == 1 ? color(words[0].text) : std::nullopt;
    target = value.value_or(target);
    return value ? "" : "wants a colour: #rrggbb, black, white, grey, red, green or blue";
}

std::string setMaybeColor(std::optional<Color>& target, const Words& words) {
    if (words.size() == 1 && words[0].text == "none") {
        target.reset();
        return "";
    }
    Color value;
    std::string problem = setColor(value, words);
    if (problem.empty())
        target = value;
    return problem;
}

std::string setAlign(Align& target, const Words& words) {
    const auto value = words.size() == 1 ? align(words[0].text) : std::nullopt;
    target = value.value_or(target);
    return value ? "" : "wants left, center, right or justify";
}

std::string setDisplay(Display& target, const Words& words) {
    const auto value = words.size() == 1 ? display(words[0].text) : std::nullopt;
    target = value.value_or(target);
    return value ? ""
                 : "wants block, inline, verbatim, table, row, cell, image, page-break, rule, "
                   "footnote, link, reference, slider, value, chart, formula, equation or contents";
}

std::string setRefersBy(ElementStyle& style, const Words& words) {
    const std::string said = words.size() == 1 ? words[0].text : std::string();
    if (said != "name" && said != "number")
        return "wants name or number";
    style.refersByNumber = said == "number";
    return "";
}

std::string setRole(ContainerRole& target, const Words& words) {
    constexpr std::pair<std::string_view, ContainerRole> names[] = {
        {"none", ContainerRole::none},
        {"section", ContainerRole::section},
        {"list", ContainerRole::list},
        {"item", ContainerRole::item},
        {"figure", ContainerRole::figure},
        {"table", ContainerRole::table},
        {"quote", ContainerRole::quote},
        {"caption", ContainerRole::caption},
        {"paragraph", ContainerRole::paragraph},
        {"heading", ContainerRole::heading},
        {"emphasis", ContainerRole::emphasis},
        {"strong", ContainerRole::strong},
        {"code", ContainerRole::code}};
    for (const auto& [name, value] : names)
        if (words.size() == 1 && words[0].text == name) {
            target = value;
            return "";
        }
    return "wants section, list, item, figure, table, caption, quote, paragraph, heading, "
           "emphasis, "
           "strong, code or none";
}

std::string setLists(ContainerRole& target, const Words& words) {
    const std::string_view word = words.size() == 1 ? words[0].text : std::string_view();
    if (word != "heading" && word != "figure" && word != "table")
        return "wants heading, figure or table";
    return setRole(target, words);
}

std::string setLineHeight(double& target, const Words& words) {
    std::string_view unit;
    const auto value = words.size() == 1 ? number(words[0].text, unit) : std::nullopt;
    if (!value || !unit.empty() || *value < 0.5 || *value > 5)
        return "wants a number from 0.5 to 5";
    target = *value;
    return "";
}

std::string setLevel(int& target, const Words& words) {
    if (words.size() != 1 || words[0].text.size() != 1 || words[0].text[0] < '0' ||
        words[0].text[0] > '9')
        return "wants a number from 0 to 9";
    target = words[0].text[0] - '0';
    return "";
}

std::string setRestart(std::vector<std::string>& target, const Words& words) {
    target.clear();
    for (const Property::Word& word : words)
        if (word.text != "none")
            target.push_back(word.text);
    return words.empty() ? "wants names of counters, or none" : "";
}

using StyleSetter = std::string (*)(ElementStyle&, const Words&, const ElementStyle&);

const std::map<std::string_view, StyleSetter>& styleSetters() {
    using E = ElementStyle;
    static const std::map<std::string_view, StyleSetter> setters = {
        {"font",
         [](E& e, const Words& w, const E& outer) { return setFont(e.text, w, outer.text.size); }},
        {"color", [](E& e, const Words& w, const E&) { return setColor(e.text.color, w); }},
        {"highlight",
         [](E& e, const Words& w, const E&) { return setMaybeColor(e.text.background, w); }},
        {"raised", [](E& e, const Words& w, const E&) { return setFlag(e.text.raised, w); }},
        {"hyphenate", [](E& e, const Words& w, const E&) { return setFlag(e.text.hyphenate, w); }},
        {"align-numbers",
         [](E& e, const Words& w, const E&) { return setFlag(e.block.alignNumbers, w); }},
        {"align", [](E& e, const Words& w, const E&) { return setAlign(e.block.align, w); }},
        {"line-height",
         [](E& e, const Words& w, const E&) { return setLineHeight(e.block.lineHeight, w); }},
        {"space-before",
         [](E& e, const Words& w, const E&) { return setLength(e.block.spaceBefore, w, 0); }},
        {"space-after",
         [](E& e, const Words& w, const E&) { return setLength(e.block.spaceAfter, w, 0); }},
        {"indent", [](E& e, const Words& w, const E&) { return setLength(e.block.indentLeft, w); }},
        {"indent-right",
         [](E& e, const Words& w, const E&) { return setLength(e.block.indentRight, w); }},
        {"first-line",
         [](E& e, const Words& w, const E&) { return setLength(e.block.firstLine, w); }},
        {"marker-width",
         [](E& e, const Words& w, const E&) { return setLength(e.block.markerWidth, w, 0); }},
        {"marker-align",
         [](E& e, const Words& w, const E&) { return setAlign(e.block.markerAlign, w); }},
        {"padding",
         [](E& e, const Words& w, const E&) { return setLength(e.block.padding, w, 0); }},
        {"background",
         [](E& e, const Words& w, const E&) { return setMaybeColor(e.block.background, w); }},
        {"border", [](E& e, const Words& w, const E&) { return setBorder(e.block.border, w); }},
        {"keep-with-next",
         [](E& e, const Words& w, const E&) { return setFlag(e.block.keepWithNext, w); }},
        {"keep-together",
         [](E& e, const Words& w, const E&) { return setFlag(e.block.keepTogether, w); }},
        {"page-break-before",
         [](E& e, const Words& w, const E&) { return setFlag(e.block.pageBreakBefore, w); }},
        {"display", [](E& e, const Words& w, const E&) { return setDisplay(e.display, w); }},
        {"show", [](E& e, const Words& w, const E&) { return setFlag(e.show, w); }},
        {"before", [](E& e, const Words& w, const E&) { return setText(e.before, w); }},
        {"after", [](E& e, const Words& w, const E&) { return setText(e.after, w); }},
        {"float", [](E& e, const Words& w, const E&) { return setFlag(e.block.mayFloat, w); }},
        {"hint", [](E& e, const Words& w, const E&) { return setText(e.block.hint, w); }},
        {"marker", [](E& e, const Words& w, const E&) { return setText(e.marker, w); }},
        {"number", [](E& e, const Words& w, const E&) { return setText(e.number, w); }},
        {"reference", [](E& e, const Words& w, const E&) { return setText(e.reference, w); }},
        {"reference-number",
         [](E& e, const Words& w, const E&) { return setText(e.referenceNumber, w); }},
        {"refers-by", [](E& e, const Words& w, const E&) { return setRefersBy(e, w); }},
        {"counter", [](E& e, const Words& w, const E&) { return setName(e.counter, w); }},
        {"restart", [](E& e, const Words& w, const E&) { return setRestart(e.restart, w); }},
        {"level", [](E& e, const Words& w, const E&) { return setLevel(e.headingLevel, w); }},
        {"role", [](E& e, const Words& w, const E&) { return setRole(e.role, w); }},
        {"lists", [](E& e, const Words& w, const E&) { return setLists(e.lists, w); }},
        {"title", [](E& e, const Words& w, const E&) { return setFlag(e.title, w); }},
        {"repeat", [](E& e, const Words& w, const E&) { return setFlag(e.repeat, w); }},
    };
    return setters;
}

// --- the page -------------------------------------------------------------------------------

std::string setPaper(PageStyle& page, const Words& words) {
    constexpr double mm = 72 / 25.4;
    struct Paper {
        std::string_view name;
        double width, height;
    };
    constexpr Paper papers[] = {{"A3", 297 * mm, 420 * mm}, {"A4", 210 * mm, 297 * mm},
                                {"A5", 148 * mm, 210 * mm}, {"letter", 612, 792},
                                {"legal", 612, 1008},       {"slide", 720, 405}};
    for (const Paper& paper : papers)
        if (!words.empty() && words[0].text == paper.name) {
            const bool landscape = words.size() == 2 && words[1].text == "landscape";
            page.width = landscape ? paper.height : paper.width;
            page.height = landscape ? paper.width : paper.height;
            return words.size() == 1 || landscape ? ""
                                                  : "only landscape may follow the paper's name";
        }
    const auto width = words.size() == 2 ? length(words[0]) : std::nullopt;
    const auto height = words.size() == 2 ? length(words[1]) : std::nullopt;
    if (!width || !height || *width < 72 || *height < 72)
        return "wants A3, A4, A5, letter, legal or slide, or two lengths of at least 1in";
    page.width = *width;
    page.height = *height;
    return "";
}

// One for all sides; two: above and below, left and right; four: top, right, bottom, left.
std::string setMargins(PageStyle& page, const Words& words) {
    std::vector<double> lengths;
    for (const Property::Word& word : words)
        if (const auto value = length(word); value && *value >= 0)
            lengths.push_back(*value);
    if (lengths.size() != words.size() ||
        (lengths.size() != 1 && lengths.size() != 2 && lengths.size() != 4))
        return "wants one, two or four lengths";
    const std::size_t n = lengths.size();
    page.marginTop = lengths[0];
    page.marginRight = lengths[1 % n];
    page.marginBottom = lengths[2 % n];
    page.marginLeft = lengths[3 % n];
    return "";
}

using PageSetter = std::string (*)(PageStyle&, const Words&);

const std::map<std::string_view, PageSetter>& pageSetters() {
    using P = PageStyle;
    static const std::map<std::string_view, PageSetter> setters = {
        {"size", setPaper},
        {"margin", setMargins},
        {"header-left", [](P& p, const Words& w) { return setText(p.headerLeft, w); }},
        {"header-center", [](P& p, const Words& w) { return setText(p.headerCenter, w); }},
        {"header-right", [](P& p, const Words& w) { return setText(p.headerRight, w); }},
        {"footer-left", [](P& p, const Words& w) { return setText(p.footerLeft, w); }},
        {"footer-center", [](P& p, const Words& w) { return setText(p.footerCenter, w); }},
        {"footer-right", [](P& p, const Words& w) { return setText(p.footerRight, w); }},
        {"header-on-first-page",
         [](P& p, const Words& w) { return setFlag(p.headerOnFirstPage, w); }},
        {"balance", [](P& p, const Words& w) { return setFlag(p.balance, w); }},
        {"font", [](P& p, const Words& w) { return setFont(p.headerStyle, w, TextStyle{}.size); }},
        {"color", [](P& p, const Words& w) { return setColor(p.headerStyle.color, w); }},
        {"background", [](P& p, const Words& w) { return setColor(p.background, w); }},
        {"zoom",
         [](P& p, const Words& w) -> std::string {
             std::string_view unit;
             const auto value = w.size() == 1 ? number(w[0].text, unit) : std::nullopt;
             if (!value || unit != "%" || *value < 10 || *value > 1000)
                 return "wants 10% to 1000%";
             p.zoom = *value / 100;
             return "";
         }},
    };
    return setters;
}

} // namespace

std::string applyProperty(ElementStyle& style, const Property& property,
                          const ElementStyle& outer) {
    const auto setter = styleSetters().find(property.name);
    return setter == styleSetters().end() ? "no such property"
                                          : setter->second(style, property.words, outer);
}

std::optional<double> lengthOf(std::string_view text) {
    return length({.text = std::string(text)});
}

std::string applyPageProperty(PageStyle& page, const Property& property) {
    const auto setter = pageSetters().find(property.name);
    return setter == pageSetters().end() ? "no such property of PAGE"
                                         : setter->second(page, property.words);
}

} // namespace schemas
