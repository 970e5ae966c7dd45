#include "labels/handle_labels.h"

#include "handles/handle_layout.h"

#include <QPainter>

namespace views {

namespace {

QColor toColor(const scene::Color& c) { return QColor::fromRgbF(c.red, c.green, c.blue); }

} // namespace

void paintLabels(QPainter& painter, SeenPicture& picture, const Meters& meters) {
    QFont font = painter.font();
    font.setPointSizeF(font.pointSizeF() * 0.9);
    painter.setFont(font);
    const auto labelled = render::labelled(picture.drawnHandles());
    if (labelled.empty())
        return;
    const gestures::Sight sight = picture.sight();
    std::vector<render::LabelWish> wishes;
    for (const render::Handle* handle : labelled) {
        const QPointF at = picture.fromPixels(render::standOf(*handle, sight.camera, sight.size));
        const QSizeF size = painter
                                .boundingRect(QRectF(0, 0, 1, 1), Qt::AlignLeft | Qt::TextDontClip,
                                              QString::fromStdString(handle->label))
                                .size() +
                            QSizeF(6, 2);
        wishes.push_back({{at.x(), at.y()}, {size.width(), size.height()}});
    }
    const Eigen::AlignedBox2d room(
        Eigen::Vector2d(0, 0),
        Eigen::Vector2d(picture.widget().width(), picture.widget().height()));
    const auto boxes = render::placedLabels(wishes, room, meters.taken());
    QColor paper = picture.widget().palette().color(QPalette::Base);
    const bool dark = paper.lightness() < 128;
    paper.setAlpha(200);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const QRectF box(QPointF(boxes[i].min().x(), boxes[i].min().y()),
                         QPointF(boxes[i].max().x(), boxes[i].max().y()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(paper);
        painter.drawRoundedRect(box, 3, 3);
        const QColor ink = toColor(render::colorOf(labelled[i]->kind));
        painter.setPen(dark ? ink.lighter(140) : ink.darker(160));
        painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip,
                         QString::fromStdString(labelled[i]->label));
    }
}

} // namespace views
