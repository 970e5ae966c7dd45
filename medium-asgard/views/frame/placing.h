// Where new windows stand: within the screen, beside the ones that are in use.
#pragma once

#include <QRect>

class QPoint;
class QWidget;

namespace views {

// No window is larger than its screen: with large letters a screen is small.
void fitScreen(QWidget& window, const QWidget* asked);

// To that place, or as near to it as the screen shows the whole window.
void moveWithinScreen(QWidget& window, const QPoint& place);

// Beside the window that asked for it where the screen has room that no other window covers, a
// little smaller if need be. Where it has none, the one that asked makes room if it can without
// covering others; otherwise as small as it gets beside it, else at the right edge of one that
// fills the screen, or a little below and right of it.
void placeBeside(QWidget& window, QWidget& asked);

// As wide as a window can be beside that one once it has made all the room that it can.
[[nodiscard]] int mostBeside(const QWidget& asked);

// Where a window stands beside a figure of a document, so that it does not cover it: in the largest
// part of the room beside it in which it fits, a little smaller if need be, at the outer edge,
// where it covers least of the document. Nowhere it fits: where it covers least of the figure.
[[nodiscard]] QRect placeAround(const QRect& figure, const QRect& room, const QSize& size,
                                const QSize& least);
// `figure`: in device pixels of its screen.
void placeBesideFigure(QWidget& window, const QRect& figure);

// The first window of a program: most of the screen, with room beside it on a wide one.
void placeFirst(QWidget& window);

} // namespace views
