// The sections that a view folds: a triangle beside a heading folds what is under it, and unfolds
// it again. Behind a folded heading it says what is hidden.
//
// A triangle is seen while the section is folded, and while the pointer is on the heading. What
// leads into a section unfolds it: a reference, the outline, a search, undo, the caret.
#pragma once

#include "places/find.h"
#include "session/folded_pages.h"

#include <QPainter>

namespace view {

class DocumentView;

class Folds : public QObject {
    Q_OBJECT

public:
    // The view outlives it.
    explicit Folds(DocumentView& view);

    [[nodiscard]] session::FoldedPages& pages() { return pages_; }

    // --- commands
    // Of the section where the caret is, or else where one reads; noNode: there is none.
    [[nodiscard]] sgml::NodeId headingHere();
    void toggle(sgml::NodeId heading);
    void foldAll();
    void unfoldAll();

    // --- what leads into a section; its pages are there then
    void reveal(std::size_t place);
    void reveal(const std::string& anchor);
    void reveal(const places::Found& found);
    void followCaret();
    // A folded section is a unit behind its heading: a command that would change part of it unfolds
    // it instead. True: it has.
    bool opensBefore(const text::Edits& edits, text::Range selected);

    // --- the pointer, in the viewport
    void hover(QPointF point);
    [[nodiscard]] bool isOver(QPointF point); // it would fold or unfold
    bool press(QPointF point);
    [[nodiscard]] QString tipAt(QPointF point);
    void paint(QPainter& painter); // in the viewport

private:
    // How a heading is marked, in the viewport.
    struct Mark {
        sgml::NodeId heading = sgml::noNode;
        bool isFolded = false;
        QRectF around;   // the heading with its margin
        QRectF triangle; // with some room
        QRectF words;    // of what is hidden; empty where it is not folded
        QString hidden{};
    };
    [[nodiscard]] std::vector<Mark> marks();
    void addMarks(std::vector<Mark>& marks, std::size_t page);
    void addWords(Mark& mark, std::size_t page, const layout::TextPiece& last);
    [[nodiscard]] const Mark* markAt(const std::vector<Mark>& marks, QPointF point) const;
    [[nodiscard]] QFont font() const;
    void bringIntoView(sgml::NodeId heading);
    void moveCaretOut();

    DocumentView& view_;
    session::FoldedPages pages_;
    sgml::NodeId hovered_ = sgml::noNode;
};

} // namespace view
