#include "editing/loop_reading.h"

#include "editing/variable_uses.h"

#include <algorithm>

namespace editing {

using scene::Range;
using script::Command;
using script::Structure;
using script::Word;

namespace {

bool isWithin(Range inner, Range outer) { return inner.from >= outer.from && inner.to <= outer.to; }

class LoopSearch {
public:
    LoopSearch(const Making& making, const Origins& origins)
        : making_(making), origins_(origins), structure_(origins.structure()) {}

    [[nodiscard]] std::optional<Loop> loop() const;

private:
    [[nodiscard]] std::optional<Loop> ofForeach(const Command& loop) const;
    [[nodiscard]] std::optional<Loop> ofFor(const Command& loop) const;
    [[nodiscard]] std::optional<Loop> ofProcedure(const Command& definition) const;
    [[nodiscard]] const Command* only(const Word& word, std::string_view name) const;
    [[nodiscard]] bool isPlain(const Loop& loop) const;

    const Making& making_;
    const Origins& origins_;
    const Structure& structure_;
};

std::optional<Loop> LoopSearch::loop() const {
    const Command* maker = origins_.makerOf(making_.command);
    // The command runs once for each round: nothing stands between it and the loop.
    if (!maker || maker->parent >= 0 ||
        &structure_.commands[static_cast<std::size_t>(making_.command.parent)] != maker)
        return std::nullopt;
    const std::string name = origins_.slice(maker->words.front().content);
    std::optional<Loop> loop = name == "foreach" ? ofForeach(*maker)
                               : name == "for"   ? ofFor(*maker)
                               : name == "proc"  ? ofProcedure(*maker)
                                                 : std::nullopt;
    if (loop)
        loop->range = maker->range;
    return loop && isPlain(*loop) ? loop : std::nullopt;
}

// The variables have the values that the loop gives them.
bool LoopSearch::isPlain(const Loop& loop) const {
    if (hidesUses({0, origins_.text().size()}, origins_)) // a procedure's body, too
        return false;
    return std::ranges::none_of(structure_.commands, [&](const Command& command) {
        const bool inHead = std::ranges::any_of(
            loop.head, [&](Range head) { return isWithin(command.range, head); });
        return isWithin(command.range, loop.range) && !(command.range == loop.range) && !inHead &&
               std::ranges::any_of(loop.variables, [&](const LoopVariable& one) {
                   return origins_.writes(command, one.name);
               });
    });
}

std::optional<Loop> LoopSearch::ofForeach(const Command& loop) const {
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
    result.head = {loop.words[1].range, loop.words[2].range};
    for (std::size_t i = 0; i < count; ++i) {
        LoopVariable variable{names.elements[i].value};
        variable.listVariable = variableIn(origins_.slice(loop.words[2].content));
        for (std::size_t k = i; k < values.elements.size(); k += count)
            variable.each.push_back({list.content.from + values.elements[k].content.from,
                                     list.content.from + values.elements[k].content.to});
        result.variables.push_back(std::move(variable));
    }
    return result;
}

// The one command in a word.
const Command* LoopSearch::only(const Word& word, std::string_view name) const {
    const Command* found = nullptr;
    for (const Command& command : structure_.commands)
        if (isWithin(command.range, word.content)) {
            if (found)
                return nullptr;
            found = &command;
        }
    return found && origins_.slice(found->words.front().content) == name ? found : nullptr;
}

std::optional<Loop> LoopSearch::ofFor(const Command& loop) const {
    if (loop.words.size() != 5)
        return std::nullopt;
    const Command* start = only(loop.words[1], "set");
    const Command* next = only(loop.words[3], "incr");
    if (!start || start->words.size() != 3 || !start->words[2].literal || !next ||
        next->words.size() < 2 || next->words.size() > 3)
        return std::nullopt;
    LoopVariable variable{origins_.slice(start->words[1].content)};
    variable.start = start->words[2].content;
    if (origins_.slice(next->words[1].content) != variable.name)
        return std::nullopt;
    if (next->words.size() == 3) {
        if (!next->words[2].literal)
            return std::nullopt;
        variable.step = next->words[2].content;
    }
    Loop result{{std::move(variable)}, ""};
    result.head = {loop.words[1].range, loop.words[2].range, loop.words[3].range};
    result.condition = loop.words[2].content;
    return result;
}

// Its calls, each at the top of the script, with words that are what they stand for.
std::optional<Loop> LoopSearch::ofProcedure(const Command& definition) const {
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
    loop.head = {definition.words[2].range};
    for (std::size_t i = 0; i < names.elements.size(); ++i) {
        LoopVariable variable{names.elements[i].value};
        for (const Command* call : calls) {
            if (call->words.size() <= i + 1 || !call->words[i + 1].literal)
                return std::nullopt;
            variable.each.push_back(call->words[i + 1].content);
        }
        loop.variables.push_back(std::move(variable));
    }
    return loop;
}

// Whether the command, at the top of the script, gives the variable a value of its own before what
// stands at that place of it can read the loop's.
bool givesAnother(const Command& command, std::size_t at, const std::string& name,
                  const Origins& origins) {
    const std::string_view called = command.name(origins.text());
    const auto holds = [at](const Word& word) {
        return word.range.from <= at && at < word.range.to;
    };
    if (called == "proc")
        return true;
    if (called == "set")
        return origins.writes(command, name) && holds(command.words[1]);
    if (called == "foreach")
        return command.words.size() == 4 && origins.writes(command, name) &&
               !holds(command.words[2]);
    return called == "for" && command.words.size() == 5 &&
           std::ranges::any_of(origins.structure().commands, [&](const Command& start) {
               return isWithin(start.range, command.words[1].content) &&
                      start.name(origins.text()) == "set" && origins.writes(start, name);
           });
}

// Behind the loop the variable has its last value, unless another loop gives it its own.
bool isReadBehind(const LoopVariable& variable, const Loop& loop, const Origins& origins) {
    const Range behind = {loop.range.to, origins.text().size()};
    return std::ranges::any_of(usesOf(variable.name, behind, origins), [&](std::size_t at) {
        const Command* command = origins.structure().at(at);
        while (command && command->parent >= 0)
            command = &origins.structure().commands[static_cast<std::size_t>(command->parent)];
        return !command || !givesAnother(*command, at, variable.name, origins);
    });
}

// A procedure that takes the variable of the script for its own.
bool isTakenByProcedures(const std::string& name, const Origins& origins) {
    const Range all = {0, origins.text().size()};
    return std::ranges::any_of(usesOf(name, all, origins), [&](std::size_t at) {
        const Command* command = origins.structure().at(at);
        const bool qualified = at >= 2 && origins.text().substr(at - 2, 2) == "::";
        const std::string_view called = command ? command->name(origins.text()) : "";
        return qualified || called == "global" || called == "variable" || called == "upvar";
    });
}

} // namespace

std::optional<Loop> loopOf(const Making& making, const Origins& origins) {
    return LoopSearch(making, origins).loop();
}

bool readElsewhere(const LoopVariable& variable, const Loop& loop, Range word,
                   const Origins& origins) {
    std::vector<Range> except = loop.head;
    except.push_back(word);
    if (isUsedIn(variable.name, loop.range, except, origins))
        return true;
    if (variable.listVariable) {
        // Its one `set`, and the word of the loop.
        std::vector<Range> known = loop.head;
        for (const Command& command : origins.structure().commands)
            if (origins.writes(command, *variable.listVariable) && command.words.size() == 3)
                known.push_back(command.words[1].range);
        if (isUsedIn(*variable.listVariable, {0, origins.text().size()}, known, origins))
            return true;
    }
    const std::string_view text = origins.text();
    if (text.substr(loop.range.from, 4) == "proc") // its variables are its own
        return false;
    return isReadBehind(variable, loop, origins) || isTakenByProcedures(variable.name, origins);
}

} // namespace editing
