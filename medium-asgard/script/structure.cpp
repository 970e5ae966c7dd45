#include "script/structure.h"

#include "script/instrument.h"
#include "script/tcl_syntax.h"

#include <algorithm>

namespace script {

std::string_view Command::name(std::string_view text) const {
    if (words.empty() || !words.front().literal || words.front().expanded)
        return {};
    std::string_view name = text.substr(words.front().content.from,
                                        words.front().content.to - words.front().content.from);
    if (name.starts_with("::"))
        name.remove_prefix(2);
    return name;
}

const Command* Structure::at(std::size_t offset) const {
    const Command* found = nullptr;
    for (const Command& command : commands) {
        if (command.range.from > offset)
            break;
        if (offset < command.range.to)
            found = &command; // inner ones come later
    }
    return found;
}

const Command* Structure::startingAt(std::size_t offset) const {
    const auto place = std::lower_bound(
        commands.begin(), commands.end(), offset,
        [](const Command& command, std::size_t from) { return command.range.from < from; });
    return place != commands.end() && place->range.from == offset ? &*place : nullptr;
}

static thread_local std::size_t made = 0;

std::size_t structuresMade() { return made; }

Structure structureOf(std::string_view text) {
    ++made;
    // Continuations of other systems move no byte when they become Tcl's.
    std::string plain;
    if (text.find("\\\r\n") != std::string_view::npos) {
        plain = withPlainContinuations(text);
        text = plain;
    }
    SyntaxWalker walker(text);
    Structure structure = walker.run();
    // A command's words are walked after its own record is made, so that only the order of equal
    // starts (a command that begins with a substitution) needs care: outer first.
    std::vector<int> order(structure.commands.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = static_cast<int>(i);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return structure.commands[static_cast<std::size_t>(a)].range.from <
               structure.commands[static_cast<std::size_t>(b)].range.from;
    });
    std::vector<int> place(order.size());
    std::vector<Command> sorted;
    sorted.reserve(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        place[static_cast<std::size_t>(order[i])] = static_cast<int>(i);
        sorted.push_back(std::move(structure.commands[static_cast<std::size_t>(order[i])]));
    }
    for (Command& command : sorted)
        if (command.parent >= 0)
            command.parent = place[static_cast<std::size_t>(command.parent)];
    structure.commands = std::move(sorted);
    return structure;
}

} // namespace script
