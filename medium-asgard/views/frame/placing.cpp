#include "frame/placing.h"

#include <QApplication>
#include <QScreen>
#include <QWidget>

#include <algorithm>
#include <array>

namespace views {

namespace {

constexpr int frame = 8, title = 32; // of the window manager, around a window

// The part of its screen that a window's contents may fill.
QRect roomOf(const QWidget& window) {
    return window.screen()->availableGeometry().adjusted(frame, title, -frame, -frame);
}

bool coversAnother(const QRect& place, const QWidget& window) {
    return std::ranges::any_of(QApplication::topLevelWidgets(), [&](const QWidget* other) {
        return other != &window && other->isVisible() && !other->isMinimized() &&
               other->windowType() == Qt::Window && other->geometry().intersects(place);
    });
}

} // namespace

void fitScreen(QWidget& window, const QWidget* asked) {
    window.resize(window.size().boundedTo(roomOf(asked ? *asked : window).size()));
}

void moveWithinScreen(QWidget& window, const QPoint& place) {
    const QRect screen = window.screen()->availableGeometry();
    const auto within = [](int at, int low, int high) {
        return std::clamp(at, low, std::max(low, high));
    };
    const QSize least = window.size().expandedTo(window.minimumSizeHint());
    // Just shown, its frame is not known yet: the place is that of its contents.
    const bool isBare = window.isVisible() && window.frameGeometry() == window.geometry();
    const QPoint own = isBare ? QPoint(frame, title) : QPoint();
    window.move(within(place.x(), screen.left() + own.x(), screen.right() - least.width() - frame),
                within(place.y(), screen.top() + own.y(),
                       screen.bottom() - least.height() - frame - (isBare ? 0 : title)));
}

namespace {

// As large as it is and as it fits there, as high up as `beside`.
QRect placeIn(const QRect& strip, const QWidget& window, const QRect& beside) {
    const QSize size = window.size().boundedTo(strip.size());
    const int top = std::clamp(beside.top(), strip.top(), strip.bottom() + 1 - size.height());
    return {QPoint(strip.left(), top), size};
}

// move() speaks of the place with the frame, which is not known before the window is shown.
void put(QWidget& window, const QRect& place) {
    window.resize(place.size());
    window.move(place.topLeft() - QPoint(0, title - frame));
}

// At the left of its screen, so that a window of that width has room beside it. False: it cannot.
bool makeRoom(QWidget& asked, const QRect& room, int width) {
    if (asked.isMaximized() || asked.isFullScreen() || width > mostBeside(asked))
        return false;
    const int rest = std::min(asked.width(), room.width() - width - 2 * frame);
    if (coversAnother({room.left(), asked.y(), rest, asked.height()}, asked))
        return false;
    asked.resize(rest, asked.height());
    asked.move(room.left(), asked.y());
    return true;
}

} // namespace

int mostBeside(const QWidget& asked) {
    const int least = std::max(asked.minimumSizeHint().width(), asked.minimumWidth());
    return roomOf(asked).width() - least - 2 * frame;
}

void placeBeside(QWidget& window, QWidget& asked) {
    const QRect room = roomOf(asked), used = asked.geometry();
    const QSize least = window.minimumSizeHint().expandedTo(window.size() * 5 / 8);
    QRect right = room, left = room, below = room, above = room;
    right.setLeft(used.right() + 2 * frame);
    left.setRight(used.left() - 2 * frame);
    below.setTop(used.bottom() + frame + title);
    above.setBottom(used.top() - frame - title);
    const auto findsRoom = [&](const QSize& wanted) {
        for (const QRect& strip : std::array{right, left, below, above}) {
            if (strip.width() < wanted.width() || strip.height() < wanted.height())
                continue;
            const QRect place = placeIn(strip, window, used);
            if (coversAnother(place, window))
                continue;
            put(window, place);
            return true;
        }
        return false;
    };
    if (findsRoom(least))
        return;
    QRect edge = room;
    edge.setLeft(room.right() - least.width());
    if (!coversAnother(edge, asked) && makeRoom(asked, room, least.width()))
        return put(window, placeIn(edge, window, used));
    for (QRect* column : {&below, &above}) {
        column->setLeft(used.left());
        column->setRight(used.right());
    }
    constexpr QSize low(200, 150);
    if (findsRoom(window.minimumSizeHint().expandedTo(low)))
        return;
    if (asked.isMaximized() || asked.isFullScreen()) { // its picture stays in sight
        edge.setLeft(room.right() + 1 - std::min(window.width(), room.width()));
        return put(window, placeIn(edge, window, used));
    }
    constexpr int step = 40;
    moveWithinScreen(window, asked.pos() + QPoint(step, step));
}

QRect placeAround(const QRect& figure, const QRect& room, const QSize& size, const QSize& least) {
    QRect right = room, left = room, below = room, above = room;
    right.setLeft(figure.right() + 2 * frame);
    left.setRight(figure.left() - 2 * frame);
    below.setTop(figure.bottom() + frame + title);
    above.setBottom(figure.top() - frame - title);
    const auto within = [&](const QRect& strip) { return size.boundedTo(strip.size()); };
    const auto area = [](const QSize& one) { return one.width() * one.height(); };
    const QRect* best = nullptr;
    for (const QRect* strip : {&right, &left, &below, &above})
        if (strip->width() >= least.width() && strip->height() >= least.height() &&
            (!best || area(within(*strip)) > area(within(*best))))
            best = strip;
    if (!best) { // narrow, in the wider part beside it
        const QRect& wider = left.width() > right.width() ? left : right;
        QRect place(room.topLeft(), within(room));
        place.setWidth(std::clamp(std::max(wider.width(), least.width()), 1, place.width()));
        if (&wider == &right)
            place.moveRight(room.right());
        return place;
    }
    QRect place({}, within(*best));
    place.moveLeft(best == &left ? room.left() : room.right() + 1 - place.width());
    place.moveTop(best == &below ? room.bottom() + 1 - place.height()
                  : best == &above
                      ? room.top()
                      : std::clamp(figure.top(), room.top(), room.bottom() + 1 - place.height()));
    return place;
}

void placeBesideFigure(QWidget& window, const QRect& figure) {
    for (QScreen* screen : QApplication::screens()) {
        const QPoint corner = screen->geometry().topLeft();
        const double ratio = screen->devicePixelRatio();
        const auto shown = [&](const QPoint& device) {
            return corner + ((QPointF(device - corner)) / ratio).toPoint();
        };
        const QRect seen(shown(figure.topLeft()), shown(figure.bottomRight()));
        if (!screen->geometry().contains(seen.center()))
            continue;
        const QRect room = screen->availableGeometry().adjusted(frame, title, -frame, -frame);
        // It is shown already, and its frame not known yet: the place is that of its contents.
        return window.setGeometry(placeAround(
            seen, room, window.size(), window.minimumSizeHint().expandedTo(window.size() / 2)));
    }
}

void placeFirst(QWidget& window) {
    constexpr QSize large(1480, 960);
    const QRect room = roomOf(window);
    window.resize((room.size() * 24 / 25).boundedTo(large));
    moveWithinScreen(window, room.topLeft());
}

} // namespace views
