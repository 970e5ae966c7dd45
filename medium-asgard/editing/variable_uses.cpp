#include "editing/variable_uses.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace editing {

using scene::Range;

namespace {

bool isPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

bool holds(Range range, std::size_t at) { return range.from <= at && at < range.to; }

// "-x" as a word of its own; in an expression it is the variable, or a parameter.
bool isOption(std::size_t at, std::size_t end, const Origins& origins) {
    const script::Command* command = origins.structure().at(at);
    return at > 0 && command && std::ranges::any_of(command->words, [&](const script::Word& word) {
               return !word.braced && word.content == Range{at - 1, end} &&
                      origins.text()[at - 1] == '-';
           });
}

// Scripts that are put together, and variables under other names.
constexpr std::array hiding = {"eval",      "uplevel", "upvar", "subst",  "apply",
                               "namespace", "after",   "trace", "rename", "source"};

} // namespace

std::vector<std::size_t> usesOf(const std::string& name, Range where, const Origins& origins) {
    const std::string_view text = origins.text();
    std::vector<std::size_t> uses;
    for (std::size_t at = text.find(name, where.from); at < where.to && !name.empty();
         at = text.find(name, at + 1)) {
        const std::size_t end = at + name.size();
        const bool whole =
            (at == 0 || !isPart(text[at - 1])) && (end == text.size() || !isPart(text[end]));
        const auto& comments = origins.structure().comments;
        if (whole && !isOption(at, end, origins) &&
            std::ranges::none_of(comments, [&](Range one) { return holds(one, at); }))
            uses.push_back(at);
    }
    return uses;
}

bool isUsedIn(const std::string& name, Range where, const std::vector<Range>& except,
              const Origins& origins) {
    return std::ranges::any_of(usesOf(name, where, origins), [&](std::size_t at) {
        return std::ranges::none_of(except, [&](Range one) { return holds(one, at); });
    });
}

bool hidesUses(Range where, const Origins& origins) {
    return std::ranges::any_of(origins.structure().commands, [&](const script::Command& command) {
        if (command.range.from < where.from || command.range.to > where.to)
            return false;
        const std::string_view called = command.name(origins.text());
        return called.empty() || std::ranges::find(hiding, called) != hiding.end();
    });
}

bool isOnlyIn(Range word, const std::vector<Origin>& all, const Origin& origin,
              const Origins& origins) {
    if (origin.variable.empty())
        return true;
    const script::Structure& structure = origins.structure();
    std::vector<Range> except;
    for (const Origin& one : all)
        if (one.literal == origin.literal)
            except.push_back(one.place.known() ? one.place : word);
    // The command that gives it the number.
    for (const script::Command& command : structure.commands)
        if (command.range.from <= origin.literal.from && origin.literal.to <= command.range.to &&
            command.words.size() > 1 && origins.slice(command.words[1].content) == origin.variable)
            except.push_back(command.range);
    const Range whole = {0, origins.text().size()};
    return !hidesUses(whole, origins) && !isUsedIn(origin.variable, whole, except, origins);
}

bool mayBecome(const Origin& origin, double value, const Origins& origins) {
    const auto& parameters = origins.scene().parameters;
    const auto found = std::ranges::find(parameters, origin.variable, &scene::Parameter::name);
    return found == parameters.end() || origin.variable.empty() ||
           (value >= found->minimum.value_or(value) && value <= found->maximum.value_or(value));
}

namespace {

constexpr std::array pure = {"expr",   "format", "list",   "lindex", "llength",
                             "lrange", "join",   "concat", "string", "split"};
// What a procedure's variables of its own may be computed by.
constexpr std::array ownOnly = {"set",   "incr",     "append", "lappend", "if",
                                "for",   "foreach",  "while",  "switch",  "return",
                                "break", "continue", "else"};

// The commands of a text, `within` a procedure or not.
bool arePure(Range where, const Origins& origins, bool within, int depth) {
    const script::Structure& structure = origins.structure();
    const std::string_view text = origins.text();
    if (depth > 5 || text.substr(where.from, where.to - where.from).find("rand(") != text.npos)
        return false;
    return std::ranges::all_of(structure.commands, [&](const script::Command& command) {
        const bool inside = command.range.from >= where.from && command.range.to <= where.to;
        const std::string_view called = command.name(text);
        if (!inside || std::ranges::find(pure, called) != pure.end() ||
            (within && std::ranges::find(ownOnly, called) != ownOnly.end()))
            return true;
        const auto definition =
            std::ranges::find_if(structure.commands, [&](const script::Command& one) {
                return one.name(text) == "proc" && one.words.size() == 4 &&
                       origins.slice(one.words[1].content) == called;
            });
        return definition != structure.commands.end() &&
               arePure(definition->words[3].content, origins, true, depth + 1);
    });
}

} // namespace

bool isPure(Range where, const Origins& origins) { return arePure(where, origins, false, 0); }

} // namespace editing
