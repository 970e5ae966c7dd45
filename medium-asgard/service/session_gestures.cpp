// Handles in a rendition: from the host's pointer to a change of the host's text.
#include "service/session.h"
#include "text/difference.h"

namespace service {

// While it is dragged the text is shown here only; when it is let go the host is asked for one
// change, which is one step of its undo. What was made of an older text is of no use for a newer.
gestures::Ground Session::ground() {
    const auto ifCurrent = [this, since = subdocument_.revision()](const auto& what) {
        if (subdocument_.revision() == since)
            what();
    };
    return {subdocument_.text(), subdocument_.scene(), subdocument_.motion(),
            [=, this](const std::string& text) {
                ifCurrent([&] { subdocument_.preview(text, at_.now); });
            },
            [=, this](const std::string& text, const std::string& label) {
                ifCurrent([&] { finishGesture(text, label); });
            }};
}

void Session::finishGesture(const std::string& text, const std::string& label) {
    if (text == subdocument_.text())
        return subdocument_.endPreview(at_.now);
    const text::Edit edit = text::difference(subdocument_.text(), text);
    subdocument_.preview(text, at_.now); // until the host has answered
    propose(edit, label, [this](const std::optional<std::string>& refusal) {
        if (!refusal)
            return;
        subdocument_.endPreview(at_.now);
        gesture_.refusedWords = *refusal;
    });
}

bool Session::edit(Rendition& rendition, const ipc::Input& input) {
    using ipc::InputType;
    const Eigen::Vector2d pixels(input.x, input.y);
    const auto button = buttonOf(input.button);
    const auto with = [&](ipc::Modifier key) {
        return std::ranges::find(input.modifiers, key) != input.modifiers.end();
    };
    const HandleEditing::Pointer pointer{
        pixels, std::chrono::duration<double>(at_.now.time_since_epoch()).count(),
        with(ipc::Modifier::control)};
    if (gesture_.handles.active()) {
        if (input.rendition != gesture_.in)
            return false;
        if (input.type == InputType::move)
            gesture_.handles.move(pointer);
        else if (input.type == InputType::release && button)
            gesture_.handles.release(*button, pointer);
        else if (input.type == InputType::focusOut)
            gesture_.handles.finish();
        return input.type != InputType::wheel;
    }
    // What is held must be what the text says, and nothing else be on its way to the host.
    if (input.type != InputType::press || !button || !with(ipc::Modifier::shift) ||
        !subdocument_.scene() || !subdocument_.upToDate() || subdocument_.previewing())
        return false;
    Playback& playback = subdocument_.playback;
    shown_.time = playback.time(at_.now);
    rendition.see(drawnScene(), subdocument_.motion(), subdocument_.viewGeneration());
    HandleEditing::Picture picture{drawingOf(lookOf(rendition)), rendition.size(),
                                   rendition.scale()};
    if (playback.playing() && !subdocument_.motionIsStale())
        picture.rate = playback.rate();
    if (!gesture_.handles.press(ground(), picture, *button, pointer))
        return false;
    if (const auto moment = gesture_.handles.moment()) {
        playback.pause(at_.now);
        playback.seek(*moment, at_.now);
        gesture_.holdsTime = true;
    }
    gesture_.toldWords.clear(); // the same words are said again, of another gesture
    rendition.holdView(shown_.time);
    gesture_.in = input.rendition;
    return true;
}

// A motion that played goes on from the moment, as soon as the one that follows is known.
void Session::goOn() {
    if (gesture_.handles.active() || !subdocument_.upToDate() || !subdocument_.motion() ||
        subdocument_.motionIsStale() || !std::exchange(gesture_.holdsTime, false))
        return;
    subdocument_.playback.play(at_.now);
}

void Session::tellHint(const Rendition& rendition) {
    const std::string what = render::showsHandles(rendition.display)
                                 ? "Shift-drag changes what is under the pointer"
                                 : "Shift-drag moves a body, or throws it while it plays";
    const ipc::Integer token = ++progress_.lastToken;
    channel_.notify(ipc::ProgressBegin{token, "Editing", false});
    channel_.notify(ipc::ProgressEnd{token, "Drag turns the view, the wheel scales it  \u00b7  " +
                                                what + "  \u00b7  Space plays  \u00b7  " +
                                                "right button: menu"});
}

// What a drag says of itself goes to the host as the message of something that goes on.
void Session::tellGesture() {
    const std::string& words =
        gesture_.refusedWords.empty() ? gesture_.handles.words() : gesture_.refusedWords;
    if (words != gesture_.toldWords && !words.empty()) {
        if (!gesture_.token) {
            gesture_.token = ++progress_.lastToken;
            channel_.notify(ipc::ProgressBegin{*gesture_.token, "Editing", false});
        }
        channel_.notify(ipc::ProgressReport{*gesture_.token, std::nullopt, words});
    }
    gesture_.toldWords = words;
    if (gesture_.token && !gesture_.handles.active()) {
        channel_.notify(ipc::ProgressEnd{*gesture_.token, words});
        gesture_.token.reset();
        gesture_.refusedWords.clear();
    }
}

} // namespace service
