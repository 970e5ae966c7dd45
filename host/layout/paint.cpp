#include "layout/paint.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <QPainter>

namespace layout {

using paragraphs::colorOf;
using paragraphs::fontOf;
using paragraphs::fromPoints;
using paragraphs::Paragraph;

namespace {

void paintFrame(QPainter& painter, const FramePiece& frame) {
    if (frame.background)
        painter.fillRect(frame.rect, colorOf(*frame.background));
    const schemas::Border& border = frame.border;
    if (border.width <= 0)
        return;
    const double w = fromPoints(border.width);
    const QColor color = colorOf(border.color);
    const QRectF& r = frame.rect;
    if (border.top)
        painter.fillRect(QRectF(r.left(), r.top(), r.width(), w), color);
    if (border.bottom)
        painter.fillRect(QRectF(r.left(), r.bottom() - w, r.width(), w), color);
    if (border.left)
        painter.fillRect(QRectF(r.left(), r.top(), w, r.height()), color);
    if (border.right)
        painter.fillRect(QRectF(r.right() - w, r.top(), w, r.height()), color);
}

void paintImage(QPainter& painter, const ImagePiece& piece, const QImage& image) {
    if (!image.isNull()) {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(piece.rect, image);
        return;
    }
    painter.fillRect(piece.rect, QColor(245, 245, 245));
    schemas::TextStyle style;
    style.family = "sans";
    style.size = 9;
    painter.setFont(fontOf(style));
    painter.setPen(QColor(110, 110, 110));
    painter.drawText(piece.rect, Qt::AlignCenter | Qt::TextWordWrap, piece.alternative);
}

QRectF boundsOf(const TextPiece& text) {
    const Paragraph::Line& line = text.letters();
    // Letters may hang out of their line; the width is that of the page.
    return {-1e7, text.at.y() - line.height, 2e7, 3 * line.height};
}

void paintPageNumber(QPainter& painter, const PageNumberPiece& piece, const Pages& pages) {
    const auto anchor = pages.anchor(piece.target);
    if (!anchor)
        return; // its page is not made yet
    const QFont font = fontOf(piece.style);
    const QFontMetricsF metrics(font);
    const QString number = QString::number(anchor->first + 1);
    const double y = piece.rect.top() + piece.baseline;
    double x = piece.rect.right() - metrics.horizontalAdvance(number);
    painter.setFont(font);
    painter.setPen(colorOf(piece.style.color));
    painter.drawText(QPointF(x, y), number);
    // Dots stand below each other, counted from the right edge.
    const double step = piece.style.size * 20 * 0.5, gap = step;
    const double dot = metrics.horizontalAdvance('.');
    for (double at = piece.rect.right() - std::ceil((piece.rect.right() - x + gap) / step) * step;
         at > piece.rect.left() + gap; at -= step)
        painter.drawText(QPointF(at - dot, y), QStringLiteral("."));
}

} // namespace

void paintPage(QPainter& painter, const Pages& pages, std::size_t page, const QRectF& clip,
               const Painters& painters) {
    const auto paintText = [&](const TextPiece& text) {
        if (boundsOf(text).intersects(clip))
            text.paragraph->paintLine(painter, text.line, text.at);
    };
    for (const Piece& piece : pages.pages[page]->pieces) {
        if (const auto* text = std::get_if<TextPiece>(&piece)) {
            paintText(*text);
        } else if (const auto* frame = std::get_if<FramePiece>(&piece)) {
            if (frame->rect.intersects(clip))
                paintFrame(painter, *frame);
        } else if (const auto* image = std::get_if<ImagePiece>(&piece)) {
            if (image->rect.intersects(clip))
                paintImage(painter, *image, painters.image ? painters.image(*image) : QImage());
        } else if (const auto* number = std::get_if<PageNumberPiece>(&piece)) {
            if (number->rect.intersects(clip))
                paintPageNumber(painter, *number, pages);
        } else if (const auto* placed = std::get_if<SubdocumentPiece>(&piece)) {
            if (placed->rect.intersects(clip) && painters.subdocument)
                painters.subdocument(painter, *placed);
        }
    }
    for (const TextPiece& text : pages.headersOf(page))
        paintText(text);
}

} // namespace layout
