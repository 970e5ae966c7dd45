#include "frame/icons.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

namespace views {

namespace {

// Points are in a square of 16; forward is to the right.
void triangle(QPainterPath& path, double left, double right, double half = 4.5) {
    path.moveTo(left, 8 - half);
    path.lineTo(right, 8);
    path.lineTo(left, 8 + half);
    path.closeSubpath();
}

void bar(QPainterPath& path, double left, double width = 2, double half = 4.5) {
    path.addRect(left, 8 - half, width, 2 * half);
}

QPainterPath filled(Icon which) {
    QPainterPath path;
    switch (which) {
    case Icon::first:
    case Icon::last:
        bar(path, 11.5);
        triangle(path, 3.5, 11);
        break;
    case Icon::stepBack:
    case Icon::stepForward:
        bar(path, 4, 2);
        triangle(path, 7.5, 13.5);
        break;
    case Icon::play:
        triangle(path, 4, 13, 5.5);
        break;
    case Icon::pause:
        bar(path, 4, 3, 5);
        bar(path, 9, 3, 5);
        break;
    case Icon::stop:
        path.addRect(3.5, 3.5, 9, 9);
        break;
    case Icon::loop:
        triangle(path, 8.5, 12.5, 3);
        path.translate(0, -4);
        break;
    case Icon::undo:
    case Icon::redo: // the head of the arrow
        path.moveTo(2.2, 6.2);
        path.lineTo(7, 2.6);
        path.lineTo(7, 9.8);
        path.closeSubpath();
        break;
    default:
        break;
    }
    return path;
}

// The thing that a command makes, or acts on.
QPainterPath accented(Icon which) {
    QPainterPath path;
    switch (which) {
    case Icon::body:
        path.addEllipse(QPointF(8, 8), 5.2, 5.2);
        break;
    case Icon::force:
        path.moveTo(8, 14.6);
        path.lineTo(4.2, 9);
        path.lineTo(11.8, 9);
        path.closeSubpath();
        break;
    case Icon::joint:
        path.addEllipse(QPointF(8, 8), 2.6, 2.6);
        break;
    case Icon::link:
        path.addEllipse(QPointF(3, 13), 1.8, 1.8);
        path.addEllipse(QPointF(13, 3), 1.8, 1.8);
        break;
    case Icon::rope:
        path.addEllipse(QPointF(8, 5.6), 3.6, 3.6);
        break;
    case Icon::save:
        path.addRect(5, 9, 6, 5);
        break;
    case Icon::newScene:
        path.addEllipse(QPointF(7.6, 9), 2.2, 2.2);
        break;
    default:
        break;
    }
    return path;
}

void sheet(QPainterPath& path) {
    path.moveTo(9.5, 2);
    path.lineTo(3.5, 2);
    path.lineTo(3.5, 14);
    path.lineTo(12.5, 14);
    path.lineTo(12.5, 5);
    path.lineTo(9.5, 2);
    path.lineTo(9.5, 5);
    path.lineTo(12.5, 5);
}

void folder(QPainterPath& path) {
    path.moveTo(2, 13);
    path.lineTo(2, 3.5);
    path.lineTo(6, 3.5);
    path.lineTo(7.5, 5.5);
    path.lineTo(12.5, 5.5);
    path.lineTo(12.5, 7.5);
    path.moveTo(2, 13);
    path.lineTo(4.4, 7.5);
    path.lineTo(14.8, 7.5);
    path.lineTo(12.4, 13);
    path.lineTo(2, 13);
}

void disk(QPainterPath& path) {
    path.moveTo(2.5, 2.5);
    path.lineTo(11.5, 2.5);
    path.lineTo(13.5, 4.5);
    path.lineTo(13.5, 13.5);
    path.lineTo(2.5, 13.5);
    path.closeSubpath();
    path.moveTo(5.5, 2.5);
    path.lineTo(5.5, 5.5);
    path.lineTo(10, 5.5);
    path.lineTo(10, 2.5);
}

void spring(QPainterPath& path) {
    path.moveTo(4.4, 11.6);
    for (const QPointF point :
         {QPointF(5.2, 10.8), QPointF(5, 7.8), QPointF(8.2, 11), QPointF(7.8, 5), QPointF(11, 8.2),
          QPointF(10.8, 5.2), QPointF(11.6, 4.4)})
        path.lineTo(point);
}

void lines(QPainterPath& path) {
    constexpr double ends[] = {13.5, 9.5, 12, 7.5};
    for (int i = 0; i < 4; ++i) {
        path.moveTo(2.5, 3.5 + 3 * i);
        path.lineTo(ends[i], 3.5 + 3 * i);
    }
}

QPainterPath stroked(Icon which) {
    QPainterPath path;
    switch (which) {
    case Icon::newScene:
        sheet(path);
        return path;
    case Icon::open:
        folder(path);
        return path;
    case Icon::save:
        disk(path);
        return path;
    case Icon::undo:
    case Icon::redo:
        path.moveTo(6, 6.2);
        path.cubicTo(11, 6.2, 13.4, 8.4, 13.4, 13.4);
        return path;
    case Icon::force:
        path.moveTo(8, 1.5);
        path.lineTo(8, 9.2);
        return path;
    case Icon::joint: // two arms about a pin
        path.moveTo(8, 8);
        path.lineTo(2, 13.5);
        path.moveTo(8, 8);
        path.lineTo(14, 13.5);
        path.moveTo(3, 2.5);
        path.lineTo(13, 2.5);
        path.moveTo(8, 2.5);
        path.lineTo(8, 5);
        return path;
    case Icon::link:
        spring(path);
        return path;
    case Icon::rope:
        path.moveTo(4.4, 14.5);
        path.lineTo(4.4, 5.6);
        path.arcTo(4.4, 2, 7.2, 7.2, 180, -180);
        path.lineTo(11.6, 11);
        return path;
    case Icon::text:
        lines(path);
        return path;
    case Icon::plots:
        path.moveTo(2.5, 2);
        path.lineTo(2.5, 13.5);
        path.lineTo(14, 13.5);
        path.moveTo(4, 10.5);
        path.cubicTo(7, 0, 9, 15, 13.5, 4);
        return path;
    case Icon::add:
    case Icon::remove:
        path.moveTo(3, 8);
        path.lineTo(13, 8);
        if (which == Icon::add) {
            path.moveTo(8, 3);
            path.lineTo(8, 13);
        }
        return path;
    case Icon::zoomIn:
    case Icon::zoomOut:
        path.addEllipse(QPointF(6.8, 6.8), 4.6, 4.6);
        path.moveTo(10.2, 10.2);
        path.lineTo(14, 14);
        path.moveTo(4.6, 6.8);
        path.lineTo(9, 6.8);
        if (which == Icon::zoomIn) {
            path.moveTo(6.8, 4.6);
            path.lineTo(6.8, 9);
        }
        return path;
    case Icon::close:
        path.moveTo(3.5, 3.5);
        path.lineTo(12.5, 12.5);
        path.moveTo(12.5, 3.5);
        path.lineTo(3.5, 12.5);
        return path;
    case Icon::tearOff: // a window above another
        path.addRect(2.5, 6.5, 7, 7);
        path.moveTo(6.5, 3.8);
        path.lineTo(6.5, 2.5);
        path.lineTo(13.5, 2.5);
        path.lineTo(13.5, 9.5);
        path.lineTo(12.2, 9.5);
        return path;
    case Icon::help:
        path.moveTo(5, 5.4);
        path.cubicTo(5, 1, 11.4, 1, 11.2, 5.2);
        path.cubicTo(11, 7.6, 8, 7.4, 8, 10.4);
        path.moveTo(8, 12.4);
        path.lineTo(8, 14);
        return path;
    default:
        break;
    }
    if (which == Icon::loop) {
        path.arcMoveTo(3, 4, 10, 9, 105);
        path.arcTo(3, 4, 10, 9, 105, 290);
    } else if (which == Icon::frameAll) {
        for (int corner = 0; corner < 4; ++corner) {
            QTransform turn;
            turn.translate(8, 8);
            turn.rotate(90 * corner);
            QPainterPath angle(QPointF(-5.5, -2.5));
            angle.lineTo(-5.5, -5.5);
            angle.lineTo(-2.5, -5.5);
            path.addPath(turn.map(angle));
        }
        path.addEllipse(QPointF(8, 8), 1.6, 1.6);
    }
    return path;
}

class IconEngine : public QIconEngine {
public:
    IconEngine(Icon which, const QPalette& palette) : which_(which), palette_(palette) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const QColor color = palette_.color(group, QPalette::ButtonText);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / 16.0, rect.height() / 16.0);
        if (which_ == Icon::first || which_ == Icon::stepBack || which_ == Icon::redo) {
            painter->translate(16, 0);
            painter->scale(-1, 1);
        }
        QColor accent(0xE0, 0x6A, 0x3A); // seen on light and on dark
        if (mode == QIcon::Disabled)
            accent = color;
        const QPen pen(color, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
        painter->strokePath(stroked(which_), pen);
        painter->fillPath(accented(which_), accent);
        painter->fillPath(filled(which_), color);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new IconEngine(which_, palette_); }

private:
    Icon which_;
    QPalette palette_;
};

} // namespace

QIcon applicationIcon() {
    QIcon all;
    for (int size : {16, 24, 32, 48, 64, 128}) {
        QPixmap pixmap(size, size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(size / 32.0, size / 32.0);
        painter.setPen(QPen(QColor(0x74, 0x82, 0x98), 2.6, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(QPointF(4, 4), QPointF(28, 4));
        painter.drawLine(QPointF(16, 4), QPointF(22, 20));
        QRadialGradient light(QPointF(20.4, 19.2), 11);
        light.setColorAt(0, QColor(0xF2, 0x8C, 0x80));
        light.setColorAt(0.35, QColor(0xD0, 0x3A, 0x2E));
        light.setColorAt(1, QColor(0x7A, 0x14, 0x10));
        painter.setBrush(light);
        painter.setPen(QPen(QColor(0x5A, 0x10, 0x0C), 0.8));
        painter.drawEllipse(QPointF(23, 22.6), 7.4, 7.4);
        all.addPixmap(pixmap);
    }
    return all;
}

QIcon icon(Icon which, const QPalette& palette) { return QIcon(new IconEngine(which, palette)); }

} // namespace views
