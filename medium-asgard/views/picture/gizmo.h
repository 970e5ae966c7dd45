// The arrows and rings of the body that is selected: a drag of an arrow moves the body along that
// axis, a drag of a ring turns it about that axis.
#pragma once

#include "geometry/pose.h"

#include <QPointF>
#include <QPolygonF>

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

private:
    // The one body that is selected, while a drag would move its start.
    [[nodiscard]] std::optional<std::pair<std::size_t, geometry::Vector>> place() const;
    // From its tail to its head on the screen; none: it looks at the viewer.
    [[nodiscard]] std::optional<std::pair<QPointF, QPointF>> arrow(const geometry::Vector& place,
                                                                   int axis) const;

    // The half of the ring that is in front.
    [[nodiscard]] QPolygonF ringOf(const geometry::Vector& place, int axis) const;

    SceneDocument& document_;
    SceneDisplay& display_;
};

// Red, green and blue, as the axes of the world are.
[[nodiscard]] unsigned colorOfAxis(int axis);

} // namespace views
