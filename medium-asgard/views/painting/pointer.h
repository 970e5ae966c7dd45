// The pointer in pictures: which buttons move the view, and what is a click.
#pragma once

#include "framing/camera.h"

#include <QPoint>

#include <optional>

namespace views {

[[nodiscard]] inline std::optional<render::CameraControl::Button> viewButton(Qt::MouseButton one) {
    using Button = render::CameraControl::Button;
    switch (one) {
    case Qt::LeftButton:
        return Button::left;
    case Qt::MiddleButton:
        return Button::middle;
    case Qt::RightButton:
        return Button::right;
    default:
        return std::nullopt;
    }
}

// Two places of a window, so near each other that the pointer was not dragged.
[[nodiscard]] inline bool isNear(const QPointF& one, const QPointF& other) {
    constexpr double still = 4; // pixels
    return (one - other).manhattanLength() < still;
}

} // namespace views
