#include "service/offered_values.h"
#include "service/preferred_size.h"
#include "service/session.h"

#include "ipc/base64.h"

#include <algorithm>

namespace service {
namespace {

constexpr ipc::Integer protocolVersion = 1;
constexpr std::chrono::milliseconds settling{150}; // after the last movement of the user
constexpr std::size_t mostRenditions = 256, mostSubscriptions = 1000, mostWaiting = 1000;

ipc::Error faulty(std::string sentence) {
    return {ipc::ErrorCode::invalidParameters, std::move(sentence)};
}

const ipc::Error unknownPresentation =
    faulty("there are the presentations \"picture\", \"chart\" and \"text\"");
const ipc::Error unknownRendition = faulty("there is no such rendition");

} // namespace

// --- the subdocument --------------------------------------------------------------------------

auto Session::serve(const ipc::Initialize& call) -> Reply<ipc::Initialized> {
    if (host_.mode)
        return ipc::Error{ipc::ErrorCode::invalidRequest, "initialize comes only once"};
    if (call.oldest > protocolVersion || call.newest < protocolVersion) {
        host_.over = true;
        return ipc::Error{ipc::ErrorCode::noCommonVersion, "this medium speaks version 1"};
    }
    if (call.frames) {
        auto memory = FrameMemory::of(*call.frames);
        if (const auto* sentence = std::get_if<std::string>(&memory))
            return faulty(*sentence);
        shown_.memory = std::get<FrameMemory>(memory);
    }
    if (platform_.confine)
        platform_.confine(call.mode);
    host_.mode = call.mode;
    told_.menu = menuNow();
    ipc::Initialized answer;
    answer.protocol = protocolVersion;
    answer.name = "Asgard";
    answer.version = platform_.version;
    answer.capabilities = {"time", "parameters", "values", "script", "snapshot", "edit"};
    answer.menus = menuOf(*told_.menu);
    return answer;
}

auto Session::serve(const ipc::SubdocumentLoad& call) -> Reply<ipc::Done> {
    host_.title = call.title;
    gesture_.handles.drop();
    gesture_.holdsTime = false; // of another text
    subdocument_.load(call.text, call.revision, at_.now);
    return ipc::Done{};
}

auto Session::serve(const ipc::SubdocumentEdit& call) -> Reply<ipc::Done> {
    if (const auto sentence = subdocument_.edit(call.edits, call.revision, at_.now))
        return notPossible(*sentence);
    gesture_.handles.drop();
    return ipc::Done{};
}

// An edit that leaves the text as it is makes no revision: it is not for the host.
void Session::propose(const text::Edit& edit, const std::string& label,
                      std::function<void(std::optional<std::string>)> done) {
    ipc::SubdocumentChanged change{subdocument_.revision(), {edit}, label, ""};
    channel_.request(change, [this, edit, done](const ipc::Outcome<ipc::Revised>& outcome) {
        if (const auto* error = std::get_if<ipc::Error>(&outcome))
            return done(error->message);
        const auto revision = std::get<ipc::Revised>(outcome).revision;
        const auto sentence = subdocument_.edit({edit}, revision, at_.now);
        if (!sentence)
            gesture_.handles.drop();
        done(sentence);
    });
}

void Session::tellWindows(const ipc::WindowsChanged& windows) {
    host_.drafts = windows.drafts;
    channel_.notify(windows);
    tellMenu();
}

void Session::hear(const ipc::SessionRestore& call) {
    if (platform_.restoreWindows)
        platform_.restoreWindows(call.state, call.notice);
}

auto Session::serve(const ipc::PresentationList&) -> Reply<ipc::Presentations> {
    return presentations();
}

void Session::serve(const ipc::Id& id, const ipc::PresentationSize& call) {
    const auto presentation = presentationNamed(call.presentation);
    if (!presentation)
        return channel_.refuse(id, unknownPresentation);
    if (waiting_.size() >= mostWaiting)
        return channel_.refuse(id, notPossible("too many requests wait for the motion"));
    const auto size = [this, call, presentation] {
        if (presentation != Presentation::picture)
            return sheets_.preferredSize(*presentation, call.availableWidth, call.availableHeight);
        return preferredSize(subdocument_.scene().get(), subdocument_.motion(), call.availableWidth,
                             call.availableHeight);
    };
    waiting_.push_back({[this](Instant now) { return settled(now); },
                        [this, id, size] { channel_.answer(id, size()); }});
}

auto Session::serve(const ipc::PresentationExport& call) -> Reply<ipc::Exported> {
    return notPossible("this version of the medium exports no " + call.format);
}

// --- renditions -------------------------------------------------------------------------------

std::optional<ipc::Error> Session::noPicture(Presentation of, ipc::Integer width,
                                             ipc::Integer height) const {
    if (!platform_.draw && of == Presentation::picture)
        return notPossible(platform_.noPictures);
    if (std::max(width, height) > platform_.maximumSize)
        return notPossible("a picture is at most " + std::to_string(platform_.maximumSize) +
                           " pixels wide and high here");
    return std::nullopt;
}

std::optional<std::string> Session::shape(Rendition& rendition,
                                          const ipc::RenditionGeometry& geometry) {
    std::array<std::shared_ptr<const MappedSlot>, 2> slots;
    if (shown_.memory && !geometry.slots.empty()) {
        if (geometry.slots.size() != slots.size())
            return "a rendition has two slots";
        for (std::size_t i = 0; i < slots.size(); ++i) {
            auto mapped = shown_.memory->map(geometry.slots[i], geometry.width, geometry.height);
            if (const auto* sentence = std::get_if<std::string>(&mapped))
                return *sentence;
            slots[i] = std::get<std::shared_ptr<const MappedSlot>>(mapped);
        }
    }
    rendition.shape(geometry, std::move(slots));
    return std::nullopt;
}

auto Session::serve(const ipc::RenditionCreate& call) -> Reply<ipc::Done> {
    const auto presentation = presentationNamed(call.presentation);
    if (!presentation)
        return unknownPresentation;
    if (const auto error = noPicture(*presentation, call.width, call.height))
        return *error;
    if (shown_.all.contains(call.rendition))
        return faulty("there is a rendition of that number already");
    if (shown_.all.size() >= mostRenditions)
        return notPossible("there are " + std::to_string(mostRenditions) + " renditions already");
    Rendition rendition;
    rendition.display = shown_.display;
    rendition.restore(call.state);
    rendition.toldState = rendition.state();
    if (const auto sentence = shape(rendition, call))
        return faulty(*sentence);
    shown_.all.emplace(call.rendition, std::move(rendition));
    return ipc::Done{};
}

// Answered when nothing is drawn into the slots of before: they are the host's then.
void Session::serve(const ipc::Id& id, const ipc::RenditionResize& call) {
    const auto found = shown_.all.find(call.rendition);
    if (found == shown_.all.end())
        return channel_.refuse(id, unknownRendition);
    const auto presentation = presentationNamed(call.presentation);
    if (!presentation)
        return channel_.refuse(id, unknownPresentation);
    if (const auto error = noPicture(*presentation, call.width, call.height))
        return channel_.refuse(id, *error);
    if (const auto sentence = shape(found->second, call))
        return channel_.refuse(id, faulty(*sentence));
    answerWhenFree(id, found->second);
}

void Session::serve(const ipc::Id& id, const ipc::RenditionDestroy& call) {
    const auto found = shown_.all.find(call.rendition);
    if (found == shown_.all.end())
        return channel_.refuse(id, unknownRendition);
    if (gesture_.handles.active() && gesture_.in == call.rendition)
        gesture_.handles.cancel();
    answerWhenFree(id, found->second);
    shown_.all.erase(found);
}

void Session::serve(const ipc::Id& id, const ipc::RenditionSnapshot& call) {
    const auto presentation = presentationNamed(call.presentation);
    if (!presentation)
        return channel_.refuse(id, unknownPresentation);
    if (waiting_.size() >= mostWaiting)
        return channel_.refuse(id, notPossible("too many requests wait for the motion"));
    const double time = call.time.value_or(subdocument_.playback.time(at_.now));
    waiting_.push_back({[this, time, presentation](Instant now) {
                            return knownAt(time, now) && sheets_.upToDate(*presentation) &&
                                   !pictures_.draws(this); // one after the other
                        },
                        [this, id, call] {
                            if (auto error = take(id, call))
                                channel_.refuse(id, *error);
                        }});
}

void Session::hear(const ipc::RenditionShow& call) {
    if (const auto found = shown_.all.find(call.rendition); found != shown_.all.end())
        found->second.visible = true;
}

void Session::hear(const ipc::RenditionHide& call) {
    if (const auto found = shown_.all.find(call.rendition); found != shown_.all.end()) {
        found->second.visible = false;
        takeBack(found->second);
    }
    if (gesture_.handles.active() && gesture_.in == call.rendition)
        gesture_.handles.finish(); // as when the focus goes: what was seen last is taken
}

void Session::hear(const ipc::RenditionAck& call) {
    if (const auto found = shown_.all.find(call.rendition); found != shown_.all.end())
        found->second.acknowledge(call.serial);
}

void Session::hear(const ipc::RenditionInput& call) {
    if (call.type == ipc::InputType::keyPress || call.type == ipc::InputType::keyRelease) {
        const bool press = call.type == ipc::InputType::keyPress;
        if (gesture_.handles.key(call.key, press))
            return;
        if (press && call.modifiers.empty() && selectionKey(call.key))
            return;
        if (!call.modifiers.empty() || !(press ? key(call.key) : usesKey(call.key)))
            channel_.notify(ipc::RenditionUnhandled{call});
        return;
    }
    const auto found = shown_.all.find(call.rendition);
    if (found == shown_.all.end())
        return;
    Rendition& rendition = found->second;
    if (rendition.presentation() != Presentation::picture)
        return inputToSheet(rendition, call);
    if (call.type == ipc::InputType::focusIn) {
        tellHint(rendition);
    } else if (call.type == ipc::InputType::focusOut) {
        gesture_.selection.clear();
        rendition.display.opened.reset();
    }
    if (edit(rendition, call))
        return;
    const bool before = rendition.beingTurned();
    if (rendition.input(call, subdocument_.playback.time(at_.now), render::upOf(drawnScene())))
        rendition.calmAt = at_.now + settling;
    if (rendition.beingTurned() != before)
        channel_.notify(ipc::RenditionCursor{call.rendition, before ? ipc::CursorShape::arrow
                                                                    : ipc::CursorShape::grabbing});
}

// The wheel moves a text; a button that is down on a chart takes time there.
void Session::inputToSheet(Rendition& rendition, const ipc::Input& input) {
    using ipc::InputType;
    const bool isText = rendition.presentation() == Presentation::text;
    constexpr double rowsOfANotch = 3;
    if (isText && input.type == InputType::wheel)
        rendition.row = sheets_.scrolled(rendition.row, -rowsOfANotch * input.dy, rendition.size(),
                                         rendition.scale());
    const bool isHeld =
        input.type == InputType::press
            ? input.button == ipc::Button::left
            : input.type == InputType::move &&
                  std::ranges::find(input.buttons, ipc::Button::left) != input.buttons.end();
    if (isText || !isHeld)
        return;
    subdocument_.playback.seek(sheets_.timeAt(input.x, rendition.size(), rendition.scale()),
                               at_.now);
    pace_.calmAt = at_.now + settling;
}

// --- time -------------------------------------------------------------------------------------

Playback& Session::playedByReader() {
    gesture_.holdsTime = false;
    return subdocument_.playback;
}

bool Session::usesKey(const std::string& name) {
    constexpr std::array used{" ",         "ArrowLeft", "ArrowRight", "ArrowUp",
                              "ArrowDown", "Home",      "End"};
    return std::ranges::find(used, name) != used.end();
}

bool Session::key(const std::string& name) {
    Playback& playback = subdocument_.playback;
    if (name == " ")
        playback.playing() ? playedByReader().pause(at_.now) : playedByReader().play(at_.now);
    else if (name == "ArrowLeft" || name == "ArrowRight")
        playedByReader().step(name == "ArrowLeft" ? -1 : 1, at_.now);
    else if (name == "ArrowDown" || name == "ArrowUp")
        playedByReader().step(name == "ArrowDown" ? -10 : 10, at_.now);
    else if (name == "Home" || name == "End")
        playback.seek(name == "Home" ? playback.span().start : playback.span().finish, at_.now);
    return usesKey(name);
}

auto Session::serve(const ipc::TimePlay&) -> Reply<ipc::Done> {
    playedByReader().play(at_.now);
    return ipc::Done{};
}

auto Session::serve(const ipc::TimePause&) -> Reply<ipc::Done> {
    playedByReader().pause(at_.now);
    return ipc::Done{};
}

auto Session::serve(const ipc::TimeSeek& call) -> Reply<ipc::Done> {
    subdocument_.playback.seek(call.time, at_.now);
    pace_.calmAt = at_.now + settling;
    return ipc::Done{};
}

auto Session::serve(const ipc::TimeRate& call) -> Reply<ipc::Done> {
    subdocument_.playback.setRate(call.rate, call.loop, at_.now);
    return ipc::Done{};
}

// --- menus ------------------------------------------------------------------------------------

std::vector<Rendition*> Session::targets(std::optional<ipc::Integer> rendition) {
    std::vector<Rendition*> all, visible;
    for (auto& [id, candidate] : shown_.all) {
        if (rendition == id)
            return {&candidate};
        all.push_back(&candidate);
        if (candidate.visible)
            visible.push_back(&candidate);
    }
    return visible.empty() ? all : visible;
}

auto Session::serve(const ipc::MenuInvoke& call) -> Reply<ipc::Invoked> {
    Playback& playback = subdocument_.playback;
    if (const auto rate = rateOf(call.id)) {
        playback.setRate(*rate, playback.loops(), at_.now);
    } else if (bool render::Display::*value = displaySwitch(call.id)) {
        const bool on = !(menuNow().display.*value);
        for (Rendition* rendition : targets(call.rendition))
            rendition->display.*value = on;
        if (!call.rendition || shown_.all.size() <= 1)
            shown_.display.*value = on;
    } else if (call.id == "play") {
        playedByReader().play(at_.now);
    } else if (call.id == "pause") {
        playedByReader().pause(at_.now);
    } else if (call.id == "stop") {
        playedByReader().stop(at_.now);
    } else if (call.id == "step") {
        playedByReader().step(1, at_.now);
    } else if (call.id == "loop") {
        playback.setRate(playback.rate(), !playback.loops(), at_.now);
    } else if (call.id == "reset-view") {
        for (Rendition* rendition : targets(call.rendition))
            rendition->follow("");
    } else if (call.id == "recompute") {
        subdocument_.recompute(at_.now);
    } else {
        return invokeOfTheMoment(call);
    }
    return ipc::Invoked{};
}

// --- parameters and values --------------------------------------------------------------------

auto Session::serve(const ipc::ParameterList&) -> Reply<ipc::Parameters> {
    ipc::Parameters list;
    if (!subdocument_.newestScene())
        return list;
    for (const scene::Parameter& parameter : subdocument_.newestScene()->parameters) {
        const auto set = subdocument_.parameters().find(parameter.name);
        const double value = set == subdocument_.parameters().end() ? parameter.value : set->second;
        list.items.push_back({parameter.name, value, parameter.minimum, parameter.maximum,
                              parameter.label, parameter.unit});
    }
    return list;
}

void Session::hear(const ipc::ParameterSet& call) {
    subdocument_.setParameter(call.name, call.value, at_.now);
}

auto Session::serve(const ipc::ValueList&) -> Reply<ipc::ValueOffers> {
    return subdocument_.newestScene() ? offeredValues(*subdocument_.newestScene())
                                      : ipc::ValueOffers{};
}

void Session::serve(const ipc::Id& id, const ipc::ValueRead& call) {
    if (waiting_.size() >= mostWaiting)
        return channel_.refuse(id, notPossible("too many requests wait for the motion"));
    const double time = call.time.value_or(subdocument_.playback.time(at_.now));
    waiting_.push_back({[this, time](Instant now) { return knownAt(time, now); },
                        [this, id, call] {
                            auto read = values(call.expressions, call.time);
                            if (const auto* error = std::get_if<ipc::Error>(&read))
                                channel_.refuse(id, *error);
                            else
                                channel_.answer(id, std::get<ipc::Values>(std::move(read)));
                        }});
}

auto Session::serve(const ipc::ValueSubscribe& call) -> Reply<ipc::Done> {
    if (subscriptions_.size() >= mostSubscriptions)
        return notPossible("there are " + std::to_string(mostSubscriptions) +
                           " subscriptions already");
    subscriptions_[call.id] = Subscription{call.expressions, std::nullopt, std::nullopt};
    told_.nextValues = at_.now;
    return ipc::Done{};
}

auto Session::serve(const ipc::ValueUnsubscribe& call) -> Reply<ipc::Done> {
    subscriptions_.erase(call.id);
    return ipc::Done{};
}

auto Session::serve(const ipc::ScriptEvaluate& call) -> Reply<ipc::Evaluated> {
    return evaluate(call.script);
}

} // namespace service
