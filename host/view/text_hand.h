// Selecting the text of a view with pointer and keys, and the look of the selection.
//
// A press begins a selection, a double one of whole words, a triple one of whole paragraphs; with
// Shift the last one goes on. A pointer that is dragged over the view's edge scrolls it. The
// selected text is the primary selection of the desktop, where there is one.
#pragma once

#include "onpage/text_cursor.h"

#include <QElapsedTimer>
#include <QMouseEvent>
#include <QPainter>
#include <QRegion>
#include <QTimer>

namespace view {

class DocumentView;

class TextHand : public QObject {
    Q_OBJECT

public:
    // The view outlives it.
    explicit TextHand(DocumentView& view);

    [[nodiscard]] TextCursor& cursor() { return cursor_; }
    [[nodiscard]] const TextCursor& cursor() const { return cursor_; }

    // Of the left button, where no figure is; places in the viewport.
    void press(const QMouseEvent& event);
    void pressTwice(const QMouseEvent& event);
    void drag(QPointF point);
    void release();
    [[nodiscard]] bool isDragging() const { return dragging_; }
    [[nodiscard]] bool isOverText(QPointF point) const;
    [[nodiscard]] bool isSelected(QPointF point) const; // what is there
    [[nodiscard]] std::optional<places::Caret> caretAt(QPointF point) const;
    void moveTo(const places::Caret& caret);

    // False: the key is not for the text. `moves`: arrows move the caret, with Shift or without;
    // else they select with Shift alone.
    bool useKey(int key, Qt::KeyboardModifiers modifiers, bool moves);
    void selectAll();
    bool copy() const; // false: nothing is selected, or no page is laid out yet
    [[nodiscard]] std::unique_ptr<QMimeData> copied() const; // null: nothing is selected

    // Over a page, in twips, or over a figure that is selected.
    void paintSelection(QPainter& painter, std::size_t page) const;
    void paintSelection(QPainter& painter, document::SubdocumentId id, const QRectF& place) const;
    // The place of the caret in the viewport; nothing: it has no place.
    [[nodiscard]] std::optional<QRectF> caretRect() const;
    void showCaret(); // scrolls
    // Scrolls to what stands at a place of the document, unless a part of it is seen.
    void showPlace(std::size_t place);
    void moveIntoView(); // to the first text that is seen
    void refresh();      // paints what of it has changed

private:
    [[nodiscard]] places::Carets carets() const;
    // The selection on a page, in twips: text, or whole cells of a table.
    [[nodiscard]] std::vector<QRectF> selectedOn(std::size_t page) const;
    [[nodiscard]] std::vector<sgml::NodeId> selectedCells() const;
    void begin(QPointF point, TextCursor::Unit unit, bool extend);
    void scrollOn();
    bool showRect(const QRectF& rect); // false: it is seen
    void showEdge();
    [[nodiscard]] bool isSeen(std::size_t place) const; // an object that it is in
    void movePage(int by, bool extend);
    void publish();
    [[nodiscard]] QColor tint() const;
    [[nodiscard]] QRegion region() const;

    DocumentView& view_;
    TextCursor cursor_;
    bool dragging_ = false;
    QPointF at_;          // the pointer, while it drags
    QElapsedTimer twice_; // since a double press
    QPointF twiceAt_;
    QTimer scrolling_;
    QRegion shown_; // of the viewport, what shows the selection
};

} // namespace view
