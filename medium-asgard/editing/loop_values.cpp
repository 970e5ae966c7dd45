#include "editing/loop_values.h"

#include "editing/number_text.h"
#include "editing/tcl_expression.h"

#include <algorithm>
#include <cmath>

namespace editing {

using scene::Range;
using script::Command;
using script::Structure;
using script::Word;

namespace {

// One number of the text, taken as another one.
struct Instead {
    Range literal;
    TclNumber value;
};

// A variable that a loop or a call gives a value for each element that is made.
struct Variable {
    std::string name;
    std::vector<Range> each;    // foreach, procedure: where the value of each stands
    std::optional<Range> start; // for: where it begins
    std::optional<Range> step;  // and what it goes on by; none: 1
    bool counts() const { return start.has_value(); }
};

struct Loop {
    std::vector<Variable> variables;
    std::string place; // "the list of the foreach in line 3"
};

bool startsInside(const Command& command, Range range) {
    return command.range.from >= range.from && command.range.to <= range.to;
}

class Reading {
public:
    Reading(const Making& making, const Origins& origins)
        : making_(making), origins_(origins), structure_(origins.structure()) {}

    [[nodiscard]] std::optional<Loop> loop() const;

private:
    [[nodiscard]] std::optional<Loop> ofForeach(const Command& loop) const;
    [[nodiscard]] std::optional<Loop> ofFor(const Command& loop) const;
    [[nodiscard]] std::optional<Loop> ofProcedure(const Command& definition) const;
    [[nodiscard]] const Command* only(const Word& word, std::string_view name) const;

    const Making& making_;
    const Origins& origins_;
    const Structure& structure_;
};

std::optional<Loop> Reading::loop() const {
    const Command* maker = origins_.makerOf(making_.command);
    // The command runs once for each round: nothing stands between it and the loop.
    if (!maker || maker->parent >= 0 ||
        &structure_.commands[static_cast<std::size_t>(making_.command.parent)] != maker)
        return std::nullopt;
    const std::string name = origins_.slice(maker->words.front().content);
    return name == "foreach" ? ofForeach(*maker)
           : name == "for"   ? ofFor(*maker)
           : name == "proc"  ? ofProcedure(*maker)
                             : std::nullopt;
}

std::optional<Loop> Reading::ofForeach(const Command& loop) const {
    if (loop.words.size() != 4 || !loop.words[1].literal)
        return std::nullopt;
    const auto names = script::elementsOf(origins_.slice(loop.words[1].content));
    const auto list = origins_.literalOf(loop, loop.words[2]);
    if (!list.reason.empty() || names.elements.empty())
        return std::nullopt;
    const auto values = script::elementsOf(origins_.slice(list.content));
    const std::size_t count = names.elements.size();
    if (values.elements.size() != count * making_.together)
        return std::nullopt;
    Loop result{{}, "the list of line " + std::to_string(origins_.lineOf(list.content.from))};
    for (std::size_t i = 0; i < count; ++i) {
        Variable variable{names.elements[i].value, {}, {}, {}};
        for (std::size_t k = i; k < values.elements.size(); k += count)
            variable.each.push_back({list.content.from + values.elements[k].content.from,
                                     list.content.from + values.elements[k].content.to});
        result.variables.push_back(std::move(variable));
    }
    return result;
}

// The one command in a word.
const Command* Reading::only(const Word& word, std::string_view name) const {
    const Command* found = nullptr;
    for (const Command& command : structure_.commands)
        if (startsInside(command, word.content)) {
            if (found)
                return nullptr;
            found = &command;
        }
    return found && origins_.slice(found->words.front().content) == name ? found : nullptr;
}

std::optional<Loop> Reading::ofFor(const Command& loop) const {
    if (loop.words.size() != 5)
        return std::nullopt;
    const Command* start = only(loop.words[1], "set");
    const Command* next = only(loop.words[3], "incr");
    if (!start || start->words.size() != 3 || !start->words[2].literal || !next ||
        next->words.size() < 2 || next->words.size() > 3)
        return std::nullopt;
    Variable variable{origins_.slice(start->words[1].content), {}, start->words[2].content, {}};
    if (origins_.slice(next->words[1].content) != variable.name)
        return std::nullopt;
    if (next->words.size() == 3) {
        if (!next->words[2].literal)
            return std::nullopt;
        variable.step = next->words[2].content;
    }
    return Loop{{variable}, ""};
}

// Its calls, each at the top of the script, with words that are what they stand for.
std::optional<Loop> Reading::ofProcedure(const Command& definition) const {
    if (definition.words.size() != 4 || !definition.words[2].literal)
        return std::nullopt;
    const std::string name = origins_.slice(definition.words[1].content);
    std::vector<const Command*> calls;
    for (const Command& command : structure_.commands)
        if (command.name(origins_.text()) == name) {
            if (command.parent >= 0)
                return std::nullopt;
            calls.push_back(&command);
        }
    if (calls.size() != making_.together || making_.which >= calls.size())
        return std::nullopt;
    const auto names = script::elementsOf(origins_.slice(definition.words[2].content));
    Loop loop{{},
              "its call in line " +
                  std::to_string(origins_.lineOf(calls[making_.which]->range.from))};
    for (std::size_t i = 0; i < names.elements.size(); ++i) {
        Variable variable{names.elements[i].value, {}, {}, {}};
        for (const Command* call : calls) {
            if (call->words.size() <= i + 1 || !call->words[i + 1].literal)
                return std::nullopt;
            variable.each.push_back(call->words[i + 1].content);
        }
        loop.variables.push_back(std::move(variable));
    }
    return loop;
}

// ---------------------------------------------------------------------------------------------

// A number of the option, as it is worked out for each element.
class Component {
public:
    Component(const Loop& loop, const Origins& origins, Range written)
        : loop_(loop), origins_(origins), expression_(inner(written)) {}

    [[nodiscard]] std::optional<double> value(std::size_t which,
                                              const std::optional<Instead>& instead) const;
    // The numbers that it depends on, for that element.
    [[nodiscard]] std::vector<Range> literals(std::size_t which) const;
    // A variable that a `for` counts has whole numbers only.
    [[nodiscard]] bool isWhole(Range literal) const;

private:
    [[nodiscard]] Range inner(Range written) const;
    [[nodiscard]] std::optional<TclNumber> number(Range literal,
                                                  const std::optional<Instead>& instead) const;
    [[nodiscard]] std::optional<TclNumber> variable(std::string_view name, std::size_t which,
                                                    const std::optional<Instead>& instead) const;

    const Loop& loop_;
    const Origins& origins_;
    Range expression_;
};

// Of [expr {...}] what stands in it.
Range Component::inner(Range written) const {
    const std::string text = origins_.slice(written);
    constexpr std::string_view head = "[expr";
    if (!text.starts_with(head) || !text.ends_with(']'))
        return written;
    Range range = {written.from + head.size(), written.to - 1};
    const auto isBlank = [&](std::size_t at) { return origins_.text()[at] == ' '; };
    while (range.from < range.to && isBlank(range.from))
        ++range.from;
    while (range.to > range.from && isBlank(range.to - 1))
        --range.to;
    if (range.to - range.from >= 2 && origins_.text()[range.from] == '{' &&
        origins_.text()[range.to - 1] == '}')
        return {range.from + 1, range.to - 1};
    return range;
}

std::optional<TclNumber> Component::number(Range literal,
                                           const std::optional<Instead>& instead) const {
    return instead && instead->literal == literal ? instead->value
                                                  : tclNumber(origins_.slice(literal));
}

std::optional<TclNumber> Component::variable(std::string_view name, std::size_t which,
                                             const std::optional<Instead>& instead) const {
    for (const Variable& one : loop_.variables) {
        if (one.name != name)
            continue;
        if (!one.counts())
            return number(one.each[which], instead);
        const auto start = number(*one.start, instead);
        const auto step = one.step ? number(*one.step, instead) : TclNumber{1, true};
        if (!start || !step)
            return std::nullopt;
        return TclNumber{start->value + static_cast<double>(which) * step->value,
                         start->integer && step->integer};
    }
    return std::nullopt;
}

std::optional<double> Component::value(std::size_t which,
                                       const std::optional<Instead>& instead) const {
    const TclNames names{[&](std::string_view name) { return variable(name, which, instead); },
                         [&](Range literal) -> std::optional<TclNumber> {
                             return instead && instead->literal == literal
                                        ? std::optional(instead->value)
                                        : std::nullopt;
                         }};
    const auto value = tclValue(origins_.text(), expression_, names);
    return value ? std::optional(value->value) : std::nullopt;
}

std::vector<Range> Component::literals(std::size_t which) const {
    std::vector<Range> all = tclLiterals(origins_.text(), expression_);
    for (const Variable& one : loop_.variables) {
        if (one.counts()) {
            // Another start would be another number of elements, with other names.
            if (one.step)
                all.push_back(*one.step);
        } else {
            all.push_back(one.each[which]);
        }
    }
    return all;
}

bool Component::isWhole(Range literal) const {
    return std::ranges::any_of(
        loop_.variables, [&](const Variable& one) { return one.counts() && one.step == literal; });
}

// ---------------------------------------------------------------------------------------------

enum class Effect { own, alike, step }; // on the others: none, as much, each by its place

struct Way { // to the value that is wanted
    Effect effect = Effect::own;
    TextEdit edit;
    std::string before;
    bool ofLoop = false; // the number that a `for` goes on by
};

class Ways {
public:
    Ways(const Making& making, const Component& component, const Origins& origins,
         double resolution)
        : making_(making), component_(component), origins_(origins), resolution_(resolution) {}

    [[nodiscard]] std::vector<Way> to(double wanted) const;

private:
    [[nodiscard]] std::optional<double> slope(std::size_t which, Range literal) const;
    [[nodiscard]] std::optional<double> solved(Range literal, double wanted) const;
    [[nodiscard]] std::optional<Way> by(Range literal, double wanted) const;

    const Making& making_;
    const Component& component_;
    const Origins& origins_;
    double resolution_;
};

// As doubles, so that a division of whole numbers does not jump.
std::optional<double> Ways::slope(std::size_t which, Range literal) const {
    const auto old = tclNumber(origins_.slice(literal));
    if (!old)
        return std::nullopt;
    const auto here = component_.value(which, Instead{literal, {old->value, false}});
    const auto there = component_.value(which, Instead{literal, {old->value + 1, false}});
    return here && there ? std::optional(*there - *here) : std::nullopt;
}

// Newton's method from the number as it is, exact at once where it enters linearly; where it
// divides, steps are kept short of the pole.
std::optional<double> Ways::solved(Range literal, double wanted) const {
    const auto at = [&](double x) {
        return component_.value(making_.which, Instead{literal, {x, false}});
    };
    double x = tclNumber(origins_.slice(literal))->value;
    for (int i = 0; i < 60; ++i) {
        const double h = 1e-5 * std::max(1.0, std::abs(x));
        const auto here = at(x), after = at(x + h), before = at(x - h);
        if (!here || !after || !before || *after == *before)
            return std::nullopt;
        const double step = (wanted - *here) * 2 * h / (*after - *before);
        if (std::abs(step) <= 1e-12 * std::max(1.0, std::abs(x)))
            return x;
        const bool jumps =
            !at(x + step) || std::abs(*at(x + step) - wanted) > std::abs(*here - wanted);
        x += jumps ? std::clamp(step, -0.4 * std::abs(x), 0.4 * std::abs(x)) : step;
    }
    return x;
}

std::optional<Way> Ways::by(Range literal, double wanted) const {
    const auto steepness = slope(making_.which, literal);
    if (!steepness || std::abs(*steepness) < 1e-12)
        return std::nullopt;
    Way way;
    way.before = origins_.slice(literal);
    const double old = tclNumber(way.before)->value;
    const double resolution = resolution_ / std::abs(*steepness);
    const auto solution = solved(literal, wanted);
    if (!solution)
        return std::nullopt;
    double value = *solution;
    const bool whole = component_.isWhole(literal);
    way.ofLoop = whole;
    if (whole)
        value = std::round(value);
    if (whole && value == old)
        return std::nullopt;
    // What is typed exactly is reached up to rounding, which is nothing to write down.
    const double least = 1e-12 * std::max({1.0, std::abs(old), std::abs(value)});
    value = std::abs(value) < least ? 0 : value;
    const std::string text = numberText(value, whole ? 1 : std::max(resolution, least), way.before);
    const auto number = tclNumber(text);
    const auto reached =
        number ? component_.value(making_.which, Instead{literal, *number}) : std::nullopt;
    const double close = std::max(resolution_, 1e-9 * std::max(1.0, std::abs(wanted)));
    if (!reached || (!whole && std::abs(*reached - wanted) > close))
        return std::nullopt;
    way.edit = {literal.from, literal.to, text};
    const std::size_t other = making_.which == 0 ? 1 : 0;
    const auto elsewhere = slope(other, literal);
    if (!elsewhere)
        return std::nullopt;
    const auto others = component_.literals(other);
    const bool shared = std::ranges::find(others, literal) != others.end();
    const bool equal = std::abs(*elsewhere - *steepness) <= 1e-9 * std::abs(*steepness);
    way.effect = !shared ? Effect::own : equal ? Effect::alike : Effect::step;
    return way;
}

std::vector<Way> Ways::to(double wanted) const {
    std::vector<Way> all;
    for (const Range& literal : component_.literals(making_.which))
        if (auto way = by(literal, wanted))
            all.push_back(std::move(*way));
    return all;
}

struct Changing {       // a number that is to change
    bool plain = false; // it stands there as it is, the same for all
    std::vector<Way> ways;
};

std::optional<Offer> offerBy(Effect effect, const std::vector<Changing>& all, const Making& making,
                             const Loop& loop) {
    Offer offer;
    const Way* told = nullptr;
    for (const Changing& one : all) {
        const auto find = [&](Effect which) {
            return std::ranges::find(one.ways, which, &Way::effect);
        };
        auto way = find(effect);
        if (way == one.ways.end() && effect == Effect::step)
            way = find(Effect::alike);
        if (way == one.ways.end())
            return std::nullopt;
        if (!one.plain && way->effect == effect)
            told = &*way;
        const auto twice = std::ranges::find(offer.edits, way->edit.from, &TextEdit::from);
        if (twice == offer.edits.end())
            offer.edits.push_back(way->edit);
        else if (twice->text != way->edit.text)
            return std::nullopt;
    }
    if (!told)
        return std::nullopt;
    std::ranges::sort(offer.edits, {}, &TextEdit::from);
    offer.label = effect == Effect::own ? "Only " + making.name + ", in " + loop.place
                  : effect == Effect::alike
                      ? "All " + std::to_string(making.together) + ", by as much"
                      : (told->ofLoop ? "The step of the loop: " : "The step: ") + told->before +
                            " becomes " + told->edit.text;
    return offer;
}

} // namespace

std::vector<Offer> loopOffers(const Making& making, const Wish& wish, const Origins& origins) {
    const Word* word = wordOf(making.command, making.source, wish.option);
    const auto loop = Reading(making, origins).loop();
    if (!word || !loop || making.together < 2 || !wish.path.empty())
        return {};
    const std::vector<Origin> from =
        wish.values.size() == 1 ? std::vector<Origin>{origins.ofScalar(making.command, *word)}
                                : origins.ofList(making.command, *word, {});
    if (from.size() < wish.values.size())
        return {};
    std::vector<Changing> all;
    for (std::size_t i = 0; i < wish.values.size(); ++i) {
        const bool plain = from[i].reason.empty();
        const Component component(*loop, origins, plain ? from[i].literal : from[i].place);
        const auto now = component.value(making.which, std::nullopt);
        if (!now)
            return {};
        if (std::abs(*now - wish.values[i]) > 0.5 * wish.resolution)
            all.push_back(
                {plain, Ways(making, component, origins, wish.resolution).to(wish.values[i])});
    }
    std::vector<Offer> offers;
    for (const Effect effect : {Effect::own, Effect::step, Effect::alike})
        if (auto offer = offerBy(effect, all, making, *loop))
            offers.push_back(std::move(*offer));
    return offers;
}

} // namespace editing
