// The selection, dragged by the pointer: to another place of the text, to another window, to
// another program; and drops that come from there.
#pragma once

#include "view/text_hand.h"

#include <QDropEvent>

namespace view {

class Writing;

class TextDrag {
public:
    // All outlive it.
    TextDrag(DocumentView& view, TextHand& hand, Writing& writing);

    // Of the left button. True: it is on what is selected, and may become a drag.
    [[nodiscard]] bool press(const QMouseEvent& event);
    // True: the pointer is this drag's.
    [[nodiscard]] bool move(const QMouseEvent& event);
    // A press that became no drag puts the caret there.
    [[nodiscard]] bool release(const QMouseEvent& event);

    // False: the drop is not for the text, or the view is not written in.
    bool hover(QDropEvent& event);
    void leave();
    bool drop(QDropEvent& event);

    // The place at which it would be dropped, in twips.
    void paint(QPainter& painter, std::size_t page) const;

private:
    void start();

    DocumentView& view_;
    TextHand& hand_;
    Writing& writing_;
    std::optional<QPointF> pressed_;
    std::optional<text::Range> dragged_;   // of this view
    std::optional<places::Caret> hovered_; // where it would be dropped
};

} // namespace view
