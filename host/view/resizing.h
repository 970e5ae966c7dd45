// Resizing a picture or a subdocument by a lower corner, which keeps its ratio. A click on a
// picture selects it; a chosen subdocument has corners, too. A double click on a corner gives it
// the size back that it has by itself.
#pragma once

#include "document/subdocument.h"
#include "layout/pages.h"
#include "view/gestures.h"

namespace view {

// A unit that is shown in a size of its own: its attributes WIDTH and HEIGHT, in 1/96 inch.
struct Sized {
    sgml::NodeId element = sgml::noNode; // an image, or the class element of a subdocument
    QRectF place;                        // in the viewport
    schemas::Align align = schemas::Align::left;
};

// The subdocument that is chosen, or the image that is selected and nothing else.
[[nodiscard]] std::optional<Sized> sizedUnit(const DocumentView& view);
// The element of the image at a point of the viewport, or noNode.
[[nodiscard]] sgml::NodeId imageAt(const DocumentView& view, QPointF point);
void selectImage(DocumentView& view, sgml::NodeId element);

class Resizing : public Gesture {
public:
    explicit Resizing(DocumentView& view) : view_(view) {}

    [[nodiscard]] std::optional<Qt::CursorShape> cursorAt(QPointF point) override;
    void take(QPointF point) override;
    void takeTwice(QPointF point) override;
    void drag(QPointF point) override;
    void finish() override;
    void cancel() override { taken_.reset(); }
    void paint(QPainter& painter) const override;
    void selectionChanged() override;

    static constexpr double handle = 9; // the side of one, in logical pixels

private:
    enum class Corner { none, left, right };
    [[nodiscard]] static QRectF handleOf(const Sized& unit, Corner corner);
    [[nodiscard]] static Corner cornerAt(const Sized& unit, QPointF point);
    [[nodiscard]] double mostWidth() const;
    void setWidth(const Sized& unit, double width);

    struct Taken {
        Sized unit;
        Corner corner = Corner::none;
        QPointF grip;     // from the corner to the pointer
        double width = 0; // as dragged, in logical pixels
    };
    DocumentView& view_;
    std::optional<Taken> taken_;
    QRectF shown_; // what has corners, in the viewport
};

} // namespace view
