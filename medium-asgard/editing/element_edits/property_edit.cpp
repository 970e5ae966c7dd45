#include "element_edits/property_edit.h"

#include "editing/element_values.h"
#include "editing/number_text.h"
#include "element_edits/renaming.h"
#include "element_edits/words.h"
#include "scene/joint_types.h"
#include "script/numbers.h"

#include <algorithm>
#include <cctype>

namespace editing {

using script::Command;
using script::Word;

namespace {

// A coordinate's option has its number behind it where the type has several: -limits2. The list of
// options has it without a number, with 1 and with 2.
bool isOfType(const scene::Joint& joint, const CommandHint& command, std::string_view option) {
    const scene::JointTraits& traits = scene::traitsOf(joint.type);
    if (option == "-pitch")
        return joint.type == scene::JointType::screw;
    if (option == "-axis" || option == "-axis2")
        return traits.hasAxis;
    const bool isNumbered = option.ends_with('1') || option.ends_with('2') || option.ends_with('3');
    const std::string_view stem = isNumbered ? option.substr(0, option.size() - 1) : option;
    for (const char* number : {"", "1", "2"})
        if (!hintOf(command, std::string(stem) + number))
            return true;
    if (!(stem == "-from" ? traits.hasFrom : traits.hasDrives))
        return false;
    for (std::size_t i = 0; i < traits.coordinates.size(); ++i)
        if (std::string(stem) + scene::coordinateSuffix(joint.type, i) == option)
            return true;
    return false;
}

// A computed number without its last digits, which are the rounding's.
std::string numberShown(double value) {
    return numberText(value, decimalStep(1e-13 * std::max(1.0, std::abs(value))));
}

std::string joined(const std::vector<std::string>& parts) {
    std::string whole;
    for (const std::string& part : parts)
        whole += (whole.empty() ? "" : " ") + part;
    return whole;
}

std::optional<std::vector<double>> numbersOf(const std::vector<std::string>& parts) {
    std::vector<double> numbers;
    for (const std::string& part : parts) {
        const auto number = script::decimalNumber(part);
        if (!number)
            return std::nullopt;
        numbers.push_back(*number);
    }
    return numbers;
}

} // namespace

std::vector<const OptionHint*> optionsOf(const scene::Scene& scene, const Element& element) {
    std::vector<const OptionHint*> options;
    const CommandHint& command = hintOf(scene, element);
    for (const OptionHint& option : command.options)
        if (element.kind != Kind::joint ||
            isOfType(scene.joints[element.index], command, option.name))
            options.push_back(&option);
    return options;
}

std::vector<const OptionHint*> sharedOptions(const scene::Scene& scene,
                                             const std::vector<Element>& elements) {
    std::vector<const OptionHint*> shared;
    for (const Element& element : elements) {
        const std::vector<const OptionHint*> options = optionsOf(scene, element);
        if (element == elements.front())
            shared = options;
        std::erase_if(shared, [&](const OptionHint* one) {
            return std::ranges::none_of(options, [&](const OptionHint* other) {
                return one->name == other->name && one->wants == other->wants;
            });
        });
    }
    return shared;
}

Properties::Properties(std::string text, std::shared_ptr<const scene::Scene> scene,
                       Mapper::Factor factor)
    : text_(std::move(text)), scene_(std::move(scene)), structure_(script::structureOf(text_)),
      mapper_(text_, scene_, std::move(factor)) {}

// A body's shape may stand without its option, behind the name.
const Word* Properties::wordOf(const Element& element, const OptionHint& option,
                               const Command*& command) const {
    const scene::Source* source = sourceOf(*scene_, element);
    command =
        source && source->command.known() ? structure_.startingAt(source->command.from) : nullptr;
    if (!command)
        return nullptr;
    const bool byPlace = element.kind == Kind::body && option.name == "-shape";
    std::size_t unnamed = 0;
    for (const scene::Argument& argument : source->arguments) {
        const bool is = argument.option == option.name ||
                        (byPlace && argument.option.empty() && ++unnamed == 2);
        for (const Word& word : command->words)
            if (is && word.range == argument.word)
                return &word;
    }
    return nullptr;
}

PropertyValue Properties::valueOf(const Element& element, const OptionHint& option) const {
    PropertyValue value;
    const Command* command = nullptr;
    const Word* word = wordOf(element, option, command);
    const scene::Source* source = sourceOf(*scene_, element);
    const std::string name(option.name);
    value.isWritten =
        word || (source && std::ranges::find(source->arguments, name, &scene::Argument::option) !=
                               source->arguments.end());
    const std::string stands = word ? trimmed(slice(text_, word->content)) : "";
    if (!value.isWritten) {
        value.parts.assign(option.wants == Wants::vector ? 3 : 1, "");
    } else if (word && word->literal && option.wants == Wants::vector) {
        const script::ElementList list = script::elementsOf(stands);
        for (const script::Element& one : list.elements)
            value.parts.push_back(one.value);
        if (list.elements.size() != 3 || !list.fault.empty())
            value.parts = {stands};
    } else if (word && word->literal) {
        value.parts = {stands};
    } else if (const auto numbers = valuesOf(*scene_, element, name)) {
        for (const double number : *numbers)
            value.parts.push_back(numberShown(number));
        value.source = stands;
    } else if (const auto named = namedBy(*scene_, element, name)) {
        value.parts = {*named};
        value.source = stands;
    } else {
        value.parts = {stands};
    }
    return value;
}

std::vector<std::optional<std::string>>
Properties::sharedValue(const std::vector<Element>& elements, const OptionHint& option) const {
    std::vector<std::optional<std::string>> shared;
    for (const Element& element : elements) {
        const std::vector<std::string> parts = valueOf(element, option).parts;
        if (element == elements.front())
            shared.assign(parts.begin(), parts.end());
        if (parts.size() != shared.size())
            return {std::nullopt};
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (shared[i] != parts[i])
                shared[i].reset();
    }
    return shared;
}

Answer Properties::refused(const Element& element, const std::string& why) const {
    Answer answer;
    answer.reason = describe(*scene_, element) + " " + why;
    answer.reason.front() = static_cast<char>(std::toupper(answer.reason.front()));
    if (const scene::Source* source = sourceOf(*scene_, element))
        answer.cause = source->command;
    return answer;
}

Answer Properties::removed(const Element& element, const OptionHint& option) const {
    const Command* command = nullptr;
    if (const std::string why = whyNotAlone(text_, structure_, *scene_, element, command);
        !why.empty())
        return refused(element, why);
    const Word* word = wordOf(element, option, command);
    const auto at = static_cast<std::size_t>(word ? word - command->words.data() : 0);
    if (!word || word->fromList || at < 2 ||
        slice(text_, command->words[at - 1].range) != option.name)
        return refused(element, "needs it, or the text computes it.");
    Answer answer;
    answer.edits.push_back({{command->words[at - 2].range.to, word->range.to}, ""});
    return answer;
}

Answer Properties::written(const Element& element, const OptionHint& option,
                           const std::string& value) const {
    const auto asWord = wordFor(value);
    if (!asWord)
        return refused(element, "cannot have it: its braces or quotes do not match.");
    const Command* command = nullptr;
    if (const std::string why = whyNotAlone(text_, structure_, *scene_, element, command);
        !why.empty())
        return refused(element, why);
    Answer answer;
    if (const Word* word = wordOf(element, option, command))
        answer.edits.push_back({{word->range.from, word->range.to}, *asWord});
    else
        answer.edits.push_back({{command->range.to, command->range.to},
                                " " + std::string(option.name) + " " + *asWord});
    return answer;
}

Answer Properties::setOne(const Element& element, const OptionHint& option,
                          const std::vector<std::string>& parts) const {
    const PropertyValue old = valueOf(element, option);
    if (parts == old.parts)
        return {};
    const std::string whole = joined(parts);
    if (whole.empty())
        return old.isWritten ? removed(element, option) : Answer{};
    const auto numbers = numbersOf(parts);
    const bool isNumeric = option.wants == Wants::number || option.wants == Wants::vector ||
                           option.wants == Wants::integer || option.wants == Wants::flag ||
                           option.wants == Wants::expression;
    if (!numbers || !isNumeric || numbers->size() != old.parts.size() || !old.isWritten)
        return written(element, option, whole);
    Wish wish{element, std::string(option.name), {}, *numbers};
    if (const auto now = valuesOf(*scene_, element, wish.option);
        now && now->size() == numbers->size())
        wish.now = *now;
    Answer answer = mapper_.answer(wish);
    if (answer.possible())
        return answer;
    // A number typed over an expression is asked for; one of a loop is for all its elements.
    const scene::Source* source = sourceOf(*scene_, element);
    Answer direct = source && source->runs == 1 && answer.offers.empty()
                        ? written(element, option, whole)
                        : Answer{{}, "-", {}, {}, {}};
    return direct.possible() ? direct : answer;
}

Answer Properties::set(const std::vector<Element>& elements, const OptionHint& option,
                       const std::vector<std::optional<std::string>>& parts) const {
    Answer whole;
    for (const Element& element : elements) {
        std::vector<std::string> own = valueOf(element, option).parts;
        own.resize(parts.size());
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (parts[i])
                own[i] = trimmed(*parts[i]);
        // A vector begins with the parts that are typed.
        if (std::ranges::any_of(own, [](const auto& one) { return !one.empty(); }))
            std::ranges::replace(own, std::string(), std::string("0"));
        Answer answer = setOne(element, option, own);
        if (!answer.possible())
            return answer;
        for (const text::Edit& edit : answer.edits)
            if (!text::join(whole.edits, edit))
                return refused(element, "has its value from a place that others use too.");
    }
    text::putInOrder(whole.edits);
    return whole;
}

} // namespace editing
