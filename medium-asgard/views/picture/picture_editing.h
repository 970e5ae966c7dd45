// Changes of the scene by pointer and keys in a picture (dissertation 4.1.3).
//
// Shifted buttons: the left one drags the handle nearest to the pointer, or the body under it (a
// click that moves nothing is picture/selecting.h's); the middle one turns the body, or draws a new
// point out of a trajectory's point, which the right one removes. Delete takes out what is marked,
// with what depends on it; Insert puts a point after the marked one. Keys: `H` goes from handle to
// handle (Shift: back), Shift and the arrows move the one that is marked, `z` and `x` push it away
// and bring it nearer, Return asks for its exact value as a double click does, on a body for the
// size of its shape. While the end of a link is dragged, `a` frees it from its body's surface.
// Escape gives the old text back.
#pragma once

#include "gestures/hand.h"
#include "labels/said.h"
#include "offers/value_entry.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <functional>
#include <vector>

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
    // A drag of a ring of the selected body begins there: it turns about that axis of the world.
    bool turnBody(std::size_t body, const QPointF& position, int axis);
    // An unshifted drag of a body that is selected begins there, and takes with it all that are
    // selected. False: it cannot be moved now.
    // `along`: the axis that it keeps to, by its arrow.
    bool pressBody(std::size_t body, const QPointF& position,
                   const std::optional<gestures::HandleDrag::Along>& along = std::nullopt);
    // The other bodies that are selected with one that is.
    [[nodiscard]] std::vector<std::size_t> companyOf(std::size_t body) const;
    bool keyPress(QKeyEvent& event);
    void keyRelease(QKeyEvent& event);
    void finish(); // what is dragged stays where it is

    void paint(QPainter& painter) const;
    [[nodiscard]] bool dragging() const { return hand_.active(); }
    [[nodiscard]] bool keepsUpright() const { return hand_.drag() && hand_.drag()->isUpright(); }
    [[nodiscard]] bool turns() const { return hand_.drag() && hand_.drag()->turnsAbout(); }
    [[nodiscard]] std::optional<Asked> asked() const; // by what is dragged
    // The words of a drag, "" when there is none.
    [[nodiscard]] QString words() const;
    // A sentence in the picture until something else is done, or it was read.
    void say(const QString& sentence, bool isFault = true) { said_.say(sentence, isFault); }
    [[nodiscard]] const QString& said() const { return said_.text(); }
    void mark(const render::Handle& handle); // and selects its element, if it is not yet
    // As a click on it does.
    void choose(render::HandleKind kind, std::size_t element, std::size_t part);
    // Selects the elements that a scene yet to be read will have.
    void expect(std::vector<editing::Element> elements) { expected_ = std::move(elements); }
    void deleteMarked();
    // With what cannot be without them, after asking.
    void remove(std::vector<editing::Element> elements);
    void addPointAfterMarked(); // to a trajectory
    // Asked before more than one element is taken out; a message box otherwise.
    void setConfirm(std::function<bool(const QString&)> confirm) { confirm_ = std::move(confirm); }
    [[nodiscard]] ValueEntry* entry() const { return entry_; }
    // The handle that keys move.
    [[nodiscard]] std::optional<render::Handle> marked() const;
    void openEntry(); // for the marked handle
    // Of a body: the size of its shape, in an entry if it is one sphere or box, else in the shape
    // editor; whether it never moves.
    void openSize(std::size_t body);
    void setFixed(std::size_t body, bool fixed);
    void openSurface(std::size_t body); // its restitution and frictions

Q_SIGNALS:
    void changed();
    void shapeWanted(const QString& name); // in the shape editor

private:
    void openEntry(commands::AskedValue asked, const geometry::Vector& place);
    bool openBodyAt(const QPointF& position); // false: there is none
    gestures::Ground beginGesture();
    void ended(const gestures::Hand::LetGo& gone);
    // The text was changed elsewhere, and what is dragged is let go.
    bool letGo();
    void goOn();
    void take(const gestures::Grasp& grasp, const Eigen::Vector2d& pixels);
    void removePoint(const render::Handle& handle);
    void take(const text::Edits& edits, const QString& label);
    void followSelection();
    [[nodiscard]] std::optional<render::Handle> positionOf(std::size_t body) const;
    void paintSelection(QPainter& painter) const;
    [[nodiscard]] std::optional<render::Handle> handleUnder(const QPointF& position) const;
    [[nodiscard]] bool mayChange(); // says why not
    void markElement(const editing::Element& element);
    void markNext(int step);
    bool dragKey(QKeyEvent& event);
    void offerOthers(const gestures::HandleDrag& drag);
    void paintAlong(QPainter& painter) const;
    void paintWords(QPainter& painter, const QString& words, bool possible) const;

    SceneDocument& document_;
    SceneDisplay& display_;
    gestures::Hand hand_;
    Said said_;
    std::vector<editing::Element> expected_; // of a scene yet to be read
    std::function<bool(const QString&)> confirm_;
    int since_ = 0; // the revision that a drag began at
    QTimer rest_;   // of the pointer, while what it pulls comes nearer still
    Qt::MouseButton button_ = Qt::NoButton;
    std::optional<render::HandleName> mark_;
    std::vector<editing::Element> before_; // what was selected when the button went down
    QPointer<ValueEntry> entry_;
};

} // namespace views
