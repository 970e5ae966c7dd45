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
                ifCurrent([&] { subdocument_.preview(text, now_); });
            },
            [=, this](const std::string& text, const std::string& label) {
                ifCurrent([&] { finishGesture(text, label); });
            }};
}

void Session::finishGesture(const std::string& text, const std::string& label) {
    if (text == subdocument_.text())
        return subdocument_.endPreview(now_);
    const text::Edit edit = text::difference(subdocument_.text(), text);
    subdocument_.preview(text, now_); // until the host has answered
    propose(edit, label, [this](const std::optional<std::string>& refusal) {
        if (!refusal)
            return;
        subdocument_.endPreview(now_);
        refusedWords_ = *refusal;
    });
}

bool Session::edit(Rendition& rendition, const ipc::Input& input) {
    using ipc::InputType;
    const Eigen::Vector2d pixels(input.x, input.y);
    const auto button = buttonOf(input.button);
    if (handles_.active()) {
        if (input.rendition != editedIn_)
            return false;
        if (input.type == InputType::move)
            handles_.move(pixels);
        else if (input.type == InputType::release && button)
            handles_.release(*button);
        else if (input.type == InputType::focusOut)
            handles_.finish();
        return input.type != InputType::wheel;
    }
    const bool shifted =
        std::ranges::find(input.modifiers, ipc::Modifier::shift) != input.modifiers.end();
    // What is held must be what the text says, and nothing else be on its way to the host.
    if (input.type != InputType::press || !button || !shifted || !subdocument_.scene() ||
        !subdocument_.upToDate() || subdocument_.previewing())
        return false;
    shownTime_ = subdocument_.playback.time(now_);
    rendition.see(drawnScene(), subdocument_.motion(), subdocument_.viewGeneration());
    if (!handles_.press(ground(), drawingOf(lookOf(rendition)), rendition.size(), rendition.scale(),
                        *button, pixels))
        return false;
    toldWords_.clear(); // the same words are said again, of another gesture
    rendition.holdView(shownTime_);
    editedIn_ = input.rendition;
    return true;
}

void Session::tellHint(const Rendition& rendition) {
    const std::string what = render::showsHandles(rendition.display)
                                 ? "Shift-drag changes what is under the pointer"
                                 : "Shift-drag moves a body";
    const ipc::Integer token = ++lastToken_;
    channel_.notify(ipc::ProgressBegin{token, "Editing", false});
    channel_.notify(ipc::ProgressEnd{token, "Drag turns the view, the wheel scales it  \u00b7  " +
                                                what + "  \u00b7  Space plays  \u00b7  " +
                                                "right button: menu"});
}

// What a drag says of itself goes to the host as the message of something that goes on.
void Session::tellGesture() {
    const std::string& words = refusedWords_.empty() ? handles_.words() : refusedWords_;
    if (words != toldWords_ && !words.empty()) {
        if (!gestureTold_) {
            gestureTold_ = ++lastToken_;
            channel_.notify(ipc::ProgressBegin{*gestureTold_, "Editing", false});
        }
        channel_.notify(ipc::ProgressReport{*gestureTold_, std::nullopt, words});
    }
    toldWords_ = words;
    if (gestureTold_ && !handles_.active()) {
        channel_.notify(ipc::ProgressEnd{*gestureTold_, words});
        gestureTold_.reset();
        refusedWords_.clear();
    }
}

} // namespace service
