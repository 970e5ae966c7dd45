#include "editing/loop_values.h"

#include "editing/element_values.h"
#include "editing/loop_reading.h"
#include "editing/number_text.h"
#include "editing/tcl_expression.h"
#include "editing/variable_uses.h"

#include <algorithm>
#include <cmath>

namespace editing {

using scene::Range;
using script::Word;

namespace {

// One number of the text, taken as another one.
struct Instead {
    Range literal;
    TclNumber value;
};
using Insteads = std::vector<Instead>;

std::optional<TclNumber> given(const Insteads& insteads, Range literal) {
    const auto found = std::ranges::find(insteads, literal, &Instead::literal);
    return found == insteads.end() ? std::nullopt : std::optional(found->value);
}

// The loop's variables, for each element and with other numbers.
class Rounds {
public:
    Rounds(const Loop& loop, const Origins& origins) : loop_(loop), origins_(origins) {}

    [[nodiscard]] const Loop& loop() const { return loop_; }
    [[nodiscard]] const Origins& origins() const { return origins_; }
    [[nodiscard]] std::optional<TclNumber> number(Range literal, const Insteads& insteads) const;
    [[nodiscard]] std::optional<TclNumber> variable(std::string_view name, std::size_t which,
                                                    const Insteads& insteads) const;
    // Whether it goes around so often, neither less nor more.
    [[nodiscard]] bool goesAround(std::size_t times, const Insteads& insteads) const;

private:
    [[nodiscard]] std::optional<bool> condition(std::size_t which, const Insteads& insteads) const;

    const Loop& loop_;
    const Origins& origins_;
};

std::optional<TclNumber> Rounds::number(Range literal, const Insteads& insteads) const {
    const auto instead = given(insteads, literal);
    return instead ? instead : tclNumber(origins_.slice(literal));
}

std::optional<TclNumber> Rounds::variable(std::string_view name, std::size_t which,
                                          const Insteads& insteads) const {
    for (const LoopVariable& one : loop_.variables) {
        if (one.name != name)
            continue;
        if (!one.counts())
            return number(one.each[which], insteads);
        const auto start = number(*one.start, insteads);
        const auto step = one.step ? number(*one.step, insteads) : TclNumber{1, true};
        if (!start || !step)
            return std::nullopt;
        return TclNumber{start->value + static_cast<double>(which) * step->value,
                         start->integer && step->integer};
    }
    return std::nullopt;
}

// Two sides and what compares them, as conditions of loops are.
std::optional<bool> Rounds::condition(std::size_t which, const Insteads& insteads) const {
    const std::string text = origins_.slice(loop_.condition);
    const std::size_t op = text.find_first_of("<>=!");
    if (op == std::string::npos)
        return std::nullopt;
    const bool two = op + 1 < text.size() && text[op + 1] == '=';
    const std::size_t from = loop_.condition.from;
    const TclNames names{[&](std::string_view name) { return variable(name, which, insteads); },
                         {}};
    const auto left = tclValue(origins_.text(), {from, from + op}, names);
    const auto right =
        tclValue(origins_.text(), {from + op + (two ? 2 : 1), loop_.condition.to}, names);
    if (!left || !right || (!two && (text[op] == '=' || text[op] == '!')))
        return std::nullopt;
    const double a = left->value, b = right->value;
    switch (text[op]) {
    case '<':
        return two ? a <= b : a < b;
    case '>':
        return two ? a >= b : a > b;
    default:
        return (a == b) == (text[op] == '=');
    }
}

bool Rounds::goesAround(std::size_t times, const Insteads& insteads) const {
    for (std::size_t i = 0; i < times; ++i)
        if (condition(i, insteads) != true)
            return false;
    return condition(times, insteads) == false;
}

// ---------------------------------------------------------------------------------------------

// A number of the option, as it is worked out for each element: one that stands there, a variable,
// or [expr {...}].
class Component {
public:
    Component(const Rounds& rounds, const Origin& origin)
        : rounds_(rounds), plain_(origin.reason.empty()),
          expression_(plain_ ? origin.literal : inner(origin.place)) {}

    // It stands there as it is, the same for all.
    [[nodiscard]] bool plain() const { return plain_; }
    [[nodiscard]] std::optional<double> value(std::size_t which, const Insteads& insteads) const;
    // The numbers that it depends on, for that element.
    [[nodiscard]] std::vector<Range> literals(std::size_t which) const;
    // A variable that a `for` counts has whole numbers only.
    [[nodiscard]] bool isWhole(Range literal) const;

private:
    [[nodiscard]] std::optional<Range> inner(Range written) const;

    const Rounds& rounds_;
    bool plain_;
    std::optional<Range> expression_; // none: put together otherwise
};

// Of [expr {...}] what stands in it; else a variable alone. "-$x" is no number for each x.
std::optional<Range> Component::inner(Range written) const {
    const Origins& origins = rounds_.origins();
    const std::string text = origins.slice(written);
    if (variableIn(text))
        return written;
    constexpr std::string_view head = "[expr ";
    if (!text.starts_with(head) || !text.ends_with(']'))
        return std::nullopt;
    Range range = {written.from + head.size(), written.to - 1};
    const auto isBlank = [&](std::size_t at) { return origins.text()[at] == ' '; };
    while (range.from < range.to && isBlank(range.from))
        ++range.from;
    while (range.to > range.from && isBlank(range.to - 1))
        --range.to;
    if (range.to - range.from >= 2 && origins.text()[range.from] == '{' &&
        origins.text()[range.to - 1] == '}')
        return Range{range.from + 1, range.to - 1};
    return range;
}

std::optional<double> Component::value(std::size_t which, const Insteads& insteads) const {
    if (!expression_)
        return std::nullopt;
    const auto at = [&](Range literal) { return given(insteads, literal); };
    const auto value = plain_ ? rounds_.number(*expression_, insteads)
                              : tclValue(rounds_.origins().text(), *expression_,
                                         {[&](std::string_view name) {
                                              return rounds_.variable(name, which, insteads);
                                          },
                                          at});
    return value ? std::optional(value->value) : std::nullopt;
}

std::vector<Range> Component::literals(std::size_t which) const {
    if (plain_)
        return {*expression_}; // with its sign
    std::vector<Range> all = tclLiterals(rounds_.origins().text(), *expression_);
    for (const LoopVariable& one : rounds_.loop().variables) {
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
    return std::ranges::any_of(rounds_.loop().variables, [&](const LoopVariable& one) {
        return one.counts() && one.step == literal;
    });
}

// ---------------------------------------------------------------------------------------------

enum class Effect { own, alike, step }; // on the others: none, as much, each by its place

struct Way { // to the value that is wanted
    Effect effect = Effect::own;
    text::Edit edit;
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
    const auto here = component_.value(which, {{literal, {old->value, false}}});
    const auto there = component_.value(which, {{literal, {old->value + 1, false}}});
    return here && there ? std::optional(*there - *here) : std::nullopt;
}

// Newton's method from the number as it is, exact at once where it enters linearly; where it
// divides, steps are kept short of the pole.
std::optional<double> Ways::solved(Range literal, double wanted) const {
    const auto at = [&](double x) {
        return component_.value(making_.which, {{literal, {x, false}}});
    };
    double x = tclNumber(origins_.slice(literal))->value;
    for (int i = 0; i < 60; ++i) {
        const double h = 1e-5 * std::max(1.0, std::abs(x));
        const auto here = at(x), after = at(x + h), before = at(x - h);
        if (!here || !after || !before || *after == *before)
            return std::nullopt;
        const double step = (wanted - *here) * 2 * h / (*after - *before);
        if (std::abs(step) <= 1e-12 * std::max(1.0, std::abs(x)))
            return x + step;
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
    way.ofLoop = component_.isWhole(literal);
    if (way.ofLoop)
        value = std::round(value);
    if (way.ofLoop && value == old)
        return std::nullopt;
    // What is typed exactly is reached up to rounding, which is nothing to write down.
    const double least = 1e-11 * std::max({1.0, std::abs(old), std::abs(value)});
    value = std::abs(value) < least ? 0 : value;
    way.edit = {{literal.from, literal.to},
                numberText(value, way.ofLoop ? 1 : std::max(resolution, least), way.before)};
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

struct Changing { // a number that is to change
    bool plain = false;
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
        const auto twice = text::startingAt(offer.edits, way->edit.range.from);
        if (twice == offer.edits.end())
            offer.edits.push_back(way->edit);
        else if (twice->text != way->edit.text)
            return std::nullopt;
    }
    if (!told)
        return std::nullopt;
    text::putInOrder(offer.edits);
    const std::string who = making.name.empty() ? "this one" : making.name;
    offer.label = effect == Effect::own ? "Only " + who + ", in " + loop.place
                  : effect == Effect::alike
                      ? "All " + std::to_string(making.together) + ", by as much"
                      : (told->ofLoop ? "The step of the loop: " : "The step: ") + told->before +
                            " becomes " + told->edit.text;
    return offer;
}

// ---------------------------------------------------------------------------------------------

// Whether what an offer says is what the text would then be: as many elements, with their names,
// each with the value that is meant, and nothing else changed.
class Promise {
public:
    Promise(const Making& making, const Wish& wish, const Rounds& rounds,
            const std::vector<Component>& components, const std::vector<Origin>& from, Range word)
        : making_(making), wish_(wish), rounds_(rounds), components_(components), from_(from),
          word_(word) {}

    // What is worked out here is what the scene has, for each that the command made.
    [[nodiscard]] bool isUnderstood() const;
    [[nodiscard]] bool isKept(const Offer& offer, Effect effect) const;

private:
    [[nodiscard]] bool changesNothingElse(Range literal, const Insteads& insteads) const;
    [[nodiscard]] bool isMet(std::size_t component, const Insteads& insteads) const;

    const Making& making_;
    const Wish& wish_;
    const Rounds& rounds_;
    const std::vector<Component>& components_;
    const std::vector<Origin>& from_;
    Range word_;
};

bool near(double a, double b) {
    return std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

bool Promise::isUnderstood() const {
    const scene::Scene& scene = rounds_.origins().scene();
    std::size_t which = 0;
    for (std::size_t i = 0;; ++i) {
        const Element element{wish_.element.kind, i};
        const scene::Source* source = sourceOf(scene, element);
        if (!source)
            break;
        if (!(source->command == making_.source.command))
            continue;
        const auto is = valuesOf(scene, element, wish_.option);
        if (!is || is->size() != components_.size() || which == making_.together)
            return false;
        for (std::size_t k = 0; k < components_.size(); ++k)
            if (const auto worked = components_[k].value(which, {});
                !worked || !near(*worked, (*is)[k]))
                return false;
        ++which;
    }
    return which == making_.together;
}

bool Promise::changesNothingElse(Range literal, const Insteads& insteads) const {
    const Origins& origins = rounds_.origins();
    for (const LoopVariable& one : rounds_.loop().variables) {
        if (one.step == literal && !rounds_.goesAround(making_.together, insteads))
            return false;
        const bool isIts =
            one.step == literal || std::ranges::find(one.each, literal) != one.each.end();
        if (isIts && readElsewhere(one, rounds_.loop(), word_, origins))
            return false;
    }
    const double value = given(insteads, literal)->value;
    return std::ranges::all_of(from_, [&](const Origin& origin) {
        return !(origin.literal == literal) ||
               (isOnlyIn(word_, from_, origin, origins) && mayBecome(origin, value, origins));
    });
}

bool Promise::isMet(std::size_t component, const Insteads& insteads) const {
    const double wanted = wish_.values[component];
    const auto reached = components_[component].value(making_.which, insteads);
    double close = std::max(wish_.resolution, 1e-9 * std::max(1.0, std::abs(wanted)));
    // A `for` counts in whole numbers: as near as they come.
    Insteads next = insteads;
    for (Instead& one : next)
        one.value.value += components_[component].isWhole(one.literal) ? 1 : 0;
    if (const auto after = components_[component].value(making_.which, next); after && reached)
        close += 0.5 * std::abs(*after - *reached);
    return reached && std::abs(*reached - wanted) <= close;
}

bool Promise::isKept(const Offer& offer, Effect effect) const {
    Insteads insteads;
    for (const text::Edit& edit : offer.edits) {
        const auto number = tclNumber(edit.text);
        if (!number)
            return false;
        insteads.push_back({{edit.range.from, edit.range.to}, *number});
    }
    if (!std::ranges::all_of(insteads, [&](const Instead& one) {
            return changesNothingElse(one.literal, insteads);
        }))
        return false;
    for (std::size_t k = 0; k < components_.size(); ++k) {
        const Component& component = components_[k];
        if (!isMet(k, insteads))
            return false;
        const double shift =
            *component.value(making_.which, insteads) - *component.value(making_.which, {});
        for (std::size_t other = 0; other < making_.together; ++other) {
            const auto is = component.value(other, insteads);
            const double was = *component.value(other, {});
            const bool asSaid = effect == Effect::step ||
                                (is && near(*is, was + (effect == Effect::own ? 0 : shift)));
            if (!is || (other != making_.which && !asSaid))
                return false;
        }
    }
    return true;
}

} // namespace

std::vector<Offer> loopOffers(const Making& making, const Wish& wish, const Origins& origins) {
    const Word* word = wordOf(making.command, making.source, wish.option);
    const auto loop = loopOf(making, origins);
    if (!word || !loop || making.together < 2 || !wish.path.empty())
        return {};
    std::vector<Origin> from = wish.values.size() == 1
                                   ? std::vector<Origin>{origins.ofScalar(making.command, *word)}
                                   : origins.ofList(making.command, *word, {});
    if (from.size() != wish.values.size())
        return {};
    if (wish.values.size() == 1 && !from.front().reason.empty())
        from.front().place = word->braced ? Range() : word->content;
    const Rounds rounds(*loop, origins);
    std::vector<Component> components;
    components.reserve(from.size());
    for (const Origin& origin : from)
        components.emplace_back(rounds, origin);
    const Promise promise(making, wish, rounds, components, from, word->range);
    if (!promise.isUnderstood())
        return {};
    std::vector<Changing> all;
    for (std::size_t i = 0; i < components.size(); ++i)
        if (std::abs(*components[i].value(making.which, {}) - wish.values[i]) >
            0.5 * wish.resolution)
            all.push_back(
                {components[i].plain(),
                 Ways(making, components[i], origins, wish.resolution).to(wish.values[i])});
    std::vector<Offer> offers;
    for (const Effect effect : {Effect::own, Effect::step, Effect::alike})
        if (auto offer = offerBy(effect, all, making, *loop);
            offer && promise.isKept(*offer, effect))
            offers.push_back(std::move(*offer));
    return offers;
}

} // namespace editing
