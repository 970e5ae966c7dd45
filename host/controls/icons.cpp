#include "controls/icons.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <functional>

namespace controls {

namespace {

// All drawn in a square of 16, lines 1.4 wide.
using Drawing = std::function<void(QPainter&)>;

void fillPolygon(QPainter& painter, const QPolygonF& polygon) {
    painter.setBrush(painter.pen().color());
    painter.drawPolygon(polygon);
    painter.setBrush(Qt::NoBrush);
}

void bar(QPainter& painter, QRectF rect) { painter.fillRect(rect, painter.pen().color()); }

void page(QPainter& painter) {
    painter.drawPolyline(QPolygonF{{9.5, 1.8}, {3.5, 1.8}, {3.5, 14.2}, {12.5, 14.2}, {12.5, 4.8}});
    painter.drawPolyline(QPolygonF{{9.5, 1.8}, {12.5, 4.8}, {9.5, 4.8}, {9.5, 1.8}});
}

void lens(QPainter& painter, bool plus) {
    painter.drawEllipse(QPointF(6.8, 6.8), 4.6, 4.6);
    painter.drawLine(QPointF(10.2, 10.2), QPointF(14, 14));
    painter.drawLine(QPointF(4.6, 6.8), QPointF(9, 6.8));
    if (plus)
        painter.drawLine(QPointF(6.8, 4.6), QPointF(6.8, 9));
}

void loop(QPainter& painter) {
    painter.drawArc(QRectF(2.5, 2.5, 11, 11), 60 * 16, 280 * 16);
    fillPolygon(painter, {{8.6, 0.4}, {12.8, 3.2}, {8.6, 5.6}});
}

void repeat(QPainter& painter) {
    painter.drawPolyline(QPolygonF{{2.2, 8.6}, {2.2, 4.4}, {11, 4.4}});
    painter.drawPolyline(QPolygonF{{13.8, 7.4}, {13.8, 11.6}, {5, 11.6}});
    fillPolygon(painter, {{10.6, 1.8}, {14, 4.4}, {10.6, 7}});
    fillPolygon(painter, {{5.4, 9}, {2, 11.6}, {5.4, 14.2}});
}

void eye(QPainter& painter) {
    QPainterPath path(QPointF(1.2, 8));
    path.quadTo(8, 0.8, 14.8, 8);
    path.quadTo(8, 15.2, 1.2, 8);
    painter.drawPath(path);
    painter.drawEllipse(QPointF(8, 8), 2.2, 2.2);
}

const QHash<QString, Drawing>& drawings() {
    static const QHash<QString, Drawing> all{
        {"media-playback-start",
         [](QPainter& p) {
             fillPolygon(p, {{4.2, 2.2}, {13.2, 8}, {4.2, 13.8}});
         }},
        {"media-playback-pause",
         [](QPainter& p) {
             bar(p, {3.6, 2.6, 3.1, 10.8});
             bar(p, {9.3, 2.6, 3.1, 10.8});
         }},
        {"media-playback-stop",
         [](QPainter& p) {
             bar(p, {3.2, 3.2, 9.6, 9.6});
         }},
        {"media-skip-backward",
         [](QPainter& p) {
             bar(p, {2.6, 3, 1.8, 10});
             fillPolygon(p, {{13, 3}, {5, 8}, {13, 13}});
         }},
        {"media-skip-forward",
         [](QPainter& p) {
             bar(p, {11.6, 3, 1.8, 10});
             fillPolygon(p, {{3, 3}, {11, 8}, {3, 13}});
         }},
        {"media-seek-forward",
         [](QPainter& p) {
             fillPolygon(p, {{2, 3}, {8, 8}, {2, 13}});
             fillPolygon(p, {{8.4, 3}, {14.4, 8}, {8.4, 13}});
         }},
        {"media-seek-backward",
         [](QPainter& p) {
             fillPolygon(p, {{14, 3}, {8, 8}, {14, 13}});
             fillPolygon(p, {{7.6, 3}, {1.6, 8}, {7.6, 13}});
         }},
        {"media-playlist-repeat", repeat},
        {"view-refresh", loop},
        {"document-open",
         [](QPainter& p) {
             p.drawPolygon(
                 QPolygonF{{1.8, 13}, {1.8, 3.2}, {6, 3.2}, {7.4, 5}, {14.2, 5}, {14.2, 13}});
         }},
        {"document-save",
         [](QPainter& p) {
             p.drawPolygon(QPolygonF{{2, 2}, {11.4, 2}, {14, 4.6}, {14, 14}, {2, 14}});
             p.drawRect(QRectF(4.8, 8.4, 6.4, 5.6));
             p.drawLine(QPointF(5, 2), QPointF(5, 5));
             p.drawLine(QPointF(5, 5), QPointF(10, 5));
         }},
        {"document-print",
         [](QPainter& p) {
             p.drawRect(QRectF(1.8, 5.6, 12.4, 5.6));
             p.drawRect(QRectF(4.2, 1.8, 7.6, 3.8));
             p.drawRect(QRectF(4.2, 9.2, 7.6, 5));
         }},
        {"x-office-document", page},
        {"text-x-generic", page},
        {"accessories-text-editor",
         [](QPainter& p) {
             for (int i = 0; i < 4; ++i)
                 p.drawLine(QPointF(2.5, 3 + 3.3 * i), QPointF(i == 3 ? 9 : 13.5, 3 + 3.3 * i));
         }},
        {"document-edit",
         [](QPainter& p) {
             p.drawPolygon(QPolygonF{{2.2, 13.8}, {3, 10.4}, {10.8, 2.6}, {13.4, 5.2}, {5.6, 13}});
             p.drawLine(QPointF(9, 4.4), QPointF(11.6, 7));
         }},
        {"zoom-in", [](QPainter& p) { lens(p, true); }},
        {"zoom-out", [](QPainter& p) { lens(p, false); }},
        {"view-visible", eye},
        {"window-new",
         [](QPainter& p) {
             p.drawRect(QRectF(1.8, 2.8, 12.4, 10.4));
             p.drawLine(QPointF(1.8, 5.6), QPointF(14.2, 5.6));
         }},
        {"dialog-warning",
         [](QPainter& p) {
             p.drawPolygon(QPolygonF{{8, 1.8}, {14.8, 13.8}, {1.2, 13.8}});
             p.drawLine(QPointF(8, 6), QPointF(8, 9.6));
             p.drawPoint(QPointF(8, 11.8));
         }},
        {"dialog-error",
         [](QPainter& p) {
             p.drawEllipse(QPointF(8, 8), 6.2, 6.2);
             p.drawLine(QPointF(5.6, 5.6), QPointF(10.4, 10.4));
             p.drawLine(QPointF(10.4, 5.6), QPointF(5.6, 10.4));
         }},
    };
    return all;
}

class LineIcon : public QIconEngine {
public:
    explicit LineIcon(Drawing drawing) : drawing_(std::move(drawing)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        QColor color = QGuiApplication::palette().color(group, QPalette::WindowText);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.topLeft());
        painter->scale(rect.width() / 16.0, rect.height() / 16.0);
        QPen pen(color, 1.4);
        pen.setCapStyle(Qt::RoundCap);
        pen.setJoinStyle(Qt::RoundJoin);
        painter->setPen(pen);
        drawing_(*painter);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap result(size);
        result.fill(Qt::transparent);
        QPainter painter(&result);
        paint(&painter, QRect({0, 0}, size), mode, state);
        return result;
    }
    QIconEngine* clone() const override { return new LineIcon(drawing_); }

private:
    Drawing drawing_;
};

} // namespace

QIcon iconNamed(const QString& name) {
    const auto found = drawings().find(name);
    return found == drawings().end() ? QIcon::fromTheme(name) : QIcon(new LineIcon(*found));
}

} // namespace controls
