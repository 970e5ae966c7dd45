// The arrows and rings of the body that is selected: a drag of an arrow moves the body along that
// axis, a drag of a ring turns it about that axis. Several have the arrows alone, in their middle.
#pragma once

#include "geometry/pose.h"
#include "scene/scene.h"

#include <QPointF>
#include <QPolygonF>

#include <memory>
#include <optional>
#include <utility>

class QPainter;

namespace views {

class SceneDisplay;
class SceneDocument;

class Gizmo {
public:
    Gizmo(SceneDocument& document, SceneDisplay& display)
        : document_(document), display_(display) {}

    static constexpr double ring = 92; // pixels: the rings' radius

    struct Part {
        std::size_t body;
        int axis;
        bool isRing = false;
    };
    [[nodiscard]] std::optional<Part> at(const QPointF& position) const;
    void paint(QPainter& painter) const;
    // The point about which rings turn the body: the middle of its mass, or the origin of its shape
    // where the text cannot move that alone.
    [[nodiscard]] geometry::Vector pivotOf(std::size_t body) const;

private:
    [[nodiscard]] bool isPlacedAlone(std::size_t body) const;
    // Of the bodies that are selected, while a drag would move their start.
    struct Place {
        std::size_t body = 0; // the first of them
        geometry::Vector middle;
        bool isOne = true;
    };
    [[nodiscard]] std::optional<Place> place() const;
    // From its tail to its head on the screen; none: it looks at the viewer.
    [[nodiscard]] std::optional<std::pair<QPointF, QPointF>> arrow(const geometry::Vector& place,
                                                                   int axis) const;

    // The half of the ring that is in front.
    [[nodiscard]] QPolygonF ringOf(const geometry::Vector& place, int axis) const;

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
