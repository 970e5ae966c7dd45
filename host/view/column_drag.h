// Dragging the border of a table's column: the columns on both sides share their width anew; the
// last border makes the table wider. A double click gives the column on its left the width that its
// content wants.
#pragma once

#include "layout/pages.h"
#include "view/gestures.h"

namespace view {

class ColumnDrag : public Gesture {
public:
    explicit ColumnDrag(DocumentView& view) : view_(view) {}

    [[nodiscard]] std::optional<Qt::CursorShape> cursorAt(QPointF point) override;
    void take(QPointF point) override;
    void takeTwice(QPointF point) override;
    void drag(QPointF point) override;
    void finish() override;
    void cancel() override { taken_.reset(); }
    void paint(QPainter& painter) const override;

private:
    struct Border {
        layout::PlacedRows rows;
        std::size_t page = 0;
        std::size_t column = 0; // on its left
        double x = 0;           // twips of the page
    };
    [[nodiscard]] std::optional<Border> borderAt(QPointF point) const;
    [[nodiscard]] sgml::NodeId tableOf(const Border& border) const;
    void setWidths(const Border& border, const std::vector<double>& points);

    DocumentView& view_;
    std::optional<Border> taken_;
    double grip_ = 0; // from the border to the pointer, in pixels
    double x_ = 0;    // where it is dragged to, in twips of the page
};

} // namespace view
