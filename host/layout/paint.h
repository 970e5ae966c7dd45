// Draws a page with any painter whose units are twips. Paper is the caller's to fill.
#pragma once

#include "layout/pages.h"

#include <functional>

namespace layout {

using SubdocumentPainter = std::function<void(QPainter&, const SubdocumentPiece&)>;

// Only what touches `clip` is drawn.
void paintPage(QPainter& painter, const Page& page, const QRectF& clip,
               const SubdocumentPainter& subdocument);

} // namespace layout
