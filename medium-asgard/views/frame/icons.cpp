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
    case Icon::frameAll:
        break;
    }
    return path;
}

QPainterPath stroked(Icon which) {
    QPainterPath path;
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
        if (which_ == Icon::first || which_ == Icon::stepBack) {
            painter->translate(16, 0);
            painter->scale(-1, 1);
        }
        painter->fillPath(filled(which_), color);
        painter->strokePath(stroked(which_),
                            QPen(color, 1.5, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
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
        painter.setPen(QPen(QColor(0x3C, 0x46, 0x54), 2.6, Qt::SolidLine, Qt::RoundCap));
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
