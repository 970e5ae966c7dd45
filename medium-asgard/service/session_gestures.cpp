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
        if (auto refused = gesture_.handles.takeRefused())
            keepWays(ground(), std::move(refused->label), std::move(refused->ways), true);
        return input.type != InputType::wheel;
    }
    if (input.type == InputType::move || input.type == InputType::release)
        openCrowd(rendition, pixels);
    return choose(rendition, input, pointer) ||
           (input.type == InputType::press && with(ipc::Modifier::shift) &&
            hold(rendition, input, std::nullopt, pointer));
}

void Session::openCrowd(Rendition& rendition, const Eigen::Vector2d& pixels) {
    if (!subdocument_.scene() || rendition.beingTurned() ||
        !render::showsHandles(rendition.display))
        return;
    const HandleEditing::Picture picture = pictureOf(rendition);
    const auto handles =
        gesture_.handles.handles(subdocument_.scene(), picture.drawing, picture.size);
    rendition.display.opened =
        gestures::crowdAt(*handles, pixels, gestures::handleReach * picture.scale);
}

HandleEditing::Picture Session::pictureOf(Rendition& rendition) {
    const Playback& playback = subdocument_.playback;
    shown_.time = playback.time(at_.now);
    rendition.see(drawnScene(), subdocument_.motion(), subdocument_.viewGeneration());
    HandleEditing::Picture picture{drawingOf(lookOf(rendition)), rendition.size(),
                                   rendition.scale()};
    if (playback.playing() && !subdocument_.motionIsStale())
        picture.rate = playback.rate();
    return picture;
}

// The scene in the picture must be the text's, and no other change be on its way to the host.
bool Session::hold(Rendition& rendition, const ipc::Input& input, std::optional<std::size_t> body,
                   const HandleEditing::Pointer& pointer) {
    const auto button = buttonOf(input.button);
    if (!subdocument_.scene() || !subdocument_.upToDate() || subdocument_.previewing() ||
        (!body && !button))
        return false;
    const HandleEditing::Picture picture = pictureOf(rendition);
    if (body ? !gesture_.handles.pressBody(ground(), picture, *body, pointer)
             : !gesture_.handles.press(ground(), picture, *button, pointer))
        return false;
    Playback& playback = subdocument_.playback;
    if (const auto moment = gesture_.handles.moment()) {
        playback.pause(at_.now);
        playback.seek(*moment, at_.now);
        gesture_.holdsTime = true;
    }
    gesture_.toldWords.clear(); // the same words are said again, of another gesture
    gesture_.ways.reset();
    rendition.holdView(shown_.time);
    gesture_.in = input.rendition;
    return true;
}

// A press turns the view only when the pointer leaves its place; where it does not, it is a click.
// A drag that begins on a body that is selected moves that.
bool Session::choose(Rendition& rendition, const ipc::Input& input,
                     const HandleEditing::Pointer& at) {
    using ipc::InputType;
    auto& press = gesture_.press;
    if (input.type == InputType::press) {
        press.reset();
        const bool isClick =
            input.button == ipc::Button::left || input.button == ipc::Button::right;
        if (isClick && input.modifiers.empty() && subdocument_.scene())
            press = Gesture::Press{input.rendition, at.pixels, input.button};
        return false;
    }
    if (!press || press->in != input.rendition)
        return false;
    constexpr double still = 4; // of the reader's pixels
    const bool isNear = (at.pixels - press->pixels).lpNorm<1>() < still * rendition.scale();
    if (input.type == InputType::move) {
        if (isNear)
            return true;
        const Gesture::Press began = *std::exchange(press, std::nullopt);
        if (began.button != ipc::Button::left)
            return false;
        const HandleEditing::Picture picture = pictureOf(rendition);
        const auto body =
            gestures::selectedBodyAt(picture.drawing, {picture.drawing.camera, picture.size},
                                     began.pixels, gesture_.selection.elements());
        HandleEditing::Pointer from = at;
        from.pixels = began.pixels;
        if (!body || !hold(rendition, input, body, from))
            return false;
        ipc::Input letGo = input; // the view does not turn
        letGo.type = InputType::release;
        letGo.button = began.button;
        rendition.input(letGo, shown_.time, render::upOf(drawnScene()));
        gesture_.handles.move(at);
        return true;
    }
    if (input.type != InputType::release || input.button != press->button)
        return false;
    press.reset();
    if (!isNear || !subdocument_.scene())
        return false;
    const HandleEditing::Picture picture = pictureOf(rendition);
    const gestures::Sight sight{picture.drawing.camera, picture.size};
    const auto handles =
        gesture_.handles.handles(subdocument_.scene(), picture.drawing, picture.size);
    const render::HandleSet& shown = handles ? *handles : render::HandleSet();
    gesture_.selection.follow(subdocument_.scene(), subdocument_.sceneText());
    if (input.button == ipc::Button::left)
        gesture_.selection.click(picture.drawing, shown, sight, at.pixels, picture.scale);
    else
        gesture_.selection.point(picture.drawing, shown, sight, at.pixels, picture.scale);
    tellMenu();   // before what is asked next is answered
    return false; // the view hears of it too
}

bool Session::selectionKey(const std::string& name) {
    if (gesture_.selection.empty() || (name != "Delete" && name != "Escape"))
        return false;
    if (name == "Escape")
        gesture_.selection.clear();
    else
        changeSelected(true);
    return true;
}

void Session::changeSelected(bool isRemoved) {
    Selection& selection = gesture_.selection;
    if (selection.empty() || gesture_.handles.active())
        return;
    if (!subdocument_.upToDate() || subdocument_.previewing())
        return tellUser(beingRead);
    selection.follow(subdocument_.scene(), subdocument_.sceneText());
    holdViews();
    tellUser(isRemoved ? selection.remove(ground()) : selection.duplicate(ground()));
}

// What else there is stays where it is seen.
void Session::holdViews() {
    for (auto& [id, rendition] : shown_.all)
        if (rendition.presentation() == Presentation::picture)
            rendition.holdView(shown_.time);
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
    channel_.notify(
        ipc::ProgressEnd{token, "Click selects, then a drag moves it  \u00b7  Right button: "
                                "menu  \u00b7  " +
                                    what + "  \u00b7  Space plays"});
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
