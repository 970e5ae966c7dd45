// Selecting by plain clicks, and by a band.
//
// A click, which is a press and a release in one place, selects the thing under the pointer, a
// further click there what lies behind it; on nothing it deselects. Ctrl and a drag draw a band and
// select the bodies in it, with Shift in addition. A drag of a body that is selected moves it, as
// Shift and a drag do with any; other drags are the view's.
#pragma once

#include "editing/element.h"
#include "render/handles.h"

#include <QPointF>

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
    // The body at `position` that is selected, whatever is before it.
    [[nodiscard]] std::optional<std::size_t> selectedBodyAt(const QPointF& position) const;
    void paint(QPainter& painter) const;

private:
    struct Thing {
        editing::Element element;
        std::optional<render::Handle> handle; // of it, that is there
    };
    [[nodiscard]] std::vector<Thing> thingsAt(const QPointF& position) const; // from the front on
    void click(const QPointF& position, bool toggles);
    void toggle(const editing::Element& element);
    void selectBand(bool adds);

    SceneDocument& document_;
    SceneDisplay& display_;
    std::optional<QPointF> pressed_; // a click may follow
    std::optional<QPointF> clicked_; // where the last click was
    std::optional<std::pair<QPointF, QPointF>> band_;
};

} // namespace views
