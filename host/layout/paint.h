// Draws a page with any painter whose units are twips. Paper is the caller's to fill.
#pragma once

#include "layout/pages.h"

#include <QImage>
#include <functional>

namespace layout {

struct Painters {
    std::function<void(QPainter&, const SubdocumentPiece&)> subdocument;
    // Null: there is none, or none yet; then the alternative stands at its place.
    std::function<QImage(const ImagePiece&)> image;
};

// Only what touches `clip` is drawn.
void paintPage(QPainter& painter, const Pages& pages, std::size_t page, const QRectF& clip,
               const Painters& painters);

} // namespace layout
