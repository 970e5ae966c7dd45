#include "model/value_text.h"

#include "model/resolving.h"

#include "text/characters.h"

#include <QLocale>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace model {

namespace {

using document::Digits;
using document::ValueUse;

constexpr std::string_view minus = "\u2212", waiting = "\u2026";
constexpr int leastPower = -4; // of ten: what is smaller, or larger than its digits, has a power
constexpr int mostWhole = 15;  // digits before the point

// A number in parts: "-", "4.20" with a point, and the power of ten.
struct Parts {
    bool isNegative = false;
    std::string digits;
    int power = 0;
};

std::string fixed(double number, int decimals) {
    std::array<char, 400> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                   std::chars_format::fixed, std::max(decimals, 0))
                         .ptr;
    return {text.data(), end};
}

// The mantissa with so many digits behind its point.
Parts scientific(double number, int decimals) {
    std::array<char, 64> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                   std::chars_format::scientific, std::max(decimals, 0))
                         .ptr;
    const std::string_view all(text.data(), static_cast<std::size_t>(end - text.data()));
    const std::size_t e = all.find('e');
    Parts parts{.digits = std::string(all.substr(0, e))};
    const std::size_t power = e + (all[e + 1] == '+' ? 2 : 1);
    std::from_chars(all.data() + power, all.data() + all.size(), parts.power);
    return parts;
}

Parts partsOf(double number, Digits digits) {
    const double size = std::abs(number);
    Parts parts = scientific(size, digits.count - (digits.areDecimals ? 0 : 1));
    const int power = size == 0 ? 0 : parts.power; // as it is rounded
    if (digits.areDecimals && power < mostWhole)
        parts = {.digits = fixed(size, digits.count)};
    else if (!digits.areDecimals && power >= leastPower && power < std::max(digits.count, 6))
        parts = {.digits = fixed(size, digits.count - 1 - power)};
    const bool isZero = parts.digits.find_first_of("123456789") == std::string::npos;
    parts.isNegative = std::signbit(number) && !isZero;
    return parts;
}

// The sign between whole digits and the others in a language.
std::string pointOf(std::string_view language) {
    if (language.empty())
        return ".";
    const QString name =
        QString::fromUtf8(language.data(), static_cast<qsizetype>(language.size()));
    return QLocale(QString(name).replace('-', '_')).decimalPoint().toStdString();
}

bool isEnglish(std::string_view language) { return language.empty() || language.starts_with("en"); }

void replacePoint(std::string& digits, const std::string& by) {
    if (const std::size_t at = digits.find('.'); at != std::string::npos)
        digits.replace(at, 1, by);
}

std::string raised(int power) {
    constexpr std::array digits{"\u2070", "\u00B9", "\u00B2", "\u00B3", "\u2074",
                                "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
    std::string text;
    for (const char c : std::to_string(power))
        text += c == '-' ? "\u207B" : digits.at(static_cast<std::size_t>(c - '0'));
    return text;
}

// A number of the same look: one that takes as much width, or more.
std::string shapeOf(std::string_view number) {
    std::string shape(number);
    std::ranges::replace_if(
        shape, [](char c) { return c >= '1' && c <= '9'; }, '0');
    return shape;
}

// Of numbers without knowing their font: a point is narrower than a digit, any other sign (a minus,
// the cross before a power of ten) wider.
int roughWidth(std::string_view number) {
    constexpr int digit = 4, point = 2, other = 5;
    int width = 0;
    for (const char c : number)
        width += c >= '0' && c <= '9'      ? digit
                 : c == '.' || c == ','    ? point
                 : text::isContinuation(c) ? 0
                                           : other;
    return width;
}

// The room of a number that plays, where `before` was its room or what stood there.
std::string roomFor(const std::string& before, const std::string& number) {
    std::string room = shapeOf(number);
    return roughWidth(before) >= roughWidth(room) ? before : room;
}

// The text of a number that stood there; else "".
std::string_view numberIn(const Run& run) {
    const bool isNumber = run.value && run.style != run.value->looks.faulty &&
                          run.text.find_first_of("0123456789") != std::string::npos;
    return isNumber ? std::string_view(run.text) : std::string_view();
}

ValueNow nowOf(const ValueUse& use, const ValueSource* source) {
    if (!use.fault.empty())
        return {.fault = use.fault};
    return source != nullptr ? source->valueNow(use) : ValueNow{};
}

std::optional<Run> valueNow(const Run& run, const ValueSource* source) {
    const Value& value = *run.value;
    const ValueNow now = nowOf(value.use, source);
    Run made = run;
    made.style = !now.fault.empty() ? value.looks.faulty
                 : now.isOutdated   ? value.looks.outdated
                                    : value.looks.usual;
    if (now.number && now.fault.empty())
        made.text = written(*now.number, value.use.digits, value.looks.language);
    else
        made.text = now.fault.empty() && source != nullptr ? std::string(waiting)
                                                           : "[" + value.use.expression + "]";
    std::string room;
    if (now.moves && now.number && now.fault.empty()) {
        room = roomFor(value.room.empty() ? shapeOf(numberIn(run)) : value.room, made.text);
        made.text.insert(0, figureSpace);
    }
    if (room != value.room) {
        auto roomy = std::make_shared<Value>(value);
        roomy->room = std::move(room);
        made.value = std::move(roomy);
    }
    if (made.text == run.text && made.style == run.style && made.value == run.value)
        return std::nullopt;
    return made;
}

ValueUse useOf(const formulas::ValueCall& call) {
    return document::valueUse(call.of, call.expression, call.options);
}

// The room of a formula's number until now: while it rested, that of the number itself.
std::string roomBefore(const Formula& was, std::size_t value) {
    if (value >= was.values.size())
        return "";
    const formulas::SuppliedValue& before = was.values[value];
    const bool isNumber = before.source.find_first_of("0123456789") != std::string::npos;
    return !before.room.empty() ? before.room : isNumber ? shapeOf(before.source) : "";
}

std::optional<Run> formulaNow(const Run& run, const ValueSource* source) {
    const Formula& was = *run.formula;
    std::vector<formulas::SuppliedValue> values;
    bool isOutdated = false;
    for (const formulas::ValueCall& call : was.read.values) {
        const ValueUse use = useOf(call);
        const ValueNow now = nowOf(use, source);
        formulas::SuppliedValue supplied{.isFaulty = !now.fault.empty()};
        if (now.number && now.fault.empty()) {
            supplied.source = asFormula(*now.number, use.digits, was.looks.language);
            if (now.moves)
                supplied.room = roomFor(roomBefore(was, values.size()), supplied.source);
        } else if (now.fault.empty() && source != nullptr) {
            supplied.source = "\\ldots ";
        }
        isOutdated = isOutdated || now.isOutdated;
        values.push_back(std::move(supplied));
    }
    const std::uint32_t style = isOutdated ? was.looks.outdated : was.looks.usual;
    if (values == was.values && style == run.style)
        return std::nullopt;
    auto formula = std::make_shared<Formula>(was);
    formula->read = formulas::read(
        was.source, [&, next = std::size_t{0}](const auto&) mutable { return values[next++]; });
    formula->spoken = formulas::spoken(formula->read);
    formula->values = std::move(values);
    Run made = run;
    made.text = formulas::plain(formula->read);
    made.style = style;
    made.formula = std::move(formula);
    return made;
}

} // namespace

std::string written(double number, Digits digits, std::string_view language) {
    Parts parts = partsOf(number, digits);
    replacePoint(parts.digits, pointOf(language));
    std::string text = (parts.isNegative ? std::string(minus) : std::string()) + parts.digits;
    if (parts.power != 0)
        text += (isEnglish(language) ? "\u00D710" : "\u00B710") + raised(parts.power);
    return text;
}

std::string asFormula(double number, Digits digits, std::string_view language) {
    Parts parts = partsOf(number, digits);
    const std::string point = pointOf(language);
    replacePoint(parts.digits, point == "." ? point : "{" + point + "}");
    std::string text = (parts.isNegative ? "-" : "") + parts.digits;
    if (parts.power != 0)
        text += std::string(isEnglish(language) ? "\\times" : "\\cdot") + " 10^{" +
                std::to_string(parts.power) + "}";
    return text;
}

std::string plainText(const Run& run) {
    std::string_view text = run.text;
    while (run.value && text.starts_with(figureSpace))
        text.remove_prefix(figureSpace.size());
    const bool isFormula = run.formula && !run.formula->read.values.empty();
    const ValueLooks* looks = run.value   ? &run.value->looks
                              : isFormula ? &run.formula->looks
                                          : nullptr;
    const bool isOutdated =
        looks != nullptr && looks->usual != looks->outdated && run.style == looks->outdated;
    return std::string(text) + (isOutdated ? " (out of date)" : "");
}

std::shared_ptr<const Block> withValues(const std::shared_ptr<const Block>& block,
                                        const ValueSource* source) {
    return resolved(block, [source](const Run& run) -> std::optional<Run> {
        if (run.value)
            return valueNow(run, source);
        if (run.formula && !run.formula->read.values.empty())
            return formulaNow(run, source);
        return std::nullopt;
    });
}

} // namespace model
