#include "editing/origin.h"

#include "script/numbers.h"

#include <algorithm>
#include <array>

namespace editing {

using script::Command;
using script::Word;

namespace {

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == ':';
}

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Commands that give variables values, other than `set`; the words of all of them may name one.
constexpr std::array writers = {"append", "array",   "catch",   "dict",  "foreach", "global",
                                "incr",   "lappend", "lassign", "lmap",  "lset",    "regexp",
                                "regsub", "scan",    "unset",   "upvar", "variable"};
constexpr std::array loops = {"foreach", "for", "while", "lmap"};

template <std::size_t N>
bool isOneOf(std::string_view name, const std::array<const char*, N>& names) {
    return std::ranges::find(names, name) != names.end();
}

} // namespace

std::optional<std::string> variableIn(std::string_view text) {
    if (text.size() < 2 || text.front() != '$')
        return std::nullopt;
    std::string_view name = text.substr(1);
    if (name.front() == '{') {
        if (name.size() < 3 || name.find('}') != name.size() - 1)
            return std::nullopt;
        return std::string(name.substr(1, name.size() - 2));
    }
    return std::ranges::all_of(name, isNameCharacter) ? std::optional(std::string(name))
                                                      : std::nullopt;
}

std::string Origins::slice(scene::Range range) const {
    return std::string(text_.substr(range.from, range.to - range.from));
}

int Origins::lineOf(std::size_t offset) const {
    return 1 + static_cast<int>(std::count(
                   text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

Origin Origins::refused(const std::string& reason, scene::Range cause) const {
    Origin origin;
    origin.reason = reason;
    origin.cause = cause;
    return origin;
}

const Command* Origins::procedureOf(const Command& command) const {
    const Command* at = &command;
    while (at->parent >= 0) {
        at = &structure_.commands[static_cast<std::size_t>(at->parent)];
        if (at->name(text_) == "proc")
            return at;
    }
    return nullptr;
}

const Command* Origins::makerOf(const Command& command) const {
    const Command* at = &command;
    while (at->parent >= 0) {
        at = &structure_.commands[static_cast<std::size_t>(at->parent)];
        if (at->name(text_) == "proc" || isOneOf(at->name(text_), loops))
            return at;
    }
    return nullptr;
}

const Command* Origins::substitutionAt(scene::Range word) const {
    if (word.to < word.from + 3 || text_[word.from] != '[' || text_[word.to - 1] != ']')
        return nullptr;
    for (const Command& command : structure_.commands)
        if (command.substituted && command.range.from > word.from && command.range.to < word.to) {
            // Nothing but blanks between the brackets and this one command.
            const auto blank = [&](std::size_t from, std::size_t to) {
                return std::all_of(text_.begin() + static_cast<std::ptrdiff_t>(from),
                                   text_.begin() + static_cast<std::ptrdiff_t>(to), isBlank);
            };
            return blank(word.from + 1, command.range.from) && blank(command.range.to, word.to - 1)
                       ? &command
                       : nullptr;
        }
    return nullptr;
}

// ---------------------------------------------------------------------------------------------

std::vector<Origin> Origins::inLiteral(scene::Range content,
                                       const std::vector<std::size_t>& path) const {
    for (const std::size_t index : path) {
        const auto list = script::elementsOf(text_.substr(content.from, content.to - content.from));
        if (!list.fault.empty() || index >= list.elements.size())
            return {};
        const scene::Range inner = list.elements[index].content;
        content = {content.from + inner.from, content.from + inner.to};
    }
    const auto list = script::elementsOf(text_.substr(content.from, content.to - content.from));
    if (!list.fault.empty())
        return {};
    std::vector<Origin> origins;
    for (const script::Element& element : list.elements) {
        const scene::Range place = {content.from + element.content.from,
                                    content.from + element.content.to};
        if (element.literal && script::decimalNumber(element.value))
            origins.push_back({.literal = place, .reason = "", .cause = {}, .variable = ""});
        else
            origins.push_back(refused("is not written as a number", place));
    }
    return origins;
}

// Words of "..." between blanks: numbers and variables, each on its own.
std::vector<Origin> Origins::inQuotes(const Command& command, scene::Range content) const {
    std::vector<Origin> origins;
    std::size_t at = content.from;
    while (at < content.to) {
        if (isBlank(text_[at])) {
            ++at;
            continue;
        }
        std::size_t end = at;
        int depth = 0;
        while (end < content.to && (depth > 0 || !isBlank(text_[end]))) {
            depth += text_[end] == '[' ? 1 : text_[end] == ']' ? -1 : 0;
            ++end;
        }
        const scene::Range place = {at, end};
        const std::string piece = slice(place);
        if (script::decimalNumber(piece))
            origins.push_back({.literal = place, .reason = "", .cause = {}, .variable = ""});
        else if (const auto name = variableIn(piece))
            origins.push_back(ofVariable(command, *name, place));
        else
            origins.push_back(refused("is computed by " + piece, place));
        origins.back().place = place;
        at = end;
    }
    return origins;
}

std::vector<Origin> Origins::inListCommand(const Command& list) const {
    std::vector<Origin> origins;
    for (std::size_t i = 1; i < list.words.size(); ++i) {
        origins.push_back(ofScalar(list, list.words[i]));
        origins.back().place = list.words[i].range;
    }
    return origins;
}

std::vector<Origin> Origins::ofList(const Command& command, const Word& word,
                                    const std::vector<std::size_t>& path) const {
    if (word.expanded)
        return {refused("is computed by " + slice(word.range), word.range)};
    if (word.literal)
        return inLiteral(word.content, path);
    const std::string content = slice(word.content);
    if (const auto name = word.braced ? std::nullopt : variableIn(content))
        return ofListVariable(command, *name, word.range, path);
    if (!path.empty())
        return {refused("is computed by " + slice(word.range), word.range)};
    if (const Command* inner = substitutionAt(word.range); inner && inner->name(text_) == "list")
        return inListCommand(*inner);
    if (word.quoted)
        return inQuotes(command, word.content);
    return {refused("is computed by " + slice(word.range), word.range)};
}

Origin Origins::ofScalar(const Command& command, const Word& word) const {
    const std::string content = slice(word.content);
    if (word.literal && !word.expanded) {
        if (script::decimalNumber(content))
            return {.literal = word.content, .reason = "", .cause = {}, .variable = ""};
        return refused("is not written as a number", word.range);
    }
    if (const auto name = word.braced || word.expanded ? std::nullopt : variableIn(content))
        return ofVariable(command, *name, word.range);
    return refused("is computed by " + slice(word.range), word.range);
}

Origins::Literal Origins::literalOf(const Command& command, const Word& word) const {
    if (word.literal && !word.expanded)
        return {word.content, "", {}};
    const std::string content = slice(word.content);
    const auto name = word.braced || word.expanded ? std::nullopt : variableIn(content);
    if (!name)
        return {{}, "is computed by " + slice(word.range), word.range};
    const Definition definition = definitionOf(command, *name, word.range);
    if (!definition.value)
        return {{}, definition.reason, definition.cause};
    if (!definition.value->literal)
        return {{},
                "comes from $" + *name + ", which is computed in line " +
                    std::to_string(lineOf(definition.value->range.from)),
                definition.value->range};
    return {definition.value->content, "", {}};
}

// ---------------------------------------------------------------------------------------------

bool Origins::writes(const Command& command, const std::string& name) const {
    const std::string_view called = command.name(text_);
    if (called == "set")
        return command.words.size() == 3 && slice(command.words[1].content) == name;
    if (!isOneOf(called, writers))
        return false;
    return std::any_of(command.words.begin() + 1, command.words.end(), [&](const Word& word) {
        if (!word.literal || word.content.to - word.content.from > 200)
            return false;
        const auto list = script::elementsOf(slice(word.content));
        return std::ranges::any_of(list.elements,
                                   [&](const script::Element& e) { return e.value == name; });
    });
}

Origins::Definition Origins::definitionOf(const Command& reader, const std::string& name,
                                          scene::Range where) const {
    const Command* scope = procedureOf(reader);
    const Command* definition = nullptr;
    for (const Command& command : structure_.commands) {
        if (!writes(command, name) || procedureOf(command) != scope)
            continue;
        const std::string called(command.name(text_));
        if (called != "set")
            return {nullptr,
                    "comes from $" + name + ", which the " + called + " of line " +
                        std::to_string(lineOf(command.range.from)) + " changes",
                    command.words.front().range};
        if (definition)
            return {nullptr,
                    "comes from $" + name + ", which is set in line " +
                        std::to_string(lineOf(definition->range.from)) + " and again in line " +
                        std::to_string(lineOf(command.range.from)),
                    command.range};
        definition = &command;
    }
    if (definition)
        return {&definition->words[2], "", definition->range};
    if (scope)
        return {nullptr,
                "comes from $" + name + ", which is given to the procedure of line " +
                    std::to_string(lineOf(scope->range.from)),
                where};
    for (const scene::Parameter& parameter : scene_.parameters) {
        if (parameter.name != name)
            continue;
        const Command* command = structure_.startingAt(parameter.source.command.from);
        for (const scene::Argument& argument : parameter.source.arguments)
            if (command && argument.option == "-value")
                for (const Word& word : command->words)
                    if (word.range == argument.word)
                        return {&word, "", word.range};
        return {nullptr, "comes from the parameter " + name + ", which gives no value of its own",
                parameter.source.command};
    }
    return {nullptr, "comes from $" + name + ", which is set where the text does not show", where};
}

Origin Origins::ofVariable(const Command& reader, const std::string& name,
                           scene::Range where) const {
    const Definition definition = definitionOf(reader, name, where);
    if (!definition.value)
        return refused(definition.reason, definition.cause);
    const std::string content = slice(definition.value->content);
    if (!definition.value->literal || !script::decimalNumber(content))
        return refused("comes from $" + name + ", which is " +
                           (definition.value->literal ? "no number" : "computed") + " in line " +
                           std::to_string(lineOf(definition.value->range.from)),
                       definition.value->range);
    return {.literal = definition.value->content, .reason = "", .cause = {}, .variable = name};
}

std::vector<Origin> Origins::ofListVariable(const Command& reader, const std::string& name,
                                            scene::Range where,
                                            const std::vector<std::size_t>& path) const {
    const Definition definition = definitionOf(reader, name, where);
    if (!definition.value)
        return {refused(definition.reason, definition.cause)};
    if (!definition.value->literal)
        return {refused("comes from $" + name + ", which is computed in line " +
                            std::to_string(lineOf(definition.value->range.from)),
                        definition.value->range)};
    std::vector<Origin> origins = inLiteral(definition.value->content, path);
    for (Origin& origin : origins)
        origin.variable = name;
    return origins;
}

} // namespace editing
