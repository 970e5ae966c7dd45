// What the pointer and the keys change in a picture (dissertation 4.1.3).
//
// Shifted buttons: the left one drags the handle nearest to the pointer, or the body under it;
// the middle one turns the body. Keys: `H` goes from handle to handle (Shift: back), Shift and the
// arrows move the one that is marked, `z` and `x` push it away and bring it nearer, Return asks for
// its exact value as a double click does. While the end of a link is dragged, `a` frees it from its
// body's surface. Escape gives the old text back.
#pragma once

#include "views/handle_drag.h"
#include "views/value_entry.h"

#include <QObject>
#include <QPointer>

class QKeyEvent;
class QMouseEvent;
class QPainter;

namespace views {

class SceneDisplay;

class PictureEditing : public QObject {
    Q_OBJECT
public:
    PictureEditing(SceneDocument& document, SceneDisplay& display);
    ~PictureEditing() override;

    // False: the event is not theirs.
    bool press(QMouseEvent& event);
    bool move(QMouseEvent& event);
    bool release(QMouseEvent& event);
    bool doubleClick(QMouseEvent& event);
    bool keyPress(QKeyEvent& event);
    void keyRelease(QKeyEvent& event);
    void finish(); // what is dragged stays where it is

    void paint(QPainter& painter) const;
    [[nodiscard]] bool dragging() const { return drag_ != nullptr; }
    // What a drag says of itself, "" when there is none.
    [[nodiscard]] QString words() const;
    [[nodiscard]] ValueEntry* entry() const { return entry_; }
    // The handle that keys move.
    [[nodiscard]] std::optional<render::Handle> marked() const;
    void openEntry(); // for the marked handle

Q_SIGNALS:
    void changed();

private:
    void begin(const render::Handle& handle, const std::optional<Eigen::Vector2d>& pixels);
    [[nodiscard]] std::optional<render::Handle> handleUnder(const QPointF& position) const;
    void mark(const render::Handle& handle);
    void markNext(int step);
    bool dragKey(QKeyEvent& event);
    void offerOthers(const QPoint& global, const HandleDrag& drag);
    void paintLabels(QPainter& painter) const;
    void paintWords(QPainter& painter, const QString& words, bool possible) const;

    struct Mark { // a handle by what it belongs to
        render::HandleKind kind;
        std::size_t element, part;
    };

    SceneDocument& document_;
    SceneDisplay& display_;
    std::unique_ptr<HandleDrag> drag_;
    bool byKeys_ = false;
    Qt::MouseButton button_ = Qt::NoButton;
    std::optional<Mark> mark_;
    QPointer<ValueEntry> entry_;
};

} // namespace views
