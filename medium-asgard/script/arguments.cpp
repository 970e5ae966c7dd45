#include "script/arguments.h"

#include "script/meant.h"
#include "script/numbers.h"
#include "script/suggestion.h"
#include "script/svg_colors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace script {

std::string quoted(std::string_view text) {
    constexpr std::size_t most = 40;
    std::string shown;
    for (const char c : text.substr(0, most))
        shown += c == '\n' || c == '\r' || c == '\t' ? ' ' : c;
    // Never half a character.
    if (text.size() > most) {
        while (!shown.empty() && (static_cast<unsigned char>(shown.back()) & 0xc0) == 0x80)
            shown.pop_back();
        if (!shown.empty() && static_cast<unsigned char>(shown.back()) >= 0x80)
            shown.pop_back();
        shown += "...";
    }
    return "\"" + shown + "\"";
}

Value Value::part(const Element& element) const {
    Value part;
    part.text = element.value;
    part.range = range;
    if (exact) {
        part.range = {origin + element.range.from, origin + element.range.to};
        part.exact = element.literal;
        part.origin = origin + element.content.from;
    }
    return part;
}

Value Value::piece(std::size_t from, std::size_t to) const {
    Value part = *this;
    from = std::min(from, text.size());
    to = std::clamp(to, from, text.size());
    part.text = text.substr(from, to - from);
    if (exact && to > from) {
        part.range = {origin + from, origin + to};
        part.origin = origin + from;
    }
    return part;
}

void Faults::error(Range range, std::string message, std::string suggestion) {
    add(scene::Severity::error, range, std::move(message), std::move(suggestion));
}

void Faults::warning(Range range, std::string message, std::string suggestion) {
    add(scene::Severity::warning, range, std::move(message), std::move(suggestion));
}

void Faults::add(scene::Severity severity, Range range, std::string message,
                 std::string suggestion) {
    constexpr std::size_t most = 1000;
    constexpr int mostAtOnePlace = 3; // a command in a loop is wrong once, not a thousand times
    if (range.known() && ++atPlace_[range.from] > mostAtOnePlace)
        return;
    if (out_.size() > most)
        return;
    if (out_.size() == most) {
        range = {};
        message = "there is more that is wrong";
        suggestion.clear();
    }
    scene::Diagnostic diagnostic;
    diagnostic.severity = severity;
    diagnostic.range = range;
    diagnostic.message = std::move(message);
    diagnostic.suggestion = std::move(suggestion);
    locate(places_, diagnostic);
    out_.push_back(std::move(diagnostic));
}

Arguments::Arguments(Faults& faults, Call& call, std::string subject, std::size_t first,
                     std::span<const std::string_view> options)
    : faults_(faults), call_(call), subject_(std::move(subject)) {
    read(first, options);
}

Arguments::Arguments(Faults& faults, Call& call, std::string subject, std::size_t first,
                     std::initializer_list<std::string_view> options)
    : Arguments(faults, call, std::move(subject), first,
                std::span(options.begin(), options.size())) {}

void Arguments::read(std::size_t first, std::span<const std::string_view> options) {
    const auto isKnown = [&](const Value& word) {
        return std::find(options.begin(), options.end(), word.text) != options.end();
    };
    for (std::size_t i = first; i < call_.words.size(); ++i) {
        const Value& word = call_.words[i];
        const bool known = isKnown(word);
        if (!known && (!word.text.starts_with('-') || decimalNumber(word.text))) {
            misread_ = true;
            strayWord(word, options);
            return; // what follows is out of step
        }
        const Value* value = i + 1 < call_.words.size() ? &call_.words[i + 1] : nullptr;
        if (value && isKnown(*value)) // no value looks like an option
            value = nullptr;
        if (value)
            ++i;
        if (!known) {
            misread_ = true;
            const std::vector<std::string> names(options.begin(), options.end());
            const std::string meant = meantByOption(word.text, names);
            faults_.error(word.range, subject_ + " has no option " + quoted(word.text),
                          meant.empty() ? suggestionFor(word.text, names, "options here") : meant);
        } else if (given(word.text)) {
            faults_.error(word.range, word.text + " of " + subject_ + " is given twice");
        } else {
            given_.push_back({word.text, word.range, value});
            if (value)
                call_.source.arguments.push_back({word.text, value->range, value->exact});
        }
    }
}

void Arguments::strayWord(const Value& word, std::span<const std::string_view> options) {
    std::string suggestion;
    const bool numbers = decimalNumber(word.text) && !given_.empty() && given_.back().value &&
                         decimalNumber(given_.back().value->text);
    if (numbers) {
        suggestion = "braces make several words one value: " + given_.back().option + " {" +
                     given_.back().value->text + " " + word.text + " ...}";
    } else if (std::find(options.begin(), options.end(), "-" + word.text) != options.end()) {
        suggestion = "did you mean \"-" + word.text + "\"?";
    }
    faults_.error(word.range, quoted(word.text) + " stands where " + subject_ + " wants an option",
                  std::move(suggestion));
}

const Arguments::Given* Arguments::given(std::string_view option) const {
    const auto found = std::find_if(given_.begin(), given_.end(),
                                    [&](const Given& g) { return g.option == option; });
    return found == given_.end() ? nullptr : &*found;
}

const Value* Arguments::find(std::string_view option) const {
    const Given* found = given(option);
    return found ? found->value : nullptr;
}

bool Arguments::attempted(std::string_view option) const { return given(option) != nullptr; }

Range Arguments::optionRange(std::string_view option) const {
    const Given* found = given(option);
    return found ? found->optionRange : commandRange();
}

void Arguments::wrong(std::string_view option, Range range, std::string_view wants,
                      std::string_view but, std::string suggestion) {
    faults_.error(range,
                  std::string(option) + " of " + subject_ + " wants " + std::string(wants) + ", " +
                      std::string(but),
                  std::move(suggestion));
}

void Arguments::wrongElement(std::string message, std::string suggestion) {
    if (misread_ && message.starts_with("wants"))
        return; // what is missing is most likely what was misspelt
    faults_.error(commandRange(), subject_ + " " + std::move(message), std::move(suggestion));
}

namespace {
constexpr std::string_view flagWish = "0 or 1";
}

const Value* Arguments::wanted(std::string_view option, std::string_view wants) {
    const auto found = std::find_if(given_.begin(), given_.end(),
                                    [&](const Given& g) { return g.option == option; });
    if (found == given_.end())
        return nullptr;
    if (!found->value && !std::exchange(found->reported, true))
        wrong(option, found->optionRange, wants, "and nothing follows it",
              wants == flagWish ? "write " + std::string(option) + " 1" : "");
    return found->value;
}

namespace {

std::string_view wantsFor(Sign sign) {
    switch (sign) {
    case Sign::positive:
        return "a positive number";
    case Sign::notNegative:
        return "a number that is not negative";
    case Sign::unit:
        return "a number from 0 to 1";
    case Sign::any:
        break;
    }
    return "a number";
}

bool fits(double value, Sign sign) {
    return sign == Sign::any || (sign == Sign::positive && value > 0) ||
           (sign == Sign::notNegative && value >= 0) ||
           (sign == Sign::unit && value >= 0 && value <= 1);
}

std::string notANumber(std::string_view text) {
    return "and " + quoted(text) + " is not " + (text.empty() ? "one" : "a decimal number");
}

// A number, but none that a computer's own numbers come near.
bool isBeyondRange(std::string_view text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc::result_out_of_range && stop == end;
}

constexpr std::string_view colorWish = "a colour: #rrggbb, an SVG name, or {r g b} from 0 to 1";

std::string countWord(std::size_t count) {
    constexpr std::string_view words[] = {"nothing", "one",  "two", "three",
                                          "four",    "five", "six", "seven"};
    return count < std::size(words) ? std::string(words[count]) : std::to_string(count);
}

} // namespace

std::optional<double> Arguments::numberIn(std::string_view option, const Value& value, Sign sign,
                                          std::string_view wants, std::string otherwise) {
    const auto number = decimalNumber(value.text);
    if (isBeyondRange(value.text))
        wrong(option, value.range, wants,
              "and " + value.text + " is out of range: sizes go from 1e-308 to 1e308");
    else if (!number)
        wrong(option, value.range, wants, notANumber(value.text),
              value.text.find(',') != std::string::npos
                  ? "blanks stand between numbers, no commas: {1 0 0}"
                  : std::move(otherwise));
    else if (!fits(*number, sign))
        wrong(option, value.range, wants, "not " + value.text);
    else
        return number;
    return std::nullopt;
}

std::optional<std::vector<Value>> Arguments::listIn(std::string_view option, const Value& value,
                                                    std::string_view wants) {
    const ElementList list = elementsOf(value.text);
    if (!list.fault.empty()) {
        wrong(option, value.piece(list.faultRange.from, list.faultRange.to).range, wants,
              "and " + list.fault);
        return std::nullopt;
    }
    std::vector<Value> parts;
    parts.reserve(list.elements.size());
    for (const Element& element : list.elements)
        parts.push_back(value.part(element));
    return parts;
}

std::optional<std::vector<double>> Arguments::numbersIn(std::string_view option, const Value& value,
                                                        std::string_view wants) {
    const auto parts = listIn(option, value, wants);
    if (!parts)
        return std::nullopt;
    std::vector<double> numbers;
    for (const Value& part : *parts) {
        const auto number = numberIn(option, part, Sign::any, wants);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

std::optional<geometry::Vector> Arguments::vectorIn(std::string_view option, const Value& value,
                                                    std::string_view wants) {
    const auto numbers = numbersIn(option, value, wants);
    if (!numbers)
        return std::nullopt;
    if (numbers->size() != 3) {
        wrong(option, value.range, wants, "and gets " + countWord(numbers->size()));
        return std::nullopt;
    }
    return geometry::Vector((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

std::optional<double> Arguments::number(std::string_view option, Sign sign, std::string otherwise) {
    const Value* value = wanted(option, wantsFor(sign));
    return value ? numberIn(option, *value, sign, wantsFor(sign), std::move(otherwise))
                 : std::nullopt;
}

std::optional<int> Arguments::integer(std::string_view option) {
    constexpr std::string_view wants = "a whole number";
    const Value* value = wanted(option, wants);
    if (!value)
        return std::nullopt;
    const auto number = decimalNumber(value->text);
    if (number && std::trunc(*number) == *number && std::abs(*number) <= 2e9)
        return static_cast<int>(*number);
    wrong(option, value->range, wants, "and " + quoted(value->text) + " is not one");
    return std::nullopt;
}

std::optional<bool> Arguments::flag(std::string_view option) {
    const Value* value = wanted(option, flagWish);
    if (!value)
        return std::nullopt;
    const auto number = decimalNumber(value->text);
    if (number && (*number == 0 || *number == 1))
        return *number == 1;
    wrong(option, value->range, flagWish, "not " + quoted(value->text));
    return std::nullopt;
}

std::optional<geometry::Vector> Arguments::vector(std::string_view option) {
    constexpr std::string_view wants = "three numbers";
    const Value* value = wanted(option, wants);
    return value ? vectorIn(option, *value, wants) : std::nullopt;
}

std::optional<scene::Color> Arguments::colorIn(std::string_view option, const Value& value) {
    const std::string& text = value.text;
    if (text.starts_with('#')) {
        const bool hexadecimal =
            text.size() == 7 &&
            text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
        if (!hexadecimal) {
            wrong(option, value.range, colorWish, "not " + quoted(text));
            return std::nullopt;
        }
        const unsigned long rgb = std::stoul(text.substr(1), nullptr, 16);
        return scene::Color{static_cast<double>((rgb >> 16) & 255) / 255,
                            static_cast<double>((rgb >> 8) & 255) / 255,
                            static_cast<double>(rgb & 255) / 255};
    }
    if (const auto named = namedColor(text))
        return named;
    if (text.empty() || text.find_first_not_of("0123456789.eE+- \t\n\r") != std::string::npos) {
        const std::string near = nearest(text, colorNames());
        wrong(option, value.range, colorWish, "not " + quoted(text),
              near.empty() ? "" : "did you mean \"" + near + "\"?");
        return std::nullopt;
    }
    const auto rgb = vectorIn(option, value, colorWish);
    if (!rgb)
        return std::nullopt;
    if (rgb->minCoeff() < 0 || rgb->maxCoeff() > 1) {
        wrong(option, value.range, colorWish, "not " + quoted(text));
        return std::nullopt;
    }
    return scene::Color{rgb->x(), rgb->y(), rgb->z()};
}

std::optional<scene::Color> Arguments::color(std::string_view option) {
    const Value* value = wanted(option, colorWish);
    return value ? colorIn(option, *value) : std::nullopt;
}

std::optional<std::string> Arguments::text(std::string_view option) {
    const Value* value = wanted(option, "a text");
    return value ? std::optional(value->text) : std::nullopt;
}

std::optional<std::string> Arguments::name(std::string_view option, std::string_view what) {
    const std::string wants = "the name of " + std::string(what);
    const Value* value = wanted(option, wants);
    if (!value)
        return std::nullopt;
    if (value->text.empty() || value->text.starts_with('-')) {
        wrong(option, value->range, wants, "not " + quoted(value->text));
        return std::nullopt;
    }
    return value->text;
}

scene::Appearance Arguments::appearance() {
    scene::Appearance appearance;
    appearance.color = color("-color");
    appearance.shininess = number("-shininess", Sign::unit);
    appearance.transparency = number("-transparency", Sign::unit);
    return appearance;
}

bool Arguments::atMostOne(std::initializer_list<std::string_view> options) {
    std::string_view first;
    for (const Given& g : given_) {
        if (std::find(options.begin(), options.end(), g.option) == options.end())
            continue;
        if (!first.empty()) {
            faults_.error(g.optionRange, subject_ + " has " + std::string(first) +
                                             " already, and " + g.option + " says otherwise");
            return false;
        }
        first = g.option;
    }
    return true;
}

} // namespace script
