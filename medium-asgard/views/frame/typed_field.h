// A field of a window in which somebody types a value of the scene.
//
// The value is taken with Return, when the keyboard leaves the field, and before the next action in
// its window: a press elsewhere, a key that is a command. Escape brings back what was there. A
// field in which nothing was typed has nothing to undo: that key is the window's then, and so is a
// blank in a number, and a letter behind it. The click that brings the keyboard to a number selects
// it, and so does a double click: what is typed takes its place.
#pragma once

#include "workbench/scene_document.h"

#include <QObject>

#include <functional>

class QLineEdit;

namespace views {

class TypedField : public QObject {
    Q_OBJECT
public:
    struct Uses {
        // Of a field that is modified. The reader may answer later; until then it stays modified.
        // `asked`: by Return, which tries again what was refused.
        std::function<void(bool asked)> take;
        std::function<void()> bringBack;
        std::function<void()> left = nullptr; // with Return or Escape, or for something else
    };
    // The field owns it.
    TypedField(QLineEdit& field, const SceneDocument& document, Uses uses);

    // Why the value that was typed last is not taken; "": it is, or nobody has answered yet.
    static void setRefusal(QLineEdit& field, const QString& why);
    [[nodiscard]] static QString refusalOf(const QLineEdit& field);
    // Takes what was typed in all windows of the document, or in one, and waits until that is read.
    // "", or why a value is not taken.
    static QString settleAll(const SceneDocument& document, QWidget* window = nullptr);
    // The same, and asks whether one goes on without what is not taken.
    static bool maySettle(const SceneDocument& document, QWidget* window = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void take(bool asked);
    void leave();
    [[nodiscard]] bool isLeft(QObject* watched, const QEvent& event) const;
    bool selects(const QEvent& event);
    bool takesKey(QEvent& event);

    QLineEdit& field_;
    const SceneDocument& document_;
    Uses uses_;
    QString asked_;          // to be taken, by Return
    bool isClicked_ = false; // the button is still down that brought the keyboard
    bool isGiven_ = false;   // by Return: the next click is as the first one
};

} // namespace views
