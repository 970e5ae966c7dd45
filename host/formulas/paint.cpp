#include "formulas/paint.h"

#include <QPainter>

namespace formulas {

void paint(QPainter& painter, const Box& box, QPointF at, const Font& font, const QColor& ink,
           const QColor& faulty) {
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(at);
    for (const QRectF& rule : box.rules)
        painter.fillRect(rule, ink);
    QColor pale = ink;
    pale.setAlphaF(0.6F);
    painter.setBrush(Qt::NoBrush);
    for (const PlacedPart& part : box.waiting) {
        const double line = part.frame.width() / 14;
        painter.setPen(QPen(pale, line, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
        painter.drawRect(part.frame.adjusted(line / 2, line / 2, -line / 2, -line / 2));
    }
    const QTransform place = painter.transform();
    painter.setPen(Qt::NoPen);
    for (const PlacedGlyph& glyph : box.glyphs) {
        painter.setTransform(QTransform(glyph.size, 0, 0, glyph.size, glyph.x, glyph.y) * place);
        painter.fillPath(font.outline(glyph.glyph), glyph.faulty ? faulty : ink);
    }
    painter.restore();
}

} // namespace formulas
