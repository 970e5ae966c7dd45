#include "element_edits/renaming.h"

#include "element_edits/creation.h"
#include "element_edits/options.h"
#include "element_edits/words.h"
#include "text/places.h"

#include <algorithm>
#include <cctype>

namespace editing {

using script::Command;
using script::Structure;
using script::Word;

namespace {

bool isPart(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The kind of a name that is wanted there; none: no single name.
std::optional<Kind> kindWanted(Wants wants) {
    switch (wants) {
    case Wants::body:
        return Kind::body;
    case Wants::shapeSet:
        return Kind::shapeSet;
    case Wants::trajectory:
        return Kind::trajectory;
    case Wants::joint:
        return Kind::joint;
    default:
        return std::nullopt;
    }
}

bool mayReadNames(Wants wants) {
    return wants == Wants::expression || wants == Wants::expressions || wants == Wants::vector;
}

// One name on its way through a text.
class Mentions {
public:
    Mentions(const std::string& text, Kind kind, std::string name, std::string newName)
        : text_(text), kind_(kind), name_(std::move(name)), newName_(std::move(newName)) {}

    void in(const Command& command);
    void asVariable();
    [[nodiscard]] text::Edits edits() {
        text::putInOrder(edits_);
        return edits_;
    }

private:
    [[nodiscard]] std::string contentOf(const Word& word) const {
        return slice(text_, word.content);
    }
    void replace(scene::Range range) {
        (void)text::join(edits_, {{range.from, range.to}, newName_});
    }
    void asWord(const Word& word) {
        if (word.literal && contentOf(word) == name_)
            replace(word.content);
    }
    void asExpression(const Word& word);

    const std::string& text_;
    Kind kind_;
    std::string name_, newName_;
    text::Edits edits_;
};

// Each name that is not another's quantity, a function or a variable.
void Mentions::asExpression(const Word& word) {
    const std::string content = contentOf(word);
    for (std::size_t at = content.find(name_); at != std::string::npos;
         at = content.find(name_, at + 1)) {
        const std::size_t end = at + name_.size();
        const char before = at == 0 ? ' ' : content[at - 1];
        const char behind = end == content.size() ? ' ' : content[end];
        const bool isVariable =
            before == '$' || (before == '{' && at > 1 && content[at - 2] == '$');
        if (!isPart(before) && before != '.' && !isVariable && !isPart(behind) && behind != '(')
            replace({word.content.from + at, word.content.from + end});
    }
}

void Mentions::in(const Command& command) {
    const CommandHint* hint = hintOf(command.name(text_));
    if (!hint)
        return;
    const std::vector<Word>& words = command.words;
    std::size_t at = 1;
    if (hint->named && words.size() > at && !contentOf(words[at]).starts_with('-')) {
        if (commandOf(kind_) == hint->name || (kind_ == Kind::body && hint->name == "instance") ||
            (kind_ == Kind::link && hint->name == "spring"))
            asWord(words[at]);
        ++at;
    }
    if (words.size() > at && kindWanted(hint->second) == kind_)
        asWord(words[at]);
    for (; at + 1 < words.size(); ++at) {
        const OptionHint* option = hintOf(*hint, contentOf(words[at]));
        if (!option)
            continue;
        const Word& value = words[at + 1];
        if (kindWanted(option->wants) == kind_)
            asWord(value);
        else if (mayReadNames(option->wants) && kind_ != Kind::shapeSet)
            asExpression(value);
        ++at;
    }
}

void Mentions::asVariable() {
    for (std::size_t at = text_.find('$'); at != std::string::npos; at = text_.find('$', at + 1)) {
        const bool braced = at + 1 < text_.size() && text_[at + 1] == '{';
        const std::size_t from = at + (braced ? 2 : 1), to = from + name_.size();
        if (text_.compare(from, name_.size(), name_) != 0)
            continue;
        const char behind = to < text_.size() ? text_[to] : ' ';
        const bool ends =
            braced ? behind == '}' : !isPart(behind) && behind != ':' && behind != '(';
        if (ends)
            replace({from, to});
    }
}

} // namespace

text::Edits mentionsRenamed(const std::string& text, const Structure& structure, Kind kind,
                            const std::string& name, const std::string& newName) {
    Mentions mentions(text, kind, name, newName);
    for (const Command& command : structure.commands)
        mentions.in(command);
    if (kind == Kind::parameter)
        mentions.asVariable();
    return mentions.edits();
}

std::string whyNotAlone(const std::string& text, const Structure& structure,
                        const scene::Scene& scene, const Element& element,
                        const Command*& command) {
    const scene::Source* source = sourceOf(scene, element);
    command =
        source && source->command.known() ? structure.startingAt(source->command.from) : nullptr;
    if (!source)
        return "is not in the scene.";
    if (!command)
        return "does not stand in the text: the command of line " + std::to_string(source->line) +
               " makes it of other text.";
    if (source->runs == 1)
        return "";
    const text::Places places(text);
    return "is one of " + std::to_string(source->runs) + " that line " +
           std::to_string(places.at(command->range.from).line) + " makes.";
}

Answer renamed(const std::string& text, const scene::Scene& scene, const Element& element,
               const std::string& newName) {
    Answer answer;
    const std::string name = nameOf(scene, element);
    if (newName == name)
        return answer;
    const Structure structure = script::structureOf(text);
    const Command* command = nullptr;
    const std::string why = whyNotAlone(text, structure, scene, element, command);
    if (!why.empty()) {
        answer.reason = describe(scene, element) + " " + why;
        answer.reason.front() = static_cast<char>(std::toupper(answer.reason.front()));
        answer.cause = sourceOf(scene, element)->command;
    } else if (newName.empty()) {
        answer.reason = "A name is needed.";
    } else if (!isName(newName)) {
        answer.reason =
            "\"" + newName + "\" is no name: letters, digits and _ make one, no digit first.";
    } else if (!isFreeName(scene, newName)) {
        answer.reason = "\"" + newName + "\" is the name of something else.";
    } else if (name.empty()) {
        const CommandHint* hint = hintOf(command->name(text));
        if (hint && hint->named)
            answer.edits.push_back(
                {{command->words.front().range.to, command->words.front().range.to},
                 " " + newName});
        else
            answer.reason = "A " + wordOf(element.kind) + " has no name.";
    } else {
        answer.edits = mentionsRenamed(text, structure, element.kind, name, newName);
        const bool isOwn = std::ranges::any_of(answer.edits, [&](const text::Edit& edit) {
            return command->words.size() > 1 && edit.range.from >= command->words[1].range.from &&
                   edit.range.to <= command->words[1].range.to;
        });
        if (!isOwn)
            return {{},
                    "The text computes the name of " + describe(scene, element) + ".",
                    command->range,
                    {},
                    {}};
    }
    return answer;
}

} // namespace editing
