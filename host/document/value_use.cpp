#include "document/value_use.h"

#include "document/subdocument.h"

#include <charconv>
#include <cmath>

namespace document {

namespace {

constexpr double longestTime = 1e12; // s

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(" \t\r\n");
    if (from == std::string_view::npos)
        return {};
    return text.substr(from, text.find_last_not_of(" \t\r\n") + 1 - from);
}

// A number, and the word behind it.
struct Counted {
    double number = 0;
    std::string_view word;
};
std::optional<Counted> countedIn(std::string_view text) {
    text = trimmed(text);
    Counted found;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found.number);
    if (error != std::errc{} || !std::isfinite(found.number))
        return std::nullopt;
    found.word = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    return found;
}

bool readDigits(std::string_view text, ValueUse& use) {
    const auto found = countedIn(text);
    const bool areDecimals = found && (found->word == "decimals" || found->word == "decimal");
    const bool areDigits = found && (found->word == "digits" || found->word == "digit");
    const int least = areDecimals ? 0 : 1, most = areDecimals ? mostDecimals : mostDigits;
    if ((!areDecimals && !areDigits) || found->number != std::floor(found->number) ||
        found->number < least || found->number > most)
        return false;
    use.digits = {static_cast<int>(found->number), areDecimals};
    return true;
}

bool readTime(std::string_view text, ValueUse& use) {
    const auto found = countedIn(text);
    if (!found || std::abs(found->number) > longestTime ||
        !(found->word.empty() || found->word == "s"))
        return false;
    use.time = found->number;
    return true;
}

void addFault(ValueUse& use, std::string sentence) {
    if (use.fault.empty())
        use.fault = std::move(sentence);
}

void judge(ValueUse& use) {
    if (use.of.empty())
        addFault(use, "a value needs the ID of a subdocument");
    else if (use.expression.empty())
        addFault(use, "a value needs an expression of its subdocument's medium");
}

std::string number(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
}

} // namespace

ValueUse valueUse(const sgml::Tree& tree, sgml::NodeId element) {
    const auto attribute = [&](std::string_view name) {
        return std::string(tree.attribute(element, name).value_or(""));
    };
    ValueUse use{.of = attribute("OF"),
                 .expression = std::string(trimmed(attribute("EXPRESSION")))};
    if (const std::string format = attribute("FORMAT");
        !trimmed(format).empty() && !readDigits(format, use))
        addFault(use, "FORMAT wants \"2 decimals\" (0 to 12) or \"3 digits\" (1 to 15)");
    if (const std::string time = attribute("TIME"); !trimmed(time).empty() && !readTime(time, use))
        addFault(use, "TIME wants a time in seconds, as \"1.5 s\"");
    judge(use);
    return use;
}

ValueUse valueUse(std::string of, std::string expression, std::string_view options) {
    ValueUse use{.of = std::string(trimmed(of)), .expression = std::string(trimmed(expression))};
    while (!options.empty()) {
        const std::size_t comma = std::min(options.find(','), options.size());
        const std::string_view one = trimmed(options.substr(0, comma));
        options.remove_prefix(std::min(comma + 1, options.size()));
        if (one.empty())
            continue;
        if (one.starts_with("at ") ? !readTime(one.substr(3), use) : !readDigits(one, use))
            addFault(use, "\"" + std::string(one) +
                              "\" is none of \"2 decimals\", \"3 digits\" and \"at 1.5 s\"");
    }
    judge(use);
    return use;
}

std::string spelled(const Digits& digits) {
    const char* unit = digits.areDecimals ? " decimal" : " digit";
    return std::to_string(digits.count) + unit + (digits.count == 1 ? "" : "s");
}

std::string spelledTime(double seconds) { return number(seconds) + " s"; }

std::string spelledOptions(const ValueUse& use) {
    std::string options = use.digits == Digits{} ? "" : spelled(use.digits);
    if (use.time)
        options += (options.empty() ? "at " : ", at ") + spelledTime(*use.time);
    return options;
}

} // namespace document
