#include "element_edits/creation.h"

#include "editing/lines.h"

#include "expression/parse.h"
#include "scene/joint_types.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace editing {

using script::Command;
using script::Structure;

namespace {

// Where elements of a kind stand in a text, by what usually precedes them.
constexpr Kind order[] = {Kind::parameter, Kind::shapeSet, Kind::trajectory, Kind::body,
                          Kind::force,     Kind::link,     Kind::joint,      Kind::gear,
                          Kind::rope,      Kind::contact,  Kind::constraint, Kind::light,
                          Kind::view,      Kind::plot};

class Writing {
public:
    Writing(const std::string& text, const scene::Scene& scene)
        : text_(text), scene_(scene), structure_(script::structureOf(text)),
          lineBreak_(lineBreakOf(text)) {
        for (const Kind kind : order)
            counts_[kind] = countOf(scene, kind);
        counts_[Kind::simulator] = countOf(scene, Kind::simulator);
    }

    void add(const NewElement& element);
    [[nodiscard]] text::Edits edits() const { return edits_; }

private:
    struct Place {
        std::size_t at = 0;
        bool newGroup = false; // nothing of its kind precedes it
        std::string indent;
    };
    [[nodiscard]] Place placeFor(const NewElement& element) const;
    [[nodiscard]] std::size_t endOfScript() const;
    // Behind everything that has to do with an element; the script's end when that is not known.
    [[nodiscard]] std::size_t behind(const Element& element) const;
    [[nodiscard]] const Command* commandAt(const Element& element) const;
    [[nodiscard]] std::string line(const NewElement& element) const;

    const std::string& text_;
    const scene::Scene& scene_;
    Structure structure_;
    std::string lineBreak_;
    std::map<Kind, std::size_t> counts_;
    text::Edits edits_;
};

const Command* Writing::commandAt(const Element& element) const {
    const scene::Source* source = sourceOf(scene_, element);
    return source && source->command.known() ? structure_.startingAt(source->command.from)
                                             : nullptr;
}

// What follows a `return` is never read.
std::size_t Writing::endOfScript() const {
    for (const Command& command : structure_.commands)
        if (command.parent < 0 && command.name(text_) == "return") {
            const std::size_t at = command.range.from;
            const std::size_t blank = text_.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
            const bool opensItsLine = at == 0 || blank == std::string::npos || text_[blank] == '\n';
            return !opensItsLine ? at : blank == std::string::npos || at == 0 ? 0 : blank + 1;
        }
    return text_.size();
}

std::size_t Writing::behind(const Element& element) const {
    const Command* command = commandAt(element);
    if (!command)
        return endOfScript();
    for (const Command* at = command; at->parent >= 0;) {
        at = &structure_.commands[static_cast<std::size_t>(at->parent)];
        if (at->name(text_) == "proc") // who knows where it is called
            return endOfScript();
    }
    return std::min(afterLine(text_, structure_, outermost(structure_, *command).range.to),
                    endOfScript());
}

Writing::Place Writing::placeFor(const NewElement& element) const {
    Place place;
    bool any = false;
    const auto take = [&](const Element& one, bool ofItsKind) {
        const std::size_t at = behind(one);
        if (any && at <= place.at)
            return;
        place.at = at;
        any = true;
        place.newGroup = !ofItsKind;
        if (const Command* command = commandAt(one))
            place.indent = indentOf(text_, outermost(structure_, *command));
    };
    const auto last = [&](Kind kind, bool ofItsKind) {
        if (const std::size_t count = counts_.at(kind))
            take({kind, count - 1}, ofItsKind);
    };
    last(element.kind, true);
    if (element.kind == Kind::simulator && !structure_.commands.empty()) {
        // Before everything, where one looks for it.
        const std::size_t first = structure_.commands.front().range.from;
        const std::size_t line = first == 0 ? std::string::npos : text_.rfind('\n', first - 1);
        const std::size_t begin = line == std::string::npos ? 0 : line + 1;
        if (text_.find_first_not_of(" \t", begin) == first)
            return {begin, false, ""};
    }
    if (!any)
        for (const Kind kind : order) {
            if (kind == element.kind)
                break;
            last(kind, false);
        }
    for (const Element& named : element.behind)
        take(named, false);
    if (!any) {
        place.at = endOfScript();
        place.newGroup = true;
    }
    for (const text::Edit& edit : edits_) // what is new may name what is new
        place.at = std::max(place.at, edit.range.from);
    return place;
}

std::string Writing::line(const NewElement& element) const {
    std::string command = element.command.empty() ? commandOf(element.kind) : element.command;
    bool byOption = false;
    if (element.kind == Kind::body && element.command.empty() && !scene_.bodies.empty()) {
        const scene::Source& last = scene_.bodies.back().source;
        byOption = std::ranges::find(last.arguments, "-shape", &scene::Argument::option) !=
                   last.arguments.end();
        if (const Command* written = commandAt({Kind::body, scene_.bodies.size() - 1}))
            if (written->name(text_) == "instance")
                command = "instance";
    }
    if (!element.name.empty())
        command += " " + element.name;
    if (!element.shape.empty())
        command += (byOption ? " -shape " : " ") + element.shape;
    for (const std::string& word : element.words)
        command += " " + word;
    return command;
}

void Writing::add(const NewElement& element) {
    const Place place = placeFor(element);
    std::string line = place.indent + this->line(element);
    const bool onLine = place.at > 0 && text_[place.at - 1] != '\n'; // something stands before it
    const bool atEnd = place.at == text_.size();
    const bool blankFollows = !atEnd && (text_[place.at] == '\n' || text_[place.at] == '\r');
    const auto before = text::startingAt(edits_, place.at);
    const bool first = before == edits_.end();
    std::string text;
    if (onLine && first)
        text = lineBreak_;
    // A backslash at the very end would go on into the new line.
    if (first && place.at > 0 && atEnd && isContinued(text_, onLine ? place.at : place.at - 1))
        text += lineBreak_;
    // A group of its own stands behind an empty line, where groups do.
    if (place.newGroup && place.at > 0 && (atEnd || blankFollows) && first)
        text += lineBreak_;
    const bool staysOpen = onLine && atEnd; // as the text's last line was
    text += staysOpen ? (first ? "" : lineBreak_) + line : line + lineBreak_;
    if (first)
        edits_.push_back({{place.at, place.at}, text});
    else
        before->text += text;
    text::putInOrder(edits_);
}

// Whether the text has it as a word of its own anywhere, even in comments and expressions.
bool hasWord(const std::string& text, const std::string& word) {
    const auto isPart = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1))
        if ((at == 0 || !isPart(text[at - 1])) &&
            (at + word.size() == text.size() || !isPart(text[at + word.size()])))
            return true;
    return false;
}

// "b" of "b12"; none when it does not end in a number.
std::string stemOf(const std::string& name) {
    const std::size_t end = name.find_last_not_of("0123456789");
    return end == std::string::npos || end + 1 == name.size() ? "" : name.substr(0, end + 1);
}

} // namespace

text::Edits created(const std::string& text, const scene::Scene& scene,
                    const std::vector<NewElement>& elements) {
    Writing writing(text, scene);
    for (const NewElement& element : elements)
        writing.add(element);
    return writing.edits();
}

namespace {

// Names that the language or the scene gives to something.
std::set<std::string> takenNames(const scene::Scene& scene) {
    std::set<std::string> names{"t", "pi", "scene", "events"};
    names.insert(expression::functionNames().begin(), expression::functionNames().end());
    for (const Kind one : order)
        for (std::size_t i = 0; sourceOf(scene, {one, i}); ++i)
            names.insert(nameOf(scene, {one, i}));
    return names;
}

} // namespace

bool isName(const std::string& name) {
    const auto isPart = [](unsigned char c) {
        return c < 0x80 && (std::isalnum(c) != 0 || c == '_');
    };
    return !name.empty() && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
           std::ranges::all_of(name, isPart);
}

bool isFreeName(const scene::Scene& scene, const std::string& name) {
    return isName(name) && !takenNames(scene).contains(name);
}

namespace {

// A name that a new joint has from its type.
bool isTypeOfJoint(const std::string& word) {
    const auto types = scene::jointTypeNames();
    return word == "rod" || std::ranges::find(types, word) != types.end();
}

} // namespace

std::string numberedName(const std::string& text, const scene::Scene& scene,
                         const std::string& name, const std::vector<std::string>& taken) {
    std::set<std::string> names = takenNames(scene);
    names.insert(taken.begin(), taken.end());
    const std::string stem = name.substr(0, name.find_last_not_of("0123456789") + 1);
    const std::string digits = name.substr(stem.size());
    int next = digits.empty() || digits.size() > 6 ? 2 : std::stoi(digits) + 1;
    const std::string base = stem.empty() || digits.size() > 6 ? name + "_" : stem;
    std::string found;
    do
        found = base + std::to_string(next++);
    while (names.contains(found) || hasWord(text, found));
    return found;
}

std::string unusedName(const std::string& text, const scene::Scene& scene, Kind kind,
                       const std::string& stem, const std::vector<std::string>& taken) {
    std::string base = stem;
    int next = 1;
    if (const std::size_t count = countOf(scene, kind)) {
        const std::string last = nameOf(scene, {kind, count - 1});
        const std::string row = stemOf(last);
        // A ball behind rod1 and rod2 is no rod3, a box behind ball1 no ball2, a slider behind
        // hinge1 no hinge2.
        const bool ofOtherShape =
            row != stem && (kind == Kind::shapeSet || (kind == Kind::joint && isTypeOfJoint(row)) ||
                            std::ranges::any_of(scene.shapeSets, [&](const scene::ShapeSet& set) {
                                return set.name == row;
                            }));
        if (!row.empty() && !ofOtherShape && last.size() - row.size() < 7) {
            base = row;
            next = std::stoi(last.substr(row.size())) + 1;
        }
    }
    std::set<std::string> names = takenNames(scene);
    names.insert(taken.begin(), taken.end());
    std::string name;
    do
        name = base + std::to_string(next++);
    while (names.contains(name) || hasWord(text, name));
    return name;
}

} // namespace editing
