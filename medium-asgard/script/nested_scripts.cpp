// Which words of Tcl's own commands are scripts or expressions.
#include "script/tcl_syntax.h"

#include <string_view>
#include <utility>

namespace script {

void SyntaxWalker::nestedScript(const Word& word, int owner) {
    if (!word.braced || word.expanded)
        return;
    script(word.content.from, word.content.to, false, owner);
    failed_ = false; // a fault inside one body does not hide the commands after it
}

// Brackets in a braced expression are commands, except inside its own braces.
void SyntaxWalker::nestedExpression(const Word& word, int owner) {
    if (!word.braced || word.expanded)
        return;
    const std::size_t outerEnd = std::exchange(end_, word.content.to);
    std::size_t at = word.content.from;
    while (!failed_ && at < end_) {
        if (text_[at] == '{') {
            Word literal;
            at = braces(at, literal);
        } else if (text_[at] == '$' || text_[at] == '[' || text_[at] == '\\') {
            at = substitution(at, owner);
        } else {
            ++at;
        }
    }
    failed_ = false;
    end_ = outerEnd;
}

void SyntaxWalker::nestedSwitch(int owner, std::size_t first) {
    const std::vector<Word> words = structure_.commands[static_cast<std::size_t>(owner)].words;
    if (first + 1 < words.size()) { // pattern script pattern script ...
        for (std::size_t i = first + 1; i < words.size(); i += 2)
            nestedScript(words[i], owner);
        return;
    }
    if (first >= words.size() || !words[first].braced || !words[first].literal)
        return;
    const Range list = words[first].content;
    const ElementList elements = elementsOf(text_.substr(list.from, list.to - list.from));
    for (std::size_t i = 1; i < elements.elements.size(); i += 2) {
        const Element& element = elements.elements[i];
        Word body;
        body.braced = element.range.from != element.content.from &&
                      text_[list.from + element.range.from] == '{';
        body.content = {list.from + element.content.from, list.from + element.content.to};
        nestedScript(body, owner);
    }
}

namespace {

// Words that are scripts, by place, for commands where places are enough. Negative: from the end.
struct Places {
    std::string_view command, subcommand;
    int scripts[2];
    std::size_t leastWords;
};
constexpr int none = 99;
constexpr Places places[] = {
    {"while", "", {2, none}, 3},         {"for", "", {1, 3}, 5},
    {"foreach", "", {-1, none}, 4},      {"lmap", "", {-1, none}, 4},
    {"proc", "", {3, none}, 4},          {"catch", "", {1, none}, 2},
    {"dict", "for", {-1, none}, 5},      {"dict", "map", {-1, none}, 5},
    {"dict", "with", {-1, none}, 4},     {"dict", "update", {-1, none}, 6},
    {"namespace", "eval", {3, none}, 4}, {"uplevel", "", {-1, none}, 2},
    {"eval", "", {1, none}, 2},
};

} // namespace

void SyntaxWalker::nested(int owner) {
    // A copy: walking nested scripts makes the vector of commands grow.
    const Command command = structure_.commands[static_cast<std::size_t>(owner)];
    const std::vector<Word>& words = command.words;
    const std::string_view name = command.name(text_);
    if (name.empty())
        return;
    const auto textOf = [&](std::size_t i) {
        const Range content = words[i].content;
        return text_.substr(content.from, content.to - content.from);
    };
    const std::size_t count = words.size();
    // A script of several words is their concatenation, and has no place.
    const bool joined = (name == "eval" && count != 2) || (name == "namespace" && count != 4) ||
                        (name == "uplevel" && count > 3);
    for (const Places& known : places) {
        if (joined || known.command != name || count < known.leastWords ||
            (!known.subcommand.empty() && textOf(1) != known.subcommand))
            continue;
        for (const int place : known.scripts)
            if (place != none)
                nestedScript(words[place < 0 ? count - 1 : static_cast<std::size_t>(place)], owner);
    }
    if (name == "expr" && count == 2)
        nestedExpression(words[1], owner);
    else if ((name == "while" || name == "for") && count >= 3)
        nestedExpression(words[name == "for" ? 2 : 1], owner);
    if (name == "for" && count >= 5)
        nestedScript(words[4], owner);
    if (name == "if") {
        for (std::size_t i = 1; i < count; ++i) {
            const std::string_view word = textOf(i);
            if (words[i].braced && (i == 1 || textOf(i - 1) == "elseif"))
                nestedExpression(words[i], owner);
            else if (word != "then" && word != "else" && word != "elseif")
                nestedScript(words[i], owner);
        }
    } else if (name == "try") {
        // try body ?on code vars body? ?trap pattern vars body? ?finally body?
        for (std::size_t i = 1; i < count;) {
            nestedScript(words[i], owner);
            ++i;
            if (i < count)
                i += textOf(i) == "finally" ? 1 : 3;
        }
    } else if (name == "switch") {
        std::size_t first = 1;
        while (first < count && textOf(first).starts_with('-')) {
            const bool takesValue = textOf(first) == "-matchvar" || textOf(first) == "-indexvar";
            const bool last = textOf(first) == "--";
            first += takesValue ? 2 : 1;
            if (last)
                break;
        }
        nestedSwitch(owner, first + 1);
    }
}

} // namespace script
