#include "script/tcl_syntax.h"

#include <algorithm>
#include <cctype>
#include <utility>

namespace script {

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\r'; }

bool isNameCharacter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

} // namespace

Structure SyntaxWalker::run() {
    script(0, text_.size(), false, -1);
    return std::move(structure_);
}

void SyntaxWalker::fail(std::size_t from, std::size_t to, std::string message) {
    if (!failed_)
        structure_.faults.push_back({Range{from, std::min(to, text_.size())}, std::move(message)});
    failed_ = true;
}

bool SyntaxWalker::blankAt(std::size_t at) const {
    return at < end_ &&
           (isBlank(text_[at]) || (text_[at] == '\\' && at + 1 < end_ && text_[at + 1] == '\n'));
}

std::size_t SyntaxWalker::skipBlanks(std::size_t at) const {
    while (blankAt(at))
        at += text_[at] == '\\' ? 2 : 1;
    return at;
}

bool SyntaxWalker::ends(std::size_t at, bool bracketed) const {
    return at >= end_ || text_[at] == '\n' || text_[at] == ';' || (bracketed && text_[at] == ']');
}

std::size_t SyntaxWalker::script(std::size_t from, std::size_t end, bool bracketed, int parent) {
    if (++depth_ > maximumDepth) {
        fail(from, from + 1, "scripts are nested more than 100 levels deep");
        --depth_;
        return end;
    }
    const std::size_t outerEnd = std::exchange(end_, end);
    const std::size_t start = from;
    while (!failed_) {
        from = skipBlanks(from);
        if (from >= end_)
            break;
        if (bracketed && text_[from] == ']')
            break;
        if (text_[from] == '\n' || text_[from] == ';')
            ++from;
        else if (text_[from] == '#')
            from = comment(from);
        else
            from = command(from, bracketed, parent);
    }
    if (bracketed && !failed_ && from >= end_)
        fail(start - 1, start, "this bracket is never closed");
    end_ = outerEnd;
    --depth_;
    return from;
}

std::size_t SyntaxWalker::comment(std::size_t from) {
    std::size_t at = from;
    while (at < end_ && text_[at] != '\n')
        at += text_[at] == '\\' && at + 1 < end_ ? 2 : 1;
    structure_.comments.push_back({from, std::min(at, end_)});
    return std::min(at, end_);
}

std::size_t SyntaxWalker::command(std::size_t from, bool bracketed, int parent) {
    const int self = static_cast<int>(structure_.commands.size());
    structure_.commands.push_back({Range{from, from}, {}, parent, bracketed});
    std::size_t at = from;
    while (!failed_ && !ends(at, bracketed)) {
        Word read;
        at = word(at, bracketed, self, read);
        if (failed_)
            break;
        Command& command = structure_.commands[static_cast<std::size_t>(self)];
        command.range.to = read.range.to;
        append(command, read);
        at = skipBlanks(at);
    }
    if (failed_) { // Tcl refuses the whole command before it runs any of it
        if (structure_.commands[static_cast<std::size_t>(self)].range.to == from)
            structure_.commands.resize(static_cast<std::size_t>(self));
        return at;
    }
    nested(self);
    return at;
}

// {*}{a b} is the words a and b, which stand in the text.
void SyntaxWalker::append(Command& command, const Word& word) const {
    if (!word.expanded || !word.literal) {
        command.words.push_back(word);
        return;
    }
    const std::string_view list =
        text_.substr(word.content.from, word.content.to - word.content.from);
    const ElementList elements = elementsOf(list);
    const bool plain = elements.fault.empty() &&
                       std::all_of(elements.elements.begin(), elements.elements.end(),
                                   [](const Element& element) { return element.literal; });
    if (!plain) {
        command.words.push_back(word);
        return;
    }
    for (const Element& element : elements.elements) {
        Word part;
        part.range = {word.content.from + element.range.from, word.content.from + element.range.to};
        part.content = {word.content.from + element.content.from,
                        word.content.from + element.content.to};
        part.literal = true;
        part.braced = list[element.range.from] == '{';
        part.quoted = list[element.range.from] == '"';
        part.fromList = true;
        command.words.push_back(part);
    }
}

std::size_t SyntaxWalker::word(std::size_t from, bool bracketed, int owner, Word& word) {
    std::size_t at = from;
    if (text_.substr(at, 3) == "{*}" && at + 3 < end_ && !blankAt(at + 3) &&
        !ends(at + 3, bracketed)) {
        word.expanded = true;
        at += 3;
    }
    word.literal = true;
    if (text_[at] == '{')
        at = braces(at, word);
    else if (text_[at] == '"')
        at = quotes(at, owner, word);
    else
        at = bare(at, bracketed, owner, word);
    word.range = {from, at};
    if (!failed_ && (word.braced || word.quoted) && !blankAt(at) && !ends(at, bracketed))
        fail(at, at + 1,
             word.braced ? "a blank is missing after this word's closing brace"
                         : "a blank is missing after this word's closing quote");
    return at;
}

std::size_t SyntaxWalker::braces(std::size_t from, Word& word) {
    word.braced = true;
    int level = 1;
    std::size_t at = from + 1;
    for (; at < end_; ++at) {
        if (text_[at] == '{')
            ++level;
        else if (text_[at] == '}' && --level == 0)
            break;
        else if (text_[at] == '\\' && at + 1 < end_) {
            ++at;
            // The one substitution inside braces.
            if (text_[at] == '\n')
                word.literal = false;
        }
    }
    if (at >= end_) {
        fail(from, from + 1, "this brace is never closed");
        return end_;
    }
    word.content = {from + 1, at};
    return at + 1;
}

// Past one character of a word, or past what is substituted there.
std::size_t SyntaxWalker::character(std::size_t at, int owner, Word& word) {
    if (text_[at] != '$' && text_[at] != '[' && text_[at] != '\\')
        return at + 1;
    const std::size_t after = substitution(at, owner);
    if (after > at + 1) // a last backslash or a dollar without a name is itself
        word.literal = false;
    return after;
}

std::size_t SyntaxWalker::quotes(std::size_t from, int owner, Word& word) {
    word.quoted = true;
    std::size_t at = from + 1;
    while (!failed_ && at < end_ && text_[at] != '"')
        at = character(at, owner, word);
    if (!failed_ && at >= end_) {
        fail(from, from + 1, "this quote is never closed");
        return end_;
    }
    word.content = {from + 1, at};
    return at + 1;
}

std::size_t SyntaxWalker::bare(std::size_t from, bool bracketed, int owner, Word& word) {
    std::size_t at = from;
    while (!failed_ && !blankAt(at) && !ends(at, bracketed))
        at = character(at, owner, word);
    word.content = {from, at};
    if (word.expanded)
        word.content.from = from;
    return at;
}

std::size_t SyntaxWalker::substitution(std::size_t from, int owner) {
    if (text_[from] == '\\')
        return std::min(from + 2, end_);
    if (text_[from] == '$')
        return variable(from, owner);
    const std::size_t at = script(from + 1, end_, true, owner);
    return failed_ ? at : at + 1;
}

std::size_t SyntaxWalker::variable(std::size_t from, int owner) {
    std::size_t at = from + 1;
    if (at < end_ && text_[at] == '{') {
        const std::size_t close = text_.substr(0, end_).find('}', at);
        if (close == std::string_view::npos) {
            fail(from, from + 2, "the brace of this variable's name is never closed");
            return end_;
        }
        return close + 1;
    }
    while (at < end_ && (isNameCharacter(text_[at]) || text_.substr(at, 2) == "::")) {
        if (text_[at] == ':')
            while (at < end_ && text_[at] == ':')
                ++at;
        else
            ++at;
    }
    if (at >= end_ || text_[at] != '(')
        return at;
    for (++at; !failed_ && at < end_ && text_[at] != ')';)
        at = text_[at] == '$' || text_[at] == '[' || text_[at] == '\\' ? substitution(at, owner)
                                                                       : at + 1;
    if (!failed_ && at >= end_)
        fail(from, from + 1, "the parenthesis of this variable's index is never closed");
    return failed_ ? at : at + 1;
}

} // namespace script
