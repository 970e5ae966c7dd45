#include "view/hints.h"

#include "model/empty_places.h"
#include "paragraphs/typeface.h"
#include "view/document_view.h"

namespace view {

namespace {

// The place of the first letter.
double leftOf(const model::Block& block, double caret, double width) {
    switch (block.style.align) {
    case schemas::Align::center:
        return caret - width / 2;
    case schemas::Align::right:
        return caret - width;
    default:
        return caret;
    }
}

} // namespace

void paintHints(QPainter& painter, const DocumentView& view, std::size_t page) {
    const std::shared_ptr<const model::Model> model = view.model();
    if (!model)
        return;
    const places::Carets carets(view.pages(), view.document().document().tree());
    const auto& pieces = view.pages().pages[page]->pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const auto* text = std::get_if<layout::TextPiece>(&pieces[i]);
        if (!text || text->isRepeated || !model::isEmptyPlace(*text->paragraph->block()))
            continue;
        const model::Block& block = *text->paragraph->block();
        const std::uint32_t look = block.runs.empty() ? block.textStyle : block.runs.front().style;
        const schemas::TextStyle& style = (*model->textStyles)[look];
        const QFont font = paragraphs::fontOf(style);
        const QString hint = QString::fromStdString(block.style.hint);
        const double caret = carets.rectOf({page, i, text->letters().to}).left();
        // Behind a marker that stands in the line, such as a figure's number.
        const bool isAlone = text->letters().from == text->letters().to;
        const double width = isAlone ? QFontMetricsF(font).horizontalAdvance(hint) : 0;
        const double left = leftOf(block, caret, width);
        QColor ink(style.color.red, style.color.green, style.color.blue);
        constexpr float faint = 0.45F;
        ink.setAlphaF(faint);
        painter.setFont(font);
        painter.setPen(ink);
        painter.drawText(QPointF(left, text->at.y() + text->letters().baseline), hint);
    }
}

} // namespace view
