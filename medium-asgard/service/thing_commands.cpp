#include "service/thing_commands.h"

#include "commands/beside.h"
#include "element_edits/preview.h"
#include "gestures/handle_meaning.h"
#include "script/numbers.h"

#include <algorithm>

namespace service {

namespace {

using editing::Kind;

const std::string exactKey = "exact ", plotKey = "plot ", besideKey = "beside ", sizeKey = "size",
                  surfaceKey = "surface";

std::string capital(std::string words) {
    if (!words.empty() && words.front() >= 'a' && words.front() <= 'z')
        words.front() = static_cast<char>(words.front() - 'a' + 'A');
    return words;
}

// None of what only a motion tells, and no points of trajectories.
void addValues(std::vector<ThingCommand>& all, const std::shared_ptr<const scene::Scene>& scene,
               const simulation::MotionPointer& motion, const editing::Element& element) {
    const std::string group = "Exact Values";
    for (const render::Handle& one : commands::handlesOf(*scene, motion, element)) {
        const std::string quantity = gestures::quantityOf(*scene, one);
        all.push_back({exactKey + quantity, capital(quantity) + "\u2026", group});
    }
    if (element.kind != Kind::body)
        return;
    if (commands::askedSize({{}, scene, nullptr, {}, {}}, element.index))
        all.push_back({sizeKey, "Size\u2026", group});
    all.push_back({surfaceKey, "Surface\u2026", group});
}

} // namespace

std::vector<ThingCommand> commandsOf(const std::shared_ptr<const scene::Scene>& scene,
                                     const simulation::MotionPointer& motion,
                                     const editing::Element& element, const std::string& name) {
    std::vector<ThingCommand> all;
    addValues(all, scene, motion, element);
    const auto quantities = commands::quantitiesOf(*scene, element);
    for (const commands::Quantity& one : quantities)
        all.push_back({plotKey + commands::worded(one), commands::worded(one), "New Plot of"});
    for (const commands::Quantity& one : quantities)
        all.push_back({besideKey + commands::worded(one), commands::worded(one), "Show Beside It",
                       commands::isBeside(*scene, one)});
    if (element.kind == Kind::body)
        all.push_back({fixThing, "Fixed", {}, scene->bodies[element.index].fixed});
    all.push_back({duplicateThing, "Duplicate " + name});
    all.push_back({deleteThing, "Delete " + name});
    all.push_back(
        {.key = openThing, .label = "Open " + name + " in the Editor", .inWindows = true});
    return all;
}

std::optional<editing::Element> thingCalled(const scene::Scene& scene, const std::string& name) {
    for (int kind = 0; kind <= static_cast<int>(Kind::plot); ++kind)
        for (std::size_t i = 0; i < editing::countOf(scene, static_cast<Kind>(kind)); ++i)
            if (editing::describe(scene, {static_cast<Kind>(kind), i}) == name)
                return editing::Element{static_cast<Kind>(kind), i};
    return std::nullopt;
}

std::optional<commands::AskedValue> askedBy(const ThingCommand& command,
                                            const gestures::Ground& ground,
                                            const editing::Element& element) {
    if (command.key == sizeKey)
        return commands::askedSize(ground, element.index);
    if (command.key == surfaceKey)
        return commands::askedSurface(ground, element.index);
    if (!command.key.starts_with(exactKey))
        return std::nullopt;
    for (const render::Handle& one : commands::handlesOf(*ground.scene, ground.motion, element))
        if (command.key == exactKey + gestures::quantityOf(*ground.scene, one))
            return commands::askedOf(ground, one);
    return std::nullopt;
}

std::optional<NewPlot> plotBy(const ThingCommand& command, const gestures::Ground& ground,
                              const editing::Element& element) {
    const auto all = commands::quantitiesOf(*ground.scene, element);
    const auto one = std::ranges::find_if(all, [&](const commands::Quantity& quantity) {
        return command.key == plotKey + commands::worded(quantity);
    });
    if (one == all.end())
        return std::nullopt;
    const editing::NewElement plot =
        commands::plotOf(ground.text, *ground.scene, one->expression, one->name);
    return NewPlot{editing::created(ground.text, *ground.scene, {plot}), plot.name};
}

std::optional<Changed> besideBy(const ThingCommand& command, const gestures::Ground& ground,
                                const editing::Element& element) {
    for (const commands::Quantity& one : commands::quantitiesOf(*ground.scene, element))
        if (command.key == besideKey + commands::worded(one))
            return Changed{commands::withBeside(ground.text, ground.scene, one),
                           commands::labelOfBeside(*ground.scene, one)};
    return std::nullopt;
}

ipc::Question questionOf(const commands::AskedValue& asked, const std::vector<std::string>& typed) {
    ipc::Question question{asked.title, asked.note, {}, {}, {}, true};
    const std::vector<std::string> shown = commands::shownNumbers(asked);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const std::string& written = asked.written[i];
        const bool isComputed = !written.empty() && !script::decimalNumber(written);
        question.fields.push_back({asked.names[i] + (isComputed ? "  (" + written + ")" : ""),
                                   i < typed.size() ? typed[i] : shown[i]});
    }
    return question;
}

std::vector<ipc::ChangedLine> changesOf(const std::string& text, const text::Edits& edits) {
    constexpr std::size_t most = 20; // of lines that one reads
    std::vector<ipc::ChangedLine> changes;
    for (const editing::LineChange& one : editing::changedLines(text, edits))
        if (changes.size() < most)
            changes.push_back({one.line, one.before, one.after});
    return changes;
}

} // namespace service
