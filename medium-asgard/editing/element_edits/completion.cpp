#include "element_edits/completion.h"

#include "expression/parse.h"
#include "scene/joint_types.h"
#include "scene/names.h"
#include "script/commands.h"
#include "script/structure.h"
#include "script/svg_colors.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>

namespace editing {

namespace {

// Of what kind of element names are asked for.
enum class Named { shapeSet, body, trajectory, parameter, joint, spring, rope, contact };

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' ||
           (static_cast<unsigned char>(c) & 0x80) != 0;
}

constexpr std::string_view trajectoryQuantities[] = {"x", "y", "z", "dx", "dy", "dz"};

// The text with its open braces, brackets and quotes closed, so that it has a structure.
std::string closed(std::string_view text) {
    std::string open;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '\\')
            ++i;
        else if (c == '{')
            open += '}';
        else if (c == '[')
            open += ']';
        else if (c == '"' && !open.empty() && open.back() == '"')
            open.pop_back();
        else if (c == '"' && i > 0 && std::isspace(static_cast<unsigned char>(text[i - 1])) != 0)
            open += '"';
        else if ((c == '}' || c == ']') && !open.empty() && open.back() == c)
            open.pop_back();
    }
    return std::string(text) + std::string(open.rbegin(), open.rend());
}

class Completer {
public:
    Completer(std::string_view text, const script::Structure& written, std::size_t place,
              const scene::Scene& scene)
        : text_(text), before_(text.substr(0, place)), scene_(scene), whole_(closed(before_)),
          structure_(script::structureOf(whole_)), written_(written) {
        from_ = before_.size();
        while (from_ > 0 && isWordCharacter(before_[from_ - 1]))
            --from_;
    }

    Completion completion() {
        if (inComment())
            return {};
        if (from_ > 0 && before_[from_ - 1] == '$')
            return take(variables(), "a variable");
        if (commandBegins())
            return take(commands(), "");
        const script::Command* command = commandHere();
        if (!command)
            return {};
        const CommandHint* hint = hintOf(command->name(whole_));
        return hint ? inSceneCommand(*command, *hint) : Completion{};
    }

private:
    [[nodiscard]] bool inComment() const {
        return std::ranges::any_of(structure_.comments, [&](const script::Range& comment) {
            return comment.from < before_.size() && before_.size() <= comment.to;
        });
    }

    // A command begins here: what stands before is nothing, or ends one or opens a script.
    [[nodiscard]] bool commandBegins() const {
        std::size_t at = from_;
        while (at > 0 && (before_[at - 1] == ' ' || before_[at - 1] == '\t'))
            --at;
        if (at > 1 && before_[at - 1] == '\n' && before_[at - 2] == '\\')
            return false;
        const bool apart =
            at == 0 || std::string_view("\n;{[").find(before_[at - 1]) != std::string_view::npos;
        if (!apart || from_ == before_.size())
            return apart;
        const script::Command* command = structure_.startingAt(from_);
        return command != nullptr;
    }

    // The innermost command whose words go on here.
    [[nodiscard]] const script::Command* commandHere() const {
        const script::Command* last = nullptr;
        for (const script::Command& command : structure_.commands)
            if (!command.words.empty() && command.words.front().range.to < from_ &&
                reaches(command))
                last = &command;
        return last;
    }
    // Only blanks between it and here, on its line or after a backslash.
    [[nodiscard]] bool reaches(const script::Command& command) const {
        for (std::size_t i = command.range.to; i < from_; ++i) {
            const bool continued = before_[i] == '\n' && before_[i - 1] == '\\';
            const bool begun = before_[i] == '-' && i + 1 == from_;
            if (before_[i] != ' ' && before_[i] != '\t' && before_[i] != '\\' && !continued &&
                !begun)
                return false;
        }
        return true;
    }

    Completion inSceneCommand(const script::Command& command, const CommandHint& hint) {
        // The words that are whole before this one.
        std::vector<std::string> words;
        for (const script::Word& word : command.words)
            if (word.range.to < from_)
                words.push_back(
                    whole_.substr(word.content.from, word.content.to - word.content.from));
        if (from_ > 0 && before_[from_ - 1] == '-' && (from_ < 2 || isBlank(before_[from_ - 2]))) {
            --from_;
            return take(options(hint, words), hint.usage);
        }
        if (words.size() > 1 && words.back().starts_with('-'))
            if (const OptionHint* option = hintOf(hint, words.back()))
                return value(*option);
        return word(hint, words);
    }

    // A word after the command that is no option's value.
    Completion word(const CommandHint& hint, const std::vector<std::string>& words) {
        const bool name = words.size() == 1 && hint.named;
        if (name)
            return {from_, {}, std::string(hint.usage)};
        const bool secondName = words.size() == (hint.named ? 2U : 1U) &&
                                (hint.second == Wants::shapeSet || hint.second == Wants::body);
        std::vector<std::string> all = options(hint, words);
        if (secondName) {
            auto known = names(hint.second == Wants::body ? Named::body : Named::shapeSet);
            all.insert(all.begin(), known.begin(), known.end());
        }
        return take(std::move(all), std::string(hint.usage));
    }

    Completion value(const OptionHint& option) {
        const std::string hint = std::string(option.name) + ": " + std::string(option.words);
        switch (option.wants) {
        case Wants::shapeSet:
            return take(names(Named::shapeSet), hint);
        case Wants::body:
            return take(names(Named::body), hint);
        case Wants::trajectory:
            return take(names(Named::trajectory), hint);
        case Wants::joint:
            return take(names(Named::joint), hint);
        case Wants::choice:
            return take(split(option.choices), hint);
        case Wants::flag:
            return take({"0", "1"}, hint);
        case Wants::color:
            return from_ == before_.size()
                       ? Completion{from_, {}, hint}
                       : take({script::colorNames().begin(), script::colorNames().end()}, hint);
        case Wants::expression:
        case Wants::list:
        case Wants::expressions:
        case Wants::vector:
            return inExpression(hint);
        default:
            return {from_, {}, hint};
        }
    }

    // Names, and after "NAME." what a body or trajectory has.
    Completion inExpression(const std::string& hint) {
        if (from_ > 0 && before_[from_ - 1] == '.') {
            std::size_t begin = from_ - 1;
            while (begin > 0 && isWordCharacter(before_[begin - 1]))
                --begin;
            const std::string owner(before_.substr(begin, from_ - 1 - begin));
            const auto has = [&](Named kind) {
                const auto all = names(kind);
                return std::ranges::find(all, owner) != all.end();
            };
            if (has(Named::trajectory))
                return take({std::begin(trajectoryQuantities), std::end(trajectoryQuantities)},
                            hint);
            if (has(Named::body))
                return take(scene::bodyQuantityNames(), hint);
            if (has(Named::joint))
                return take(scene::jointQuantityNames(typeOfJoint(owner)), hint);
            if (has(Named::spring))
                return take(scene::springQuantityNames(), hint);
            if (has(Named::rope))
                return take(scene::ropeQuantityNames(ropeNamed(owner)), hint);
            if (has(Named::contact))
                return take(scene::contactQuantityNames(), hint);
            return {from_, {}, hint};
        }
        if (atWordEnd() || std::isdigit(static_cast<unsigned char>(before_[from_])) != 0)
            return {from_, {}, hint};
        std::vector<std::string> all;
        for (const Named kind : {Named::body, Named::parameter, Named::trajectory, Named::joint,
                                 Named::spring, Named::rope}) {
            auto some = names(kind);
            all.insert(all.end(), some.begin(), some.end());
        }
        all.insert(all.end(), expression::functionNames().begin(),
                   expression::functionNames().end());
        return take(std::move(all), hint);
    }

    [[nodiscard]] std::string wordOf(const script::Word& word) const {
        return std::string(text_.substr(word.content.from, word.content.to - word.content.from));
    }
    // As the text says, else the last good scene.
    [[nodiscard]] scene::JointType typeOfJoint(const std::string& joint) const {
        const auto types = scene::jointTypeNames();
        for (const script::Command& command : written_.commands)
            if (command.name(text_) == "joint" && command.words.size() > 1 &&
                wordOf(command.words[1]) == joint)
                for (std::size_t i = 2; i + 1 < command.words.size(); ++i)
                    if (wordOf(command.words[i]) == "-type")
                        if (const auto type =
                                std::ranges::find(types, wordOf(command.words[i + 1]));
                            type != types.end())
                            return static_cast<scene::JointType>(type - types.begin());
        const scene::Joint* known = scene::findJoint(scene_, joint);
        return known ? known->type : scene::JointType::hinge;
    }

    // Of the last good scene; one that it does not have has a single span.
    [[nodiscard]] scene::Rope ropeNamed(const std::string& rope) const {
        const auto known = std::ranges::find(scene_.ropes, rope, &scene::Rope::name);
        return known != scene_.ropes.end() ? *known : scene::Rope{};
    }

    // Of the text as far as it can be told without running it, and of the last good scene.
    [[nodiscard]] std::vector<std::string> names(Named kind) const {
        std::set<std::string> all;
        const auto add = [&](const auto& list) {
            for (const auto& element : list)
                all.insert(element.name);
        };
        kind == Named::shapeSet     ? add(scene_.shapeSets)
        : kind == Named::body       ? add(scene_.bodies)
        : kind == Named::trajectory ? add(scene_.trajectories)
        : kind == Named::joint      ? add(scene_.joints)
        : kind == Named::spring     ? add(scene_.links)
        : kind == Named::rope       ? add(scene_.ropes)
        : kind == Named::contact    ? add(scene_.contacts)
                                    : add(scene_.parameters);
        // What is being typed here is no name yet.
        for (const script::Command& command : written_.commands) {
            const std::string_view name = command.name(text_);
            const bool fits = kind == Named::shapeSet     ? name == "shape_set"
                              : kind == Named::body       ? name == "body" || name == "instance"
                              : kind == Named::trajectory ? name == "trajectory"
                              : kind == Named::joint      ? name == "joint"
                              : kind == Named::spring     ? name == "spring"
                              : kind == Named::rope       ? name == "rope"
                              : kind == Named::contact    ? name == "contact"
                                                          : name == "parameter";
            if (fits && command.words.size() > 1 && command.words[1].literal &&
                !(command.words[1].range.from < before_.size() &&
                  before_.size() <= command.words[1].range.to))
                all.emplace(wordOf(command.words[1]));
        }
        std::erase_if(all, [](const std::string& name) { // links, and springs without a name
            return name.empty() || name.starts_with('-');
        });
        return {all.begin(), all.end()};
    }

    [[nodiscard]] std::vector<std::string> variables() const {
        std::set<std::string> all;
        for (const scene::Parameter& parameter : scene_.parameters)
            all.insert(parameter.name);
        for (const script::Command& command : structure_.commands) {
            const std::string_view name = command.name(whole_);
            if ((name == "set" || name == "foreach" || name == "parameter" || name == "variable") &&
                command.words.size() > 1 && command.words[1].literal)
                all.emplace(
                    whole_.substr(command.words[1].content.from,
                                  command.words[1].content.to - command.words[1].content.from));
        }
        return {all.begin(), all.end()};
    }

    [[nodiscard]] static std::vector<std::string> commands() {
        std::vector<std::string> all(script::sceneCommands().begin(),
                                     script::sceneCommands().end());
        all.insert(all.end(), script::tclCommands().begin(), script::tclCommands().end());
        return all;
    }

    [[nodiscard]] static std::vector<std::string> options(const CommandHint& hint,
                                                          const std::vector<std::string>& given) {
        std::vector<std::string> all;
        for (const OptionHint& option : hint.options)
            if (std::ranges::find(given, option.name) == given.end())
                all.emplace_back(option.name);
        return all;
    }

    [[nodiscard]] static std::vector<std::string> split(std::string_view choices) {
        std::vector<std::string> all;
        for (const script::Element& element : script::elementsOf(choices).elements)
            all.push_back(element.value);
        return all;
    }

    [[nodiscard]] static bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n'; }
    [[nodiscard]] bool atWordEnd() const { return from_ == before_.size(); }

    // Those that begin as what stands there, and are more than that.
    Completion take(std::vector<std::string> all, std::string_view hint) {
        const std::string_view begun = before_.substr(from_);
        const bool whole = std::ranges::find(all, begun) != all.end();
        std::erase_if(all, [&](const std::string& word) {
            return !word.starts_with(begun) || word == begun;
        });
        return {from_, std::move(all), std::string(hint), whole};
    }

    std::string_view text_, before_;
    const scene::Scene& scene_;
    std::string whole_; // what stands before, with what it opens closed
    script::Structure structure_;
    const script::Structure& written_; // of all the text
    std::size_t from_;
};

} // namespace

Completion completionAt(std::string_view text, const script::Structure& structure,
                        std::size_t place, const scene::Scene& scene) {
    return Completer(text, structure, std::min(place, text.size()), scene).completion();
}

Completion completionAt(std::string_view text, std::size_t place, const scene::Scene& scene) {
    return completionAt(text, script::structureOf(text), place, scene);
}

} // namespace editing
