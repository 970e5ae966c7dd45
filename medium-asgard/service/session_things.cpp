// What is done with the selected thing of a picture, and what is offered in place of what cannot
// be.
#include "service/session.h"

#include <cstdlib>

namespace service {

// Not of every menu: of what is selected now, of a fault that is there now.
auto Session::invokeOfTheMoment(const ipc::MenuInvoke& call) -> Reply<ipc::Invoked> {
    if (call.id == "open-graphical-viewer" || call.id == "open-language-viewer" ||
        call.id == updateDrafts || call.id.starts_with(openThing + " "))
        return openWindow(call); // in a process that replaces this one nothing is selected
    if (call.id == closeJoints)
        return closeJointsOrStop();
    if (call.id.starts_with(wayPrefix))
        return takeWay(std::strtoul(call.id.c_str() + wayPrefix.size(), nullptr, 10));
    Selection& selection = gesture_.selection;
    if (const auto commands = selection.commands(subdocument_.motion()))
        for (const ThingCommand& one : *commands)
            if (call.id == idOf(one, selection.name()))
                return doNow(one, selection.name(), {call.values, call.isTrial});
    if (const auto asked = gesture_.asked;
        asked && !call.values.empty() && call.id == idOf(asked->command, asked->name))
        return doNow(asked->command, asked->name, {call.values, call.isTrial});
    return ipc::Error{ipc::ErrorCode::invalidParameters,
                      "there is no menu entry \"" + call.id + "\""};
}

auto Session::openWindow(const ipc::MenuInvoke& call) -> Reply<ipc::Invoked> {
    if (!platform_.openViewer)
        return notPossible("windows are opened by a process in mode \"edit\"");
    if (const auto sentence = platform_.openViewer(call.id, call.figure))
        return notPossible(*sentence);
    return ipc::Invoked{};
}

void Session::tellUser(const std::string& sentence) {
    gesture_.toldWords.clear();
    gesture_.handles.tell(sentence); // "": what was said before is over
}

auto Session::doNow(const ThingCommand& command, const std::string& name, const Typed& typed)
    -> Reply<ipc::Invoked> {
    if (!typed.isTrial && (command.key == deleteThing || command.key == duplicateThing)) {
        changeSelected(command.key == deleteThing);
        return ipc::Invoked{};
    }
    if (gesture_.handles.active() || !subdocument_.upToDate() || subdocument_.previewing())
        return notPossible(beingRead);
    gesture_.selection.follow(subdocument_.scene(), subdocument_.sceneText());
    const auto element = thingCalled(*subdocument_.scene(), name);
    if (!element)
        return notPossible("There is no " + name + " any more.");
    gesture_.asked = {command, name};
    return doWith(command, *element, typed);
}

auto Session::doWith(const ThingCommand& command, const editing::Element& element,
                     const Typed& typed) -> Reply<ipc::Invoked> {
    const gestures::Ground on = ground();
    if (!typed.isTrial)
        holdViews();
    if (const auto asked = askedBy(command, on, element))
        return answerAsked(on, *asked, typed);
    if (typed.isTrial)
        return notPossible("That is not asked any more.");
    if (command.key == fixThing)
        return fix(on, element.index);
    if (const auto plot = plotBy(command, on, element)) {
        on.finish(text::applied(on.text, plot->edits), "New Plot");
        tellUser("The scene has the plot " + plot->name +
                 ": a figure that is shown as its charts has it (Figure, Show As).");
        return ipc::Invoked{};
    }
    if (const auto changed = besideBy(command, on, element)) {
        if (!changed->answer.possible())
            return notPossible(changed->answer.reason);
        on.finish(text::applied(on.text, changed->answer.edits), changed->label);
        return ipc::Invoked{};
    }
    return notPossible("That is not there any more.");
}

auto Session::answerAsked(const gestures::Ground& on, const commands::AskedValue& asked,
                          const Typed& typed) -> Reply<ipc::Invoked> {
    ipc::Question question = questionOf(asked, typed.values);
    if (typed.values.empty()) { // can it be changed at all?
        question.refusal = asked.answer(asked.now).reason;
        return ipc::Invoked{std::move(question)};
    }
    const auto wanted = commands::typedNumbers(asked, typed.values);
    if (!wanted) {
        question.refusal = "Decimal numbers, please.";
        return ipc::Invoked{std::move(question)};
    }
    editing::Answer answer = *wanted == asked.now ? editing::Answer() : asked.answer(*wanted);
    if (answer.possible() && typed.isTrial) {
        question.changes = changesOf(on.text, answer.edits);
        return ipc::Invoked{std::move(question)};
    }
    if (answer.possible()) {
        if (!answer.edits.empty())
            on.finish(text::applied(on.text, answer.edits), asked.label);
        return ipc::Invoked{};
    }
    question.refusal = answer.reason;
    keepWays(on, asked.label, std::move(answer.offers), false);
    for (std::size_t i = 0; i < gesture_.ways->all.size(); ++i)
        question.ways.push_back({wayPrefix + std::to_string(i), gesture_.ways->all[i].label});
    return ipc::Invoked{std::move(question)};
}

auto Session::fix(const gestures::Ground& on, std::size_t body) -> Reply<ipc::Invoked> {
    if (std::string why = commands::whyNotFixed(*on.scene, body); !why.empty())
        return notPossible(std::move(why));
    const commands::AskedValue asked = commands::askedFixed(on, body);
    return answerAsked(on, asked, {{asked.now.front() == 0 ? "1" : "0"}});
}

// --- ways ---------------------------------------------------------------------------------------

void Session::keepWays(const gestures::Ground& on, std::string label,
                       std::vector<editing::Offer> offers, bool inMenu) {
    gesture_.ways = {on, subdocument_.revision(), std::move(label), std::move(offers), inMenu};
}

auto Session::takeWay(std::size_t number) -> Reply<ipc::Invoked> {
    const auto ways = std::exchange(gesture_.ways, std::nullopt);
    if (!ways || ways->revision != subdocument_.revision() || number >= ways->all.size())
        return notPossible("The text was changed meanwhile: nothing is done.");
    holdViews();
    ways->ground.finish(text::applied(ways->ground.text, ways->all[number].edits), ways->label);
    return ipc::Invoked{};
}

// --- open joints, and bodies that overlap --------------------------------------------------------

std::string Session::offerToClose() const {
    if (gesture_.closing.runs())
        return "Stop Moving Bodies";
    if (!subdocument_.upToDate() || subdocument_.previewing())
        return told_.menu ? told_.menu->closing : std::string();
    const commands::Misplaced misplaced = commands::misplacedIn(subdocument_.faults());
    return misplaced == commands::Misplaced() ? std::string() : commands::labelOf(misplaced);
}

auto Session::closeJointsOrStop() -> Reply<ipc::Invoked> {
    if (gesture_.closing.runs()) {
        gesture_.closing.stop();
        gesture_.closingOn.reset();
        tellUser("Stopped: all bodies are where they were.");
        return ipc::Invoked{};
    }
    if (gesture_.handles.active() || !subdocument_.upToDate() || subdocument_.previewing())
        return notPossible(beingRead);
    gesture_.closingOn = ground();
    gesture_.closing.start(subdocument_.text(), subdocument_.scene(),
                           [this] { subdocument_.wake(); });
    return ipc::Invoked{};
}

void Session::takeClosed() {
    const auto found = gesture_.closing.take();
    if (!found)
        return;
    const gestures::Ground on = *std::exchange(gesture_.closingOn, std::nullopt);
    if (on.text != subdocument_.text())
        return tellUser("The text has changed meanwhile: try again.");
    if (!found->reason.empty())
        return tellUser(found->reason);
    holdViews();
    on.finish(found->text, commands::labelOf(commands::misplacedIn(subdocument_.faults())));
}

} // namespace service
