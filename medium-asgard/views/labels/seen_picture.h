// The picture that labels stand in: all that they know of it.
//
// A picture that takes long shows an older scene than the document has: labels stand on the one
// that is seen.
#pragma once

#include "gestures/picking.h"
#include "handles/handles.h"
#include "render/renderer.h"

#include <QPointF>
#include <QWidget>

#include <cstddef>

namespace views {

class SeenPicture {
public:
    virtual ~SeenPicture() = default;

    // The scene with its motion, at the time that is seen, from there and with these switches.
    [[nodiscard]] virtual render::Drawing drawn() const = 0;
    // The handles that are seen.
    [[nodiscard]] virtual const render::HandleSet& drawnHandles() const = 0;
    // Of mass, in the world, at the time that is seen.
    [[nodiscard]] virtual geometry::Vector centerOf(std::size_t body) const = 0;
    // The widget that shows it: its size, letters and colours.
    [[nodiscard]] virtual QWidget& widget() = 0;
    [[nodiscard]] virtual gestures::Sight sight() const = 0; // in the device's pixels
    // A point of the widget from the device's pixels.
    [[nodiscard]] virtual QPointF fromPixels(const Eigen::Vector2d& pixels) const = 0;
};

} // namespace views
