#include "element_edits/words.h"

#include "script/structure.h"

namespace editing {

namespace {

// Behind a command's name it is read as one word, all of it.
bool isOneWord(const std::string& text) {
    const std::string whole = "x " + text;
    const script::Structure structure = script::structureOf(whole);
    if (!structure.faults.empty() || !structure.comments.empty() || structure.commands.empty())
        return false;
    const script::Command& command = structure.commands.front();
    return command.words.size() == 2 && !command.words[1].expanded &&
           command.words[1].range == script::Range{2, whole.size()};
}

} // namespace

std::optional<std::string> wordFor(std::string_view value) {
    const std::string as(value);
    const bool reads = as.find_first_of("$[") != std::string::npos;
    if (isOneWord(as))
        return as;
    const std::string wrapped = reads ? '"' + as + '"' : '{' + as + '}';
    return isOneWord(wrapped) ? std::optional(wrapped) : std::nullopt;
}

} // namespace editing
