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

// switch ?options? string pattern body ... , or with the patterns and bodies as one list.
void SyntaxWalker::nestedSwitch(const std::vector<Word>& words, int owner) {
    std::size_t first = 1;
    while (first < words.size() && contentOf(words[first]).starts_with('-')) {
        const std::string_view option = contentOf(words[first]);
        first += option == "-matchvar" || option == "-indexvar" ? 2 : 1;
        if (option == "--")
            break;
    }
    ++first;                        // the string
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
struct ScriptWords {
    std::string_view command, subcommand;
    int scripts[2];
    std::size_t leastWords;
};
constexpr int none = 99;
constexpr ScriptWords scriptWords[] = {
    {"while", "", {2, none}, 3},       {"for", "", {1, 3}, 5},
    {"for", "", {4, none}, 5},         {"foreach", "", {-1, none}, 4},
    {"lmap", "", {-1, none}, 4},       {"proc", "", {3, none}, 4},
    {"catch", "", {1, none}, 2},       {"dict", "for", {-1, none}, 5},
    {"dict", "map", {-1, none}, 5},    {"dict", "with", {-1, none}, 4},
    {"dict", "update", {-1, none}, 6}, {"namespace", "eval", {3, none}, 4},
    {"uplevel", "", {-1, none}, 2},    {"eval", "", {1, none}, 2},
};

} // namespace

std::string_view SyntaxWalker::contentOf(const Word& word) const {
    return text_.substr(word.content.from, word.content.to - word.content.from);
}

void SyntaxWalker::nestedByPlace(const Command& command, int owner) {
    const std::vector<Word>& words = command.words;
    const std::string_view name = command.name(text_);
    const std::size_t count = words.size();
    // A script of several words is their concatenation, and has no place.
    if ((name == "eval" && count != 2) || (name == "namespace" && count != 4) ||
        (name == "uplevel" && count > 3))
        return;
    for (const ScriptWords& known : scriptWords) {
        if (known.command != name || count < known.leastWords ||
            (!known.subcommand.empty() && contentOf(words[1]) != known.subcommand))
            continue;
        for (const int place : known.scripts)
            if (place != none)
                nestedScript(words[place < 0 ? count - 1 : static_cast<std::size_t>(place)], owner);
    }
}

void SyntaxWalker::nestedIf(const std::vector<Word>& words, int owner) {
    for (std::size_t i = 1; i < words.size(); ++i) {
        const std::string_view word = contentOf(words[i]);
        if (words[i].braced && (i == 1 || contentOf(words[i - 1]) == "elseif"))
            nestedExpression(words[i], owner);
        else if (word != "then" && word != "else" && word != "elseif")
            nestedScript(words[i], owner);
    }
}

// try body ?on code vars body? ?trap pattern vars body? ?finally body?
void SyntaxWalker::nestedTry(const std::vector<Word>& words, int owner) {
    for (std::size_t i = 1; i < words.size();) {
        nestedScript(words[i], owner);
        ++i;
        if (i < words.size())
            i += contentOf(words[i]) == "finally" ? 1 : 3;
    }
}

void SyntaxWalker::nested(int owner) {
    // A copy: walking nested scripts makes the vector of commands grow.
    const Command command = structure_.commands[static_cast<std::size_t>(owner)];
    const std::vector<Word>& words = command.words;
    const std::string_view name = command.name(text_);
    if (name.empty())
        return;
    nestedByPlace(command, owner);
    if (name == "expr" && words.size() == 2)
        nestedExpression(words[1], owner);
    else if (name == "while" && words.size() == 3)
        nestedExpression(words[1], owner);
    else if (name == "for" && words.size() == 5)
        nestedExpression(words[2], owner);
    else if (name == "if")
        nestedIf(words, owner);
    else if (name == "try")
        nestedTry(words, owner);
    else if (name == "switch")
        nestedSwitch(words, owner);
}

} // namespace script
