#include "editing/lines.h"

#include <algorithm>

namespace editing {

using script::Command;
using script::Structure;

namespace {

bool isBlankInLine(char c) { return c == ' ' || c == '\t' || c == '\r'; }

std::size_t lineStart(std::string_view text, std::size_t offset) {
    const std::size_t before = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
    return before == std::string_view::npos ? 0 : before + 1;
}

// From here on the line holds blanks, semicolons and a comment at most; where it ends then.
std::optional<std::size_t> endOfBareLine(std::string_view text, const Structure& structure,
                                         std::size_t at) {
    while (at < text.size()) {
        const char c = text[at];
        if (c == '\n')
            return at + 1;
        if (const std::string_view rest = text.substr(at);
            rest.starts_with("\\\n") || rest.starts_with("\\\r\n")) {
            at += rest[1] == '\n' ? 2 : 3; // a continued line that holds nothing
            continue;
        }
        if (c == '#') {
            const auto comment = std::ranges::find(structure.comments, at, &scene::Range::from);
            if (comment == structure.comments.end())
                return std::nullopt;
            at = comment->to;
            continue;
        }
        if (!isBlankInLine(c) && c != ';')
            return std::nullopt;
        ++at;
    }
    return at;
}

} // namespace

bool isContinued(std::string_view text, std::size_t lineBreak) {
    if (lineBreak > 0 && lineBreak < text.size() && text[lineBreak] == '\n' &&
        text[lineBreak - 1] == '\r')
        --lineBreak;
    std::size_t slashes = 0;
    while (slashes < lineBreak && text[lineBreak - 1 - slashes] == '\\')
        ++slashes;
    return slashes % 2 == 1;
}

const Command& outermost(const Structure& structure, const Command& command) {
    const Command* at = &command;
    while (at->parent >= 0)
        at = &structure.commands[static_cast<std::size_t>(at->parent)];
    return *at;
}

std::size_t afterLine(std::string_view text, const Structure& structure, std::size_t offset) {
    std::size_t at = offset;
    while (at < text.size()) {
        const std::size_t newline = text.find('\n', at);
        if (newline == std::string_view::npos)
            return text.size();
        at = newline + 1;
        bool within = isContinued(text, newline);
        const auto skip = [&](const scene::Range& range) {
            if (range.from < at && range.to >= at) {
                at = range.to;
                within = true;
            }
        };
        for (const Command& command : structure.commands)
            if (command.parent < 0)
                skip(command.range);
        for (const scene::Range& comment : structure.comments)
            if (comment.to > at)
                skip(comment);
        if (!within)
            return at;
    }
    return at;
}

scene::Range wholeOf(std::string_view text, const Structure& structure, const Command& command) {
    const std::size_t start = lineStart(text, command.range.from);
    const bool firstOnLine =
        std::all_of(text.begin() + static_cast<std::ptrdiff_t>(start),
                    text.begin() + static_cast<std::ptrdiff_t>(command.range.from),
                    isBlankInLine) &&
        !(start > 0 && isContinued(text, start - 1));
    const auto end = endOfBareLine(text, structure, command.range.to);
    if (firstOnLine && end)
        return {start, *end};
    std::size_t to = command.range.to;
    while (to < text.size() && isBlankInLine(text[to]))
        ++to;
    if (to == text.size() || text[to] != ';')
        return command.range;
    do
        ++to;
    while (to < text.size() && isBlankInLine(text[to]));
    // A comment needs its semicolon.
    return to < text.size() && text[to] == '#' ? command.range
                                               : scene::Range{command.range.from, to};
}

std::string indentOf(std::string_view text, const Command& command) {
    const std::size_t start = lineStart(text, command.range.from);
    const std::string before(text.substr(start, command.range.from - start));
    return std::ranges::all_of(before, isBlankInLine) ? before : "";
}

std::string lineBreakOf(std::string_view text) {
    const std::size_t newline = text.find('\n');
    return newline != std::string_view::npos && newline > 0 && text[newline - 1] == '\r' ? "\r\n"
                                                                                         : "\n";
}

} // namespace editing
