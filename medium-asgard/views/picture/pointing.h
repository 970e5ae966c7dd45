// The thing under the pointer in a picture, and the meaning of the buttons there.
//
// Nobody reads a manual to learn which button moves a handle: the thing under the pointer lights
// up, the read-out names it, and the line at the window's foot tells its gestures.
#pragma once

#include "gestures/picking.h"
#include "workbench/scene_document.h"

#include <QObject>
#include <QPointF>
#include <QTimer>

#include <optional>

class QPainter;

namespace views {

class SceneDisplay;

class Pointing : public QObject {
    Q_OBJECT
public:
    Pointing(SceneDocument& document, SceneDisplay& display);

    void moveTo(const QPointF& position, Qt::KeyboardModifiers keys);
    void leave();
    void follow(); // something else may be where the pointer is
    void setKeys(Qt::KeyboardModifiers keys);
    // One sentence for the window's foot.
    [[nodiscard]] QString hint() const;
    // The handle under the pointer and its value, "" where there is none.
    [[nodiscard]] const QString& words() const { return words_; }
    // That an unshifted drag which began on a handle moves the view, and what would move it.
    [[nodiscard]] QString advice() const;
    void paint(QPainter& painter) const;

Q_SIGNALS:
    void changed();

private:
    void look();
    void rest();
    void openCrowd(); // under the pointer
    void showCursor();
    [[nodiscard]] QString heldHint() const;

    SceneDocument& document_;
    SceneDisplay& display_;
    std::optional<QPointF> position_; // none: it is elsewhere
    Qt::KeyboardModifiers keys_;
    std::optional<render::Handle> handle_;
    QString subject_; // "the velocity of b1", "b1"
    QString words_;
    bool body_ = false, path_ = false;
    bool isOver_ = false;           // what is painted over the picture
    bool isGrasped_ = false;        // a drag with Shift takes the body
    bool isDragged_ = false;        // one without it does
    std::optional<QString> whyNot_; // Throwing::whyNot(), of a body that is dragged
    QTimer rest_;                   // bodies are looked for when the pointer stays
};

} // namespace views
