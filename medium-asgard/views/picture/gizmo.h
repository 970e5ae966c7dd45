// The arrows, squares and rings of the body that is selected: a drag of an arrow moves the body
// along that axis, of a square in the plane of the two arrows that it stands between, and of a ring
// turns it about that axis. Several have arrows and squares alone, in their middle.
//
// Arrows begin beside the body and rings go around it, as far as the picture has room for them, so
// that a drag that begins on the body is the body's. The arrows and rings of a body for which there
// is no room lie on it.
#pragma once

#include "geometry/pose.h"
#include "scene/scene.h"

#include <QLineF>
#include <QPointF>
#include <QPolygonF>

#include <memory>
#include <optional>
#include <utility>
#include <vector>

class QPainter;

namespace views {

class SceneDisplay;
class SceneDocument;

class Gizmo {
public:
    Gizmo(SceneDocument& document, SceneDisplay& display)
        : document_(document), display_(display) {}

    struct Part {
        std::size_t body;
        int axis;
        bool isRing = false;
        bool isPlane = false; // a square across the axis
    };
    [[nodiscard]] std::optional<Part> at(const QPointF& position) const;
    void paint(QPainter& painter) const;
    // Of the bodies that are selected, from its tail to its head; none: it looks at the viewer.
    [[nodiscard]] std::optional<QLineF> arrow(int axis) const;
    // The square across an axis; empty: that plane is seen too steeply.
    [[nodiscard]] QPolygonF square(int axis) const;
    [[nodiscard]] double ringRadius(std::size_t body) const; // pixels
    // The point about which rings turn the body: the middle of its mass, or the origin of its shape
    // where the text cannot move that alone.
    [[nodiscard]] geometry::Vector pivotOf(std::size_t body) const;

private:
    using Discs = std::vector<std::pair<QPointF, double>>; // from a place of the screen; radii

    [[nodiscard]] bool isPlacedAlone(std::size_t body) const;
    // Of the bodies that are selected, while a drag would move their start.
    struct Place {
        std::size_t body = 0; // the first of them
        geometry::Vector middle;
        bool isOne = true;
        Discs silhouette = {}; // in their middle
    };
    [[nodiscard]] std::optional<Place> place() const;
    struct Arrow {
        QLineF line;
        bool isBeside = true; // the bodies
    };
    [[nodiscard]] static double reachOf(const Place& place, const QPointF& way);
    [[nodiscard]] std::optional<Arrow> arrowOf(const Place& place, int axis) const;
    struct Square {
        QPolygonF corners;
        bool isBeside = true;
    };
    [[nodiscard]] std::optional<Square> squareOf(const Place& place, int axis) const;
    struct Radius {
        double pixels;
        bool isBeside = true;
    };
    [[nodiscard]] Radius radiusOf(const Place& place) const;
    void addSilhouette(Place& place, std::size_t body) const;
    // The half of the ring that is in front.
    [[nodiscard]] QPolygonF ringOf(const geometry::Vector& place, double pixels, int axis) const;

    SceneDocument& document_;
    SceneDisplay& display_;
    struct Alone { // as it was found last
        std::shared_ptr<const scene::Scene> scene;
        std::size_t body = 0;
        bool is = true;
    };
    mutable Alone alone_;
};

// Red, green and blue, as the axes of the world are.
[[nodiscard]] unsigned colorOfAxis(int axis);

} // namespace views
