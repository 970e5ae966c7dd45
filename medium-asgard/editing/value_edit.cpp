#include "editing/value_edit.h"

#include "editing/number_text.h"
#include "editing/origin.h"
#include "editing/overrides.h"

#include "expression/tokens.h"
#include "script/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace editing {

using script::Command;
using script::Word;

std::string applied(const std::string& text, const std::vector<TextEdit>& edits) {
    std::string result;
    std::size_t at = 0;
    for (const TextEdit& edit : edits) {
        result += text.substr(at, edit.from - at) + edit.text;
        at = edit.to;
    }
    return result + text.substr(at);
}

namespace {

// Options whose words are expressions of the scene language, one number each.
bool isExpression(Kind kind, const std::string& option) {
    static const std::set<std::string> components = {"-x", "-y", "-z"};
    return (kind == Kind::force || kind == Kind::link) && components.contains(option);
}

bool same(double a, double b, double resolution) {
    return resolution > 0 ? std::abs(a - b) < 0.5 * resolution : a == b;
}

std::string listText(const std::vector<double>& values, double resolution) {
    std::string text;
    for (const double value : values)
        text += (text.empty() ? "" : " ") + numberText(value, resolution);
    return values.size() == 1 ? text : "{" + text + "}";
}

// One wish on the way through one text.
class Edit {
public:
    Edit(std::string_view text, const script::Structure& structure, const scene::Scene& scene,
         const Mapper::Factor& factor, const scene::Source& source, std::string subject,
         const Wish& wish)
        : text_(text), structure_(structure), scene_(scene), factor_(factor), source_(source),
          subject_(std::move(subject)), wish_(wish), origins_(text, structure, scene) {}

    Answer answer(const std::string& name, std::size_t together);

private:
    [[nodiscard]] Answer refuse(const std::string& what, scene::Range cause) const;
    [[nodiscard]] Answer insert() const;
    [[nodiscard]] Answer rewrite(const std::vector<Origin>& origins) const;
    [[nodiscard]] Origin inExpression(const Command& command, const Word& word) const;
    [[nodiscard]] std::optional<Origin> ofFactor(const Command& command,
                                                 scene::Range content) const;
    [[nodiscard]] Origin ofName(const Command& command, const std::string& name,
                                scene::Range where) const;

    std::string_view text_;
    const script::Structure& structure_;
    const scene::Scene& scene_;
    const Mapper::Factor& factor_;
    const scene::Source& source_;
    std::string subject_;
    const Wish& wish_;
    Origins origins_;
};

Answer Edit::refuse(const std::string& what, scene::Range cause) const {
    Answer answer;
    answer.reason = wish_.option + " of " + subject_ + " " + what + ".";
    answer.cause = cause;
    return answer;
}

Answer Edit::insert() const {
    if (!wish_.path.empty())
        return refuse("is not in the text", source_.command);
    if (wish_.absent.size() == wish_.values.size() &&
        std::equal(wish_.values.begin(), wish_.values.end(), wish_.absent.begin(),
                   [&](double a, double b) { return same(a, b, wish_.resolution); }))
        return {};
    Answer answer;
    answer.edits.push_back({source_.command.to, source_.command.to,
                            " " + wish_.option + " " + listText(wish_.values, wish_.resolution)});
    return answer;
}

Answer Edit::rewrite(const std::vector<Origin>& origins) const {
    if (origins.size() == 1 && !origins.front().reason.empty())
        return refuse(origins.front().reason, origins.front().cause);
    if (origins.size() < wish_.values.size())
        return refuse("is not written as " + std::to_string(wish_.values.size()) + " numbers",
                      source_.command);
    Answer answer;
    for (std::size_t i = 0; i < wish_.values.size(); ++i) {
        const Origin& origin = origins[i];
        if (!origin.reason.empty()) {
            // What cannot be written may still be what it is to be.
            return refuse(origin.reason, origin.cause);
        }
        const std::string before = origins_.slice(origin.literal);
        const auto old = script::decimalNumber(before);
        const double wanted = wish_.values[i] / origin.factor;
        const double resolution = wish_.resolution / std::abs(origin.factor);
        if (!old || same(*old, wanted, resolution))
            continue;
        const TextEdit edit = {origin.literal.from, origin.literal.to,
                               numberText(wanted, resolution, before)};
        const auto clash = std::ranges::find_if(
            answer.edits, [&](const TextEdit& other) { return other.from == edit.from; });
        if (clash == answer.edits.end())
            answer.edits.push_back(edit);
        else if (clash->text != edit.text)
            return refuse("has one number of the text, $" + origin.variable +
                              ", in two places, which cannot become different",
                          origin.literal);
    }
    std::ranges::sort(answer.edits, {}, &TextEdit::from);
    return answer;
}

// --- expressions: NUMBER, NUMBER * NAME, NAME * NUMBER, PARAMETER -----------------------------

Origin Edit::ofName(const Command&, const std::string& name, scene::Range where) const {
    for (const scene::Parameter& parameter : scene_.parameters) {
        if (parameter.name != name)
            continue;
        const Command* command = structure_.startingAt(parameter.source.command.from);
        for (const scene::Argument& argument : parameter.source.arguments)
            for (const Word& word : command ? command->words : std::vector<Word>())
                if (argument.option == "-value" && word.range == argument.word) {
                    Origin origin = origins_.ofScalar(*command, word);
                    origin.variable = name;
                    return origin;
                }
    }
    Origin origin;
    origin.reason = "is the expression " + origins_.slice(where) + ", which stays as it is";
    origin.cause = where;
    return origin;
}

std::optional<Origin> Edit::ofFactor(const Command& command, scene::Range content) const {
    const std::string text = origins_.slice(content);
    expression::Tokens tokens(text);
    using expression::TokenKind;
    std::vector<expression::Token> all;
    for (; tokens.now().kind != TokenKind::end && all.size() < 8; tokens.advance())
        all.push_back(tokens.now());
    if (tokens.fault())
        return std::nullopt;
    std::size_t at = 0;
    Origin origin;
    std::optional<std::string> name;
    const auto number = [&] {
        const bool minus = at < all.size() && all[at].text == "-";
        const std::size_t digits = at + (minus ? 1 : 0);
        if (digits >= all.size() || all[digits].kind != TokenKind::number)
            return false;
        // A blank between the minus and its number is theirs too.
        origin.literal = {content.from + all[at].from, content.from + all[digits].to};
        if (minus && all[digits].from != all[at].to)
            return false;
        at = digits + 1;
        return true;
    };
    const auto factor = [&] {
        if (at >= all.size() || all[at].kind != TokenKind::name)
            return false;
        std::size_t end = at + 1;
        while (end + 1 < all.size() && all[end].text == "." && all[end + 1].kind == TokenKind::name)
            end += 2;
        name = text.substr(all[at].from, all[end - 1].to - all[at].from);
        at = end;
        return true;
    };
    const auto times = [&] { return at < all.size() && all[at].text == "*" && ++at; };
    const bool read = number() ? at == all.size() || (times() && factor())
                               : factor() && (at == all.size() || (times() && number()));
    if (!read || at != all.size())
        return std::nullopt;
    if (!name)
        return origin;
    if (!origin.literal.known())
        return ofName(command, *name, content);
    const auto value = factor_ ? factor_(*name) : std::nullopt;
    if (!value || *value == 0 || !std::isfinite(*value))
        return std::nullopt;
    origin.factor = *value;
    return origin;
}

Origin Edit::inExpression(const Command& command, const Word& word) const {
    if (!word.literal || word.expanded)
        return origins_.ofScalar(command, word);
    if (auto origin = ofFactor(command, word.content))
        return *origin;
    Origin origin;
    origin.reason = "is the expression " + origins_.slice(word.range) + ", which stays as it is";
    origin.cause = word.range;
    return origin;
}

// ---------------------------------------------------------------------------------------------

Answer Edit::answer(const std::string& name, std::size_t together) {
    const Command* command =
        source_.command.known() ? structure_.startingAt(source_.command.from) : nullptr;
    if (!command)
        return refuse("does not stand in the text: the command of line " +
                          std::to_string(source_.line) + " makes it of other text",
                      source_.command);
    if (source_.runs != 1) {
        const Command* maker = origins_.makerOf(*command);
        Answer answer =
            refuse("is one of " + std::to_string(together) + " that line " +
                       std::to_string(origins_.lineOf(command->range.from)) + " makes" +
                       (maker ? ", in the " +
                                    std::string(maker->name(text_) == "proc" ? "procedure"
                                                                             : maker->name(text_)) +
                                    " of line " + std::to_string(origins_.lineOf(maker->range.from))
                              : ""),
                   maker ? maker->words.front().range : command->range);
        answer.offers = offersFor({*command, source_, name, together}, wish_, origins_);
        return answer;
    }
    for (const scene::Argument& argument : source_.arguments) {
        if (argument.option != wish_.option)
            continue;
        const auto word = std::ranges::find_if(
            command->words, [&](const Word& one) { return one.range == argument.word; });
        if (word == command->words.end())
            return refuse("is computed", argument.word);
        if (isExpression(wish_.element.kind, wish_.option))
            return rewrite({inExpression(*command, *word)});
        if (wish_.values.size() == 1 && wish_.path.empty())
            return rewrite({origins_.ofScalar(*command, *word)});
        return rewrite(origins_.ofList(*command, *word, wish_.path));
    }
    return insert();
}

template <class List> const scene::Source* sourceIn(const List& list, std::size_t index) {
    return index < list.size() ? &list[index].source : nullptr;
}

} // namespace

Mapper::Mapper(std::string text, std::shared_ptr<const scene::Scene> scene, Factor factor)
    : text_(std::move(text)), scene_(std::move(scene)), factor_(std::move(factor)),
      structure_(script::structureOf(text_)) {}

const scene::Source* Mapper::sourceOf(const Element& element) const {
    switch (element.kind) {
    case Kind::simulator:
        return scene_->simulator.source ? &*scene_->simulator.source : nullptr;
    case Kind::shapeSet:
        return sourceIn(scene_->shapeSets, element.index);
    case Kind::body:
        return sourceIn(scene_->bodies, element.index);
    case Kind::force:
        return sourceIn(scene_->forces, element.index);
    case Kind::link:
        return sourceIn(scene_->links, element.index);
    case Kind::trajectory:
        return sourceIn(scene_->trajectories, element.index);
    case Kind::constraint:
        return sourceIn(scene_->constraints, element.index);
    case Kind::light:
        return sourceIn(scene_->lights, element.index);
    case Kind::view:
        return sourceIn(scene_->views, element.index);
    case Kind::parameter:
        return sourceIn(scene_->parameters, element.index);
    case Kind::plot:
        break;
    }
    return sourceIn(scene_->plots, element.index);
}

namespace {

std::string bareName(const scene::Scene& scene, const Element& element) {
    switch (element.kind) {
    case Kind::shapeSet:
        return scene.shapeSets[element.index].name;
    case Kind::body:
        return scene.bodies[element.index].name;
    case Kind::trajectory:
        return scene.trajectories[element.index].name;
    case Kind::light:
        return scene.lights[element.index].name;
    case Kind::view:
        return scene.views[element.index].name;
    case Kind::parameter:
        return scene.parameters[element.index].name;
    case Kind::plot:
        return scene.plots[element.index].name;
    default:
        return "";
    }
}

const char* wordOf(Kind kind) {
    constexpr const char* words[] = {"simulator", "shape set",  "body",       "force",
                                     "link",      "trajectory", "constraint", "light",
                                     "view",      "parameter",  "plot"};
    return words[static_cast<std::size_t>(kind)];
}

} // namespace

std::string Mapper::nameOf(const Element& element) const {
    const scene::Source* source = sourceOf(element);
    const std::string name = source ? bareName(*scene_, element) : "";
    if (!name.empty())
        return std::string(wordOf(element.kind)) + " \"" + name + "\"";
    return "the " + std::string(wordOf(element.kind)) +
           (source && source->line > 0 ? " of line " + std::to_string(source->line) : "");
}

Answer Mapper::answer(const Wish& wish) const {
    const scene::Source* source = sourceOf(wish.element);
    if (!source) {
        Answer answer;
        answer.reason = "The scene has no such " + std::string(wordOf(wish.element.kind)) + ".";
        return answer;
    }
    return Edit(text_, structure_, *scene_, factor_, *source, nameOf(wish.element), wish)
        .answer(bareName(*scene_, wish.element), static_cast<std::size_t>(source->runs));
}

} // namespace editing
