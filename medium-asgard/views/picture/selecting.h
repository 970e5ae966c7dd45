// Selecting by clicks, and by a band.
//
// A click, which is a press and a release in one place, selects the thing under the pointer, a
// further click there what lies behind it; on nothing it deselects. With Shift or Ctrl it adds the
// thing to what is selected or takes it out, and on nothing it changes nothing. Ctrl and a drag
// draw a band and select the bodies in it, with Shift in addition. A drag of a body that is
// selected moves it, as Shift and a drag do with any; other drags are the view's.
#pragma once

#include "gestures/things.h"

#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QMouseEvent;
class QPainter;

namespace views {

class SceneDisplay;
class SceneDocument;

class Selecting {
public:
    Selecting(SceneDocument& document, SceneDisplay& display)
        : document_(document), display_(display) {}

    // True: a band begins.
    bool press(const QMouseEvent& event);
    // True: the band has the pointer.
    bool move(const QMouseEvent& event);
    // True: the band ends, or a click has selected.
    bool release(const QMouseEvent& event);
    bool cancel(); // false: there is no band
    [[nodiscard]] bool hasBand() const { return band_.has_value(); }
    [[nodiscard]] bool awaitsClick() const { return pressed_.has_value(); }
    void forgetClick() { pressed_.reset(); }
    void selectAll(); // bodies that the picture shows
    // A click with Shift or Ctrl. A handle of an element that is selected is only marked.
    void addOrTakeOut(const QPointF& position);
    // The body that an unshifted drag from there takes with it: one that is selected, whatever is
    // before it, or one that can be thrown.
    [[nodiscard]] std::optional<std::size_t> draggedBodyAt(const QPointF& position) const;
    // One that is selected and that a hand may take, whatever is before it.
    [[nodiscard]] std::optional<std::size_t> selectedBodyAt(const QPointF& position) const;
    // Where all bodies that are selected are out of the picture now: a tag at its edge, towards the
    // first of them, which a click on it brings into the picture.
    struct Tag {
        QString words;
        QRectF box;
        QPointF end; // towards the body
    };
    [[nodiscard]] std::optional<Tag> tag() const;
    void paint(QPainter& painter) const;

private:
    [[nodiscard]] std::vector<gestures::Thing>
    thingsAt(const QPointF& position) const; // from the front on
    void click(const QPointF& position);
    void paintTag(QPainter& painter, const Tag& tag) const;
    void selectBand(bool adds);

    SceneDocument& document_;
    SceneDisplay& display_;
    std::optional<QPointF> pressed_; // a click may follow
    bool adds_ = false;              // that click
    std::optional<QPointF> clicked_; // where the last click was
    std::optional<std::pair<QPointF, QPointF>> band_;
};

} // namespace views
