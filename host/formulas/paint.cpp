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
    const QTransform place = painter.transform();
    for (const PlacedGlyph& glyph : box.glyphs) {
        painter.setTransform(QTransform(glyph.size, 0, 0, glyph.size, glyph.x, glyph.y) * place);
        painter.fillPath(font.outline(glyph.glyph), glyph.faulty ? faulty : ink);
    }
    painter.restore();
}

} // namespace formulas
