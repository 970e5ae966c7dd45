#include "view/key_names.h"

#include <algorithm>
#include <array>
#include <utility>

namespace view {

namespace {

struct Named {
    int key;
    const char* name;
};

constexpr std::array named{
    Named{Qt::Key_Left, "ArrowLeft"},      Named{Qt::Key_Right, "ArrowRight"},
    Named{Qt::Key_Up, "ArrowUp"},          Named{Qt::Key_Down, "ArrowDown"},
    Named{Qt::Key_PageUp, "PageUp"},       Named{Qt::Key_PageDown, "PageDown"},
    Named{Qt::Key_Home, "Home"},           Named{Qt::Key_End, "End"},
    Named{Qt::Key_Return, "Enter"},        Named{Qt::Key_Enter, "Enter"},
    Named{Qt::Key_Escape, "Escape"},       Named{Qt::Key_Tab, "Tab"},
    Named{Qt::Key_Backspace, "Backspace"}, Named{Qt::Key_Delete, "Delete"},
    Named{Qt::Key_Insert, "Insert"},       Named{Qt::Key_Shift, "Shift"},
    Named{Qt::Key_Control, "Control"},     Named{Qt::Key_Alt, "Alt"},
    Named{Qt::Key_Meta, "Meta"},           Named{Qt::Key_Space, " "},
};

constexpr std::array modifierNames{
    std::pair{Qt::ShiftModifier, ipc::Modifier::shift},
    std::pair{Qt::ControlModifier, ipc::Modifier::control},
    std::pair{Qt::AltModifier, ipc::Modifier::alt},
    std::pair{Qt::MetaModifier, ipc::Modifier::meta},
};

std::vector<ipc::Modifier> modifiersOf(Qt::KeyboardModifiers modifiers) {
    std::vector<ipc::Modifier> result;
    for (const auto& [modifier, name] : modifierNames)
        if (modifiers & modifier)
            result.push_back(name);
    return result;
}

ipc::Button buttonOf(Qt::MouseButton button) {
    switch (button) {
    case Qt::LeftButton:
        return ipc::Button::left;
    case Qt::MiddleButton:
        return ipc::Button::middle;
    case Qt::RightButton:
        return ipc::Button::right;
    case Qt::BackButton:
        return ipc::Button::back;
    case Qt::ForwardButton:
        return ipc::Button::forward;
    default:
        return ipc::Button::none;
    }
}

std::vector<ipc::Button> buttonsOf(Qt::MouseButtons buttons) {
    std::vector<ipc::Button> result;
    for (const Qt::MouseButton button :
         {Qt::LeftButton, Qt::MiddleButton, Qt::RightButton, Qt::BackButton, Qt::ForwardButton})
        if (buttons & button)
            result.push_back(buttonOf(button));
    return result;
}

} // namespace

std::string keyName(const QKeyEvent& event) {
    for (const Named& one : named)
        if (one.key == event.key())
            return one.name;
    if (event.key() >= Qt::Key_F1 && event.key() <= Qt::Key_F35)
        return "F" + std::to_string(event.key() - Qt::Key_F1 + 1);
    const QString text = event.text();
    if (!text.isEmpty() && text[0].isPrint())
        return text.toStdString();
    if (event.key() >= Qt::Key_Exclam && event.key() <= Qt::Key_AsciiTilde) // Ctrl+A has no text
        return QString(QChar(event.key())).toLower().toStdString();
    return "Unidentified";
}

namespace {

int keyNamed(const std::string& name) {
    for (const Named& one : named)
        if (name == one.name)
            return one.key;
    const QString word = QString::fromStdString(name);
    if (word.size() == 1)
        return word[0].toUpper().unicode();
    const int number = word.startsWith('F') ? word.mid(1).toInt() : 0;
    constexpr int last = Qt::Key_F35 - Qt::Key_F1 + 1;
    return number >= 1 && number <= last ? Qt::Key_F1 + number - 1 : 0;
}

} // namespace

QKeyCombination keyOf(const ipc::Input& input) {
    Qt::KeyboardModifiers modifiers;
    for (const auto& [modifier, name] : modifierNames)
        if (std::ranges::count(input.modifiers, name) > 0)
            modifiers |= modifier;
    return QKeyCombination(modifiers, static_cast<Qt::Key>(keyNamed(input.key)));
}

ipc::Input inputOf(const QKeyEvent& event) {
    ipc::Input input;
    input.type =
        event.type() == QEvent::KeyRelease ? ipc::InputType::keyRelease : ipc::InputType::keyPress;
    input.key = keyName(event);
    const QString text = event.text();
    input.text = text.isEmpty() || !text[0].isPrint() ? "" : text.toStdString();
    input.modifiers = modifiersOf(event.modifiers());
    return input;
}

ipc::Input inputOf(const QMouseEvent& event, QPointF pixels) {
    ipc::Input input;
    input.type = event.type() == QEvent::MouseMove            ? ipc::InputType::move
                 : event.type() == QEvent::MouseButtonRelease ? ipc::InputType::release
                                                              : ipc::InputType::press;
    input.x = pixels.x();
    input.y = pixels.y();
    input.button = buttonOf(event.button());
    input.buttons = buttonsOf(event.buttons());
    input.modifiers = modifiersOf(event.modifiers());
    return input;
}

ipc::Input inputOf(const QWheelEvent& event, QPointF pixels) {
    constexpr double perNotch = 120;
    ipc::Input input;
    input.type = ipc::InputType::wheel;
    input.x = pixels.x();
    input.y = pixels.y();
    input.dx = event.angleDelta().x() / perNotch;
    input.dy = event.angleDelta().y() / perNotch;
    input.buttons = buttonsOf(event.buttons());
    input.modifiers = modifiersOf(event.modifiers());
    return input;
}

Qt::CursorShape cursorOf(ipc::CursorShape shape) {
    switch (shape) {
    case ipc::CursorShape::hand:
        return Qt::PointingHandCursor;
    case ipc::CursorShape::grab:
        return Qt::OpenHandCursor;
    case ipc::CursorShape::grabbing:
        return Qt::ClosedHandCursor;
    case ipc::CursorShape::cross:
        return Qt::CrossCursor;
    case ipc::CursorShape::text:
        return Qt::IBeamCursor;
    case ipc::CursorShape::wait:
        return Qt::WaitCursor;
    case ipc::CursorShape::forbidden:
        return Qt::ForbiddenCursor;
    case ipc::CursorShape::arrow:
        break;
    }
    return Qt::ArrowCursor;
}

} // namespace view
