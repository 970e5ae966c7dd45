#include "editing/value_edit.h"

#include "editing/number_text.h"
#include "editing/origin.h"
#include "editing/overrides.h"

#include "expression/tokens.h"
#include "script/numbers.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

namespace editing {

using script::Command;
using script::Word;

namespace {

// Options whose words are expressions of the scene language, one number each.
bool isExpression(Kind kind, const std::string& option) {
    static const std::set<std::string> components = {"-x", "-y", "-z"};
    return (kind == Kind::force || kind == Kind::link) && components.contains(option);
}

bool same(double a, double b, double resolution) {
    return resolution > 0 ? std::abs(a - b) < 0.5 * resolution : a == b;
}

// Up to what a text's decimals and a division by a mass may lose.
bool nearly(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(1.0, std::abs(b)); }

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

    Answer answer(const std::string& name, std::size_t together, std::size_t which);
    [[nodiscard]] std::size_t count() const;
    [[nodiscard]] std::vector<std::string> written() const;

private:
    [[nodiscard]] Answer refuse(const std::string& what, scene::Range cause) const;
    [[nodiscard]] Answer insert() const;
    [[nodiscard]] std::variant<text::Edit, Answer> number(const Origin& origin,
                                                          std::size_t which) const;
    [[nodiscard]] Answer rewrite(const std::vector<Origin>& origins) const;
    [[nodiscard]] bool isNow() const; // nothing is to change
    // The parameter whose value stands there and may not become that.
    [[nodiscard]] const scene::Parameter* boundOn(scene::Range literal, double wanted) const;
    // The command and the word of the option, where they stand.
    [[nodiscard]] const Command* command() const;
    [[nodiscard]] const Word* word(const Command& command) const;
    [[nodiscard]] std::vector<Origin> originsOf(const Command& command, const Word& word) const;
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

// The number that stands there becomes the wish's; or why it cannot.
std::variant<text::Edit, Answer> Edit::number(const Origin& origin, std::size_t which) const {
    const double wish = wish_.values[which];
    const bool known = !wish_.now.empty();
    const std::string before = origins_.slice(origin.literal);
    const auto old = script::decimalNumber(before);
    if (!old)
        return refuse("is not written as a number", origin.literal);
    if (known && !nearly(*old * origin.factor, wish_.now[which]))
        return refuse("stands in the text as " + before + ", but is " +
                          numberText(wish_.now[which], 0),
                      origin.literal);
    const double wanted = wish / origin.factor;
    const double resolution = wish_.resolution / std::abs(origin.factor);
    if (const scene::Parameter* bound = boundOn(origin.literal, wanted))
        return refuse("comes from the parameter " + bound->name + ", which ends at " +
                          numberText(wanted < *old ? *bound->minimum : *bound->maximum, 0),
                      origin.literal);
    const bool stays = known && same(wish_.now[which], wish, wish_.resolution);
    return text::Edit{
        {origin.literal.from, origin.literal.to},
        stays || same(*old, wanted, resolution) ? before : numberText(wanted, resolution, before)};
}

Answer Edit::rewrite(const std::vector<Origin>& origins) const {
    if (origins.size() == 1 && !origins.front().reason.empty())
        return isNow() ? Answer{} : refuse(origins.front().reason, origins.front().cause);
    if (origins.size() < wish_.values.size())
        return refuse("is not written as " + std::to_string(wish_.values.size()) + " numbers",
                      source_.command);
    Answer answer;
    for (std::size_t i = 0; i < wish_.values.size(); ++i) {
        const Origin& origin = origins[i];
        if (!origin.reason.empty()) {
            if (!wish_.now.empty() && same(wish_.now[i], wish_.values[i], wish_.resolution))
                continue; // what cannot be written may still be what it is to be
            return refuse(origin.reason, origin.cause);
        }
        const auto number = this->number(origin, i);
        if (const auto* refusal = std::get_if<Answer>(&number))
            return *refusal;
        const text::Edit& edit = std::get<text::Edit>(number);
        const auto clash = text::startingAt(answer.edits, edit.range.from);
        if (clash == answer.edits.end())
            answer.edits.push_back(edit);
        else if (clash->text != edit.text)
            return refuse("has one number of the text, $" + origin.variable +
                              ", in two places, which cannot become different",
                          origin.literal);
    }
    std::erase_if(answer.edits, [&](const text::Edit& edit) {
        const bool keeps = edit.text == text_.substr(edit.range.from, edit.range.size());
        if (keeps)
            answer.kept.push_back({edit.range.from, edit.range.to});
        return keeps;
    });
    text::putInOrder(answer.edits);
    return answer;
}

const scene::Parameter* Edit::boundOn(scene::Range literal, double wanted) const {
    for (const scene::Parameter& parameter : scene_.parameters)
        for (const scene::Argument& argument : parameter.source.arguments)
            if (argument.option == "-value" && argument.word.from <= literal.from &&
                literal.to <= argument.word.to &&
                ((parameter.minimum && wanted < *parameter.minimum) ||
                 (parameter.maximum && wanted > *parameter.maximum)))
                return &parameter;
    return nullptr;
}

bool Edit::isNow() const {
    return wish_.now.size() == wish_.values.size() &&
           std::equal(wish_.values.begin(), wish_.values.end(), wish_.now.begin(),
                      [&](double a, double b) { return same(a, b, wish_.resolution); });
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

const Command* Edit::command() const {
    return source_.command.known() ? structure_.startingAt(source_.command.from) : nullptr;
}

const Word* Edit::word(const Command& command) const {
    for (const scene::Argument& argument : source_.arguments)
        if (argument.option == wish_.option)
            for (const Word& word : command.words)
                if (word.range == argument.word)
                    return &word;
    return nullptr;
}

std::vector<Origin> Edit::originsOf(const Command& command, const Word& word) const {
    if (isExpression(wish_.element.kind, wish_.option))
        return {inExpression(command, word)};
    if (wish_.values.size() == 1 && wish_.path.empty())
        return {origins_.ofScalar(command, word)};
    return origins_.ofList(command, word, wish_.path);
}

std::size_t Edit::count() const {
    const Command* command = this->command();
    const Word* word = command ? this->word(*command) : nullptr;
    if (!word)
        return 0;
    const std::vector<Origin> origins = origins_.ofList(*command, *word, wish_.path);
    return origins.size() == 1 && !origins.front().reason.empty() ? 0 : origins.size();
}

// What stands there: each number of a list, or the whole word.
std::vector<std::string> Edit::written() const {
    std::vector<std::string> texts(wish_.values.size());
    const Command* command = this->command();
    const Word* word = command ? this->word(*command) : nullptr;
    if (!word)
        return texts;
    const std::vector<Origin> origins = originsOf(*command, *word);
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const bool whole = origins.size() != texts.size() || texts.size() == 1;
        const scene::Range place = whole                       ? word->content
                                   : origins[i].reason.empty() ? origins[i].literal
                                                               : origins[i].cause;
        texts[i] = !whole && !origins[i].variable.empty() ? "$" + origins[i].variable
                                                          : origins_.slice(place);
    }
    return texts;
}

Answer Edit::answer(const std::string& name, std::size_t together, std::size_t which) {
    const Command* command = this->command();
    if (!command)
        return refuse("does not stand in the text: the command of line " +
                          std::to_string(source_.line) + " makes it of other text",
                      source_.command);
    if (source_.runs != 1 && isNow())
        return {};
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
        if (wish_.offers)
            answer.offers = offersFor({*command, source_, name, together, which}, wish_, origins_);
        return answer;
    }
    if (const Word* value = word(*command))
        return rewrite(originsOf(*command, *value));
    if (std::ranges::find(source_.arguments, wish_.option, &scene::Argument::option) !=
        source_.arguments.end())
        return isNow() ? Answer{} : refuse("is computed", command->range);
    return insert();
}

} // namespace

Mapper::Mapper(std::string text, std::shared_ptr<const scene::Scene> scene, Factor factor)
    : text_(std::move(text)), scene_(std::move(scene)), factor_(std::move(factor)),
      structure_(script::structureOf(text_)) {}

const scene::Source* Mapper::sourceOf(const Element& element) const {
    return editing::sourceOf(*scene_, element);
}

std::string Mapper::nameOf(const Element& element) const { return describe(*scene_, element); }

Answer Mapper::answer(const Wish& wish) const {
    const scene::Source* source = sourceOf(wish.element);
    if (!source) {
        Answer answer;
        answer.reason = "The scene has no such " + wordOf(wish.element.kind) + ".";
        return answer;
    }
    std::size_t which = 0; // of those that the same command made
    for (std::size_t i = 0; source->runs > 1 && i < wish.element.index; ++i)
        which += sourceOf({wish.element.kind, i})->command == source->command ? 1 : 0;
    return Edit(text_, structure_, *scene_, factor_, *source, nameOf(wish.element), wish)
        .answer(editing::nameOf(*scene_, wish.element), static_cast<std::size_t>(source->runs),
                which);
}

namespace {

// Offers that all refusals have, each with the changes of all.
std::vector<Offer> together(const std::vector<Answer>& answers) {
    std::vector<Offer> offers;
    const auto refused = std::ranges::find_if_not(answers, &Answer::possible);
    for (const Offer& first : refused->offers) {
        Offer whole{first.label, {}};
        const bool all = std::ranges::all_of(answers, [&](const Answer& answer) {
            const auto found = std::ranges::find(answer.offers, first.label, &Offer::label);
            if (!answer.possible() && found == answer.offers.end())
                return false;
            return std::ranges::all_of(
                answer.possible() ? answer.edits : found->edits,
                [&](const text::Edit& edit) { return text::join(whole.edits, edit); });
        });
        text::putInOrder(whole.edits);
        if (all)
            offers.push_back(std::move(whole));
    }
    return offers;
}

} // namespace

Answer Mapper::answer(const std::vector<Wish>& wishes) const {
    Answer whole;
    std::vector<Answer> answers;
    answers.reserve(wishes.size());
    for (const Wish& wish : wishes)
        answers.push_back(answer(wish));
    const auto refused = std::ranges::find_if_not(answers, &Answer::possible);
    if (refused != answers.end()) {
        whole = *refused;
        whole.offers = together(answers);
        return whole;
    }
    for (const Answer& one : answers)
        for (const text::Edit& edit : one.edits) {
            const bool keptElsewhere = std::ranges::any_of(answers, [&](const Answer& other) {
                return std::ranges::find(other.kept, edit.range.from, &scene::Range::from) !=
                       other.kept.end();
            });
            const auto clash = text::startingAt(whole.edits, edit.range.from);
            if (clash == whole.edits.end() && !keptElsewhere) {
                whole.edits.push_back(edit);
            } else if (!keptElsewhere && clash->range.empty() && edit.range.empty()) {
                clash->text += edit.text; // two new options
            } else if (keptElsewhere || clash->text != edit.text) {
                whole.reason = "One number of the text, " +
                               text_.substr(edit.range.from, edit.range.size()) +
                               ", cannot become two different ones.";
                whole.cause = {edit.range.from, edit.range.to};
                whole.edits.clear();
                return whole;
            }
        }
    text::putInOrder(whole.edits);
    return whole;
}

std::size_t Mapper::count(const Wish& wish) const {
    const scene::Source* source = sourceOf(wish.element);
    return source ? Edit(text_, structure_, *scene_, factor_, *source, "", wish).count() : 0;
}

std::vector<std::string> Mapper::written(const Wish& wish) const {
    const scene::Source* source = sourceOf(wish.element);
    return source ? Edit(text_, structure_, *scene_, factor_, *source, "", wish).written()
                  : std::vector<std::string>(wish.values.size());
}

} // namespace editing
