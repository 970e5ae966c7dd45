#include "editing/overrides.h"

#include "editing/element_values.h"
#include "editing/loop_values.h"
#include "editing/number_text.h"
#include "editing/variable_uses.h"
#include "script/numbers.h"

#include <algorithm>
#include <cmath>

namespace editing {

using script::Command;
using script::Word;

namespace {

std::string asList(const std::vector<double>& values, double resolution) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : " ") + numberText(value, resolution);
    return values.size() == 1 ? text : "{" + text + "}";
}

// A word as an operand of Tcl's expr: what it was, as a text.
std::string operand(const Word& word, const Origins& origins) {
    std::string text = origins.slice(word.range);
    if (word.braced || word.quoted || text.front() == '[' || variableIn(text))
        return text;
    return script::decimalNumber(text) ? text : "\"" + text + "\"";
}

// The name is asked for again, and what stands there now not always.
bool canBeAskedAgain(const Making& making, const Origins& origins) {
    return making.name.find_first_of("\"$[]{}\\") == std::string::npos &&
           std::ranges::all_of(making.command.words,
                               [&](const Word& word) { return isPure(word.range, origins); });
}

// [expr {"b$i" eq "b3" ? {12 0 0} : "$i 0 0"}] in place of "$i 0 0".
std::optional<Offer> onlyThis(const Making& making, const Wish& wish, const Origins& origins) {
    const Word* name = wordOf(making.command, making.source, "");
    if (making.name.empty() || !name || name->literal || !wish.path.empty() ||
        !canBeAskedAgain(making, origins))
        return std::nullopt;
    const std::string test = operand(*name, origins) + " eq \"" + making.name + "\" ? " +
                             asList(wish.values, wish.resolution);
    Offer offer;
    offer.label = "Only " + making.name;
    if (const Word* word = wordOf(making.command, making.source, wish.option)) {
        offer.edits.push_back({word->range.from, word->range.to,
                               "[expr {" + test + " : " + operand(*word, origins) + "}]"});
    } else if (wish.absent.size() == wish.values.size()) {
        const std::size_t end = making.command.range.to;
        offer.edits.push_back(
            {end, end,
             " " + wish.option + " [expr {" + test + " : " + asList(wish.absent, 0) + "}]"});
    } else {
        return std::nullopt;
    }
    return offer;
}

// The numbers of the command's own text become others: for all that it makes.
std::optional<Offer> allOfThem(const Making& making, const Wish& wish, const Origins& origins) {
    const Word* word = wordOf(making.command, making.source, wish.option);
    if (!word)
        return std::nullopt;
    const std::vector<Origin> from =
        wish.values.size() == 1 && wish.path.empty()
            ? std::vector<Origin>{origins.ofScalar(making.command, *word)}
            : origins.ofList(making.command, *word, wish.path);
    if (from.size() < wish.values.size())
        return std::nullopt;
    const auto now = wish.now.empty() && wish.path.empty()
                         ? valuesOf(origins.scene(), wish.element, wish.option)
                         : std::optional(wish.now);
    const auto stays = [&](std::size_t i) {
        return now && i < now->size() &&
               std::abs((*now)[i] - wish.values[i]) <= 0.5 * wish.resolution;
    };
    Offer offer;
    bool whole = true;
    for (std::size_t i = 0; i < wish.values.size(); ++i) {
        if (!from[i].reason.empty()) { // what differs from one to the next stays
            whole = whole && stays(i);
            continue;
        }
        const std::string before = origins.slice(from[i].literal);
        const auto old = script::decimalNumber(before);
        if (!old || std::abs(*old - wish.values[i]) <= 0.5 * wish.resolution)
            continue;
        // Of all, and of nothing else; and one number in two places cannot become two.
        if (!isOnlyIn(word->range, from, from[i], origins) ||
            !mayBecome(from[i], wish.values[i], origins) ||
            !text::join(offer.edits, {{from[i].literal.from, from[i].literal.to},
                                      numberText(wish.values[i], wish.resolution, before)}))
            return std::nullopt;
    }
    // Another of the numbers comes from the same one, and is to stay.
    const auto isKept = [&](const text::Edit& edit) {
        bool kept = false;
        for (std::size_t i = 0; i < wish.values.size(); ++i)
            kept = kept ||
                   (from[i].literal.known() && from[i].literal.from == edit.range.from && stays(i));
        return kept;
    };
    if (offer.edits.empty() || std::ranges::any_of(offer.edits, isKept))
        return std::nullopt;
    offer.label =
        "All " + std::to_string(making.together) + (whole ? "" : ", only the numbers in common");
    text::putInOrder(offer.edits);
    return offer;
}

} // namespace

const Word* wordOf(const Command& command, const scene::Source& source, const std::string& option) {
    for (const scene::Argument& argument : source.arguments)
        for (const Word& word : command.words)
            if (argument.option == option && word.range == argument.word && !word.expanded)
                return &word;
    return nullptr;
}

std::vector<Offer> offersFor(const Making& making, const Wish& wish, const Origins& origins) {
    std::vector<Offer> offers;
    if (auto offer = onlyThis(making, wish, origins))
        offers.push_back(std::move(*offer));
    if (auto offer = allOfThem(making, wish, origins))
        offers.push_back(std::move(*offer));
    for (Offer& offer : loopOffers(making, wish, origins))
        offers.push_back(std::move(offer));
    return offers;
}

} // namespace editing
