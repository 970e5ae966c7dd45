#include "frame/typed_field.h"

#include "plain/plain.h"

#include <QApplication>
#include <QDeadlineTimer>
#include <QEventLoop>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QTimer>

#include <chrono>
#include <utility>

namespace views {

namespace {

constexpr const char* refusal = "refusal";

bool hasNumber(const QLineEdit& field) {
    bool isNumber = false;
    static_cast<void>(field.text().toDouble(&isNumber));
    return isNumber;
}

// A field without changes: the key is the window's.
bool isOthersUndo(const QLineEdit& field, const QEvent& event) {
    if (event.type() != QEvent::ShortcutOverride || field.isModified())
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    return key.matches(QKeySequence::Undo) || key.matches(QKeySequence::Redo);
}

// A number that nobody changes any more: a blank adds nothing to it, and no letter but "e" can
// follow it. The key plays, or frames.
bool isOthersLetter(const QLineEdit& field, const QEvent& event, const QString& asked) {
    if (event.type() != QEvent::ShortcutOverride || (field.isModified() && field.text() != asked))
        return false;
    const auto& key = static_cast<const QKeyEvent&>(event);
    if (!hasNumber(field) || key.key() == Qt::Key_Space)
        return hasNumber(field);
    return key.key() >= Qt::Key_A && key.key() <= Qt::Key_Z && key.key() != Qt::Key_E &&
           !(key.modifiers() & ~Qt::ShiftModifier) && !field.hasSelectedText() &&
           field.cursorPosition() == field.text().size();
}

// The reader has a limit of its own; this one holds when somebody else reads, and is gone.
void waitUntilRead(const SceneDocument& document) {
    using namespace std::chrono_literals;
    const QDeadlineTimer end(20s);
    bool isGoingOn = true; // false: the program ends, and no loop waits any more
    while (document.isAwaited() && isGoingOn && !end.hasExpired()) {
        QEventLoop loop;
        isGoingOn = false;
        const auto goOn = [&] {
            isGoingOn = true;
            loop.quit();
        };
        QObject::connect(&document, &SceneDocument::wasRead, &loop, goOn);
        QTimer::singleShot(static_cast<int>(end.remainingTime()), &loop, goOn);
        loop.exec(QEventLoop::ExcludeUserInputEvents);
    }
}

} // namespace

TypedField::TypedField(QLineEdit& field, const SceneDocument& document, Uses uses)
    : QObject(&field), field_(field), document_(document), uses_(std::move(uses)) {
    field.installEventFilter(this);
    connect(&field, &QLineEdit::editingFinished, this, [this] { take(false); });
}

void TypedField::setRefusal(QLineEdit& field, const QString& why) {
    field.setProperty(refusal, why);
}

QString TypedField::refusalOf(const QLineEdit& field) { return field.property(refusal).toString(); }

QString TypedField::settleAll(const SceneDocument& document, QWidget* window) {
    QList<QPointer<QLineEdit>> typed;
    for (QWidget* one : window ? QWidgetList{window} : QApplication::topLevelWidgets())
        for (TypedField* in : one->findChildren<TypedField*>())
            if (&in->document_ == &document && in->field_.isModified() &&
                !typed.contains(&in->field_)) { // a pane that is torn off is a window in another
                typed << &in->field_;
                in->take(false);
            }
    if (typed.isEmpty())
        return {};
    waitUntilRead(document);
    for (const QPointer<QLineEdit>& field : typed)
        if (field && !refusalOf(*field).isEmpty())
            return refusalOf(*field);
    return document.isAwaited() ? document.whyNotCurrent() : QString();
}

bool TypedField::maySettle(const SceneDocument& document, QWidget* window) {
    const QString why = settleAll(document, window);
    if (why.isEmpty())
        return true;
    if (plain::Message::ask(
            QMessageBox::Question, window ? window : QApplication::activeWindow(), tr("Asgard"),
            tr("A value that was typed is not taken: %1\n\nGo on without it?").arg(why),
            QMessageBox::Yes | QMessageBox::No, QMessageBox::No) != QMessageBox::Yes)
        return false;
    if (window) // it is not asked about again
        for (TypedField* one : window->findChildren<TypedField*>())
            if (&one->document_ == &document && one->field_.isModified())
                one->uses_.bringBack();
    return true;
}

void TypedField::take(bool asked) {
    if (field_.isModified())
        uses_.take(asked);
}

void TypedField::leave() {
    if (uses_.left)
        uses_.left();
}

bool TypedField::isLeft(QObject* watched, const QEvent& event) const {
    const auto* widget = qobject_cast<QWidget*>(watched);
    return event.type() == QEvent::Shortcut || (event.type() == QEvent::MouseButtonPress &&
                                                widget && widget->window() == field_.window());
}

// A number, all of it, and again after Return, which leaves the keyboard here: a press puts the
// caret into it, so that its button is waited for. Where a drag has selected a part, that is meant.
bool TypedField::selects(const QEvent& event) {
    if (event.type() == QEvent::FocusIn)
        isClicked_ = static_cast<const QFocusEvent&>(event).reason() == Qt::MouseFocusReason;
    if (event.type() == QEvent::MouseButtonPress && std::exchange(isGiven_, false))
        isClicked_ = true;
    if (event.type() == QEvent::KeyPress || event.type() == QEvent::FocusOut)
        isGiven_ = false;
    const bool isReleased = event.type() == QEvent::MouseButtonRelease &&
                            std::exchange(isClicked_, false) && !field_.hasSelectedText();
    const bool isDouble = event.type() == QEvent::MouseButtonDblClick;
    if ((isReleased || isDouble) && hasNumber(field_))
        field_.selectAll();
    return isDouble && hasNumber(field_);
}

// Return and Escape are the field's.
bool TypedField::takesKey(QEvent& event) {
    const bool asks = event.type() == QEvent::ShortcutOverride;
    if (!asks && event.type() != QEvent::KeyPress)
        return false;
    const int key = static_cast<QKeyEvent&>(event).key();
    if (key != Qt::Key_Escape && key != Qt::Key_Return && key != Qt::Key_Enter)
        return false;
    event.accept();
    if (asks)
        return true;
    if (key == Qt::Key_Escape)
        uses_.bringBack();
    else {
        asked_ = field_.text();
        take(true);
        isGiven_ = true;
    }
    leave();
    return true;
}

// All of the program's events are looked at only while the field has the keyboard.
bool TypedField::eventFilter(QObject* watched, QEvent* event) {
    if (watched != &field_) {
        if (field_.isModified() && isLeft(watched, *event)) {
            take(false);
            leave();
        }
        return false;
    }
    if (event->type() == QEvent::FocusIn)
        qApp->installEventFilter(this);
    else if (event->type() == QEvent::FocusOut)
        qApp->removeEventFilter(this);
    if (isOthersUndo(field_, *event) || isOthersLetter(field_, *event, asked_)) {
        event->ignore();
        return true;
    }
    return selects(*event) || takesKey(*event);
}

} // namespace views
