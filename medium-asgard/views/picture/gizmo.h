// The three arrows of the body that is selected: a drag of one moves the body along that axis.
#pragma once

#include "geometry/pose.h"

#include <QPointF>

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

    struct Arrow {
        std::size_t body;
        int axis;
    };
    [[nodiscard]] std::optional<Arrow> at(const QPointF& position) const;
    void paint(QPainter& painter) const;

private:
    // The one body that is selected, while a drag would move its start.
    [[nodiscard]] std::optional<std::pair<std::size_t, geometry::Vector>> place() const;
    // From its tail to its head on the screen; none: it looks at the viewer.
    [[nodiscard]] std::optional<std::pair<QPointF, QPointF>> arrow(const geometry::Vector& place,
                                                                   int axis) const;

    SceneDocument& document_;
    SceneDisplay& display_;
};

// Red, green and blue, as the axes of the world are.
[[nodiscard]] unsigned colorOfAxis(int axis);

} // namespace views
