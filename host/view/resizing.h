// Resizing a picture or a subdocument by a lower corner, which keeps its ratio, and a subdocument
// by an edge, which changes that side alone. A click on a picture selects it; a chosen subdocument
// has handles, too. A double click on a handle gives it the size back that it has by itself.
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
    bool hasEdges = false; // its sides may be changed one by one
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

    static constexpr double side = 9; // of a handle, in logical pixels

private:
    enum class Handle { none, leftCorner, rightCorner, left, right, bottom };
    [[nodiscard]] static std::vector<Handle> handlesOf(const Sized& unit);
    [[nodiscard]] static bool isCorner(Handle handle) { return handle < Handle::left; }
    [[nodiscard]] static bool isLeft(Handle handle) {
        return handle == Handle::leftCorner || handle == Handle::left;
    }
    [[nodiscard]] static QPointF pointOf(const QRectF& place, Handle handle);
    [[nodiscard]] static QRectF rectOf(const QRectF& place, Handle handle);
    [[nodiscard]] static Handle handleAt(const Sized& unit, QPointF point);
    [[nodiscard]] QSizeF mostSize() const;
    void setSize(const Sized& unit, QSizeF size, bool isFree);

    struct Taken {
        Sized unit;
        Handle handle = Handle::none;
        QPointF grip; // from the handle to the pointer
        QSizeF size;  // as dragged, in logical pixels
    };
    DocumentView& view_;
    std::optional<Taken> taken_;
    QRectF shown_; // what has handles, in the viewport
};

} // namespace view
