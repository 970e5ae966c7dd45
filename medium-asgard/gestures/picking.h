// The things under the pointer: handles by their distance on the screen, bodies by the line of
// sight.
#pragma once

#include "geometry/shape.h"
#include "handles/handles.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gestures {

using geometry::Vector;

// Where a picture is seen from; its pixels.
struct Sight {
    render::Camera camera;
    render::Size size;
    [[nodiscard]] Eigen::Vector2d pixels(const Vector& world) const {
        return render::toPixels(camera, size, world);
    }
    // At the depth of another point, in the plane of the screen through it.
    [[nodiscard]] Vector beside(const Eigen::Vector2d& pixels, const Vector& world) const;
    // In the plane through another point that is upright or level in the world, whichever faces the
    // viewer most: across z, x or y.
    [[nodiscard]] Vector across(const Eigen::Vector2d& pixels, const Vector& world) const;
    [[nodiscard]] Eigen::Index facing() const; // the axis that looks at the viewer most
    [[nodiscard]] bool isPlan() const; // it looks straight at the viewer: no place has a depth
    [[nodiscard]] double depth(const Vector& world) const; // view units, towards the viewer
    // The length in the world that a pixel shows at that point.
    [[nodiscard]] double pixelLength(const Vector& world) const;
};

struct Line { // from the eye
    Vector from, direction;
};
[[nodiscard]] Line lineOfSight(const Sight& sight, const Eigen::Vector2d& pixels);
// The place that is meant on a level plane, up . x = height: seen from above, and no further away
// than things that are a quarter as large there. None: seen from the side, or the sky.
[[nodiscard]] std::optional<Vector> onGround(const Sight& sight, const Eigen::Vector2d& pixels,
                                             const Vector& up, double height);

// The handle nearest to the pixels within `reach` of them; of two in one place the smaller, which
// is drawn on top. Those that cannot be moved are not taken.
[[nodiscard]] std::optional<std::size_t> handleAt(const render::HandleSet& set, const Sight& sight,
                                                  const Eigen::Vector2d& pixels, double reach);

// The crowd of handles there: the one that is open up to `reach` around it.
[[nodiscard]] std::optional<render::HandleName>
crowdAt(const render::HandleSet& set, const Eigen::Vector2d& pixels, double reach);

// The joint whose sign is there: the handle of its point, which need not be shown.
[[nodiscard]] std::optional<render::Handle> jointAt(const render::Drawing& drawing,
                                                    const Sight& sight,
                                                    const Eigen::Vector2d& pixels, double reach);

struct Picked {
    std::size_t body = 0;
    Vector point;                   // world, on its surface
    Vector normal = Vector::Zero(); // world, outward
};
// All bodies on the line of sight, the front-most first.
[[nodiscard]] std::vector<Picked> bodiesAt(const render::Drawing& drawing, const Sight& sight,
                                           const Eigen::Vector2d& pixels);
// The front-most body, or of all but one.
[[nodiscard]] std::optional<Picked> bodyAt(const render::Drawing& drawing, const Sight& sight,
                                           const Eigen::Vector2d& pixels,
                                           std::optional<std::size_t> but = std::nullopt);
// The same, or the body whose edge is seen within `reach` of pixels that show none, or a floor.
[[nodiscard]] std::optional<Picked> bodyBeside(const render::Drawing& drawing, const Sight& sight,
                                               const Eigen::Vector2d& pixels, double reach,
                                               std::optional<std::size_t> but = std::nullopt);

// A place of the world, as near as rounded numbers tell, is inside of the body or on its surface.
[[nodiscard]] bool isIn(const render::Drawing& drawing, std::size_t body, const Vector& place);
// The body there, of several the smallest, or of all but one.
[[nodiscard]] std::optional<std::size_t> bodyAround(const render::Drawing& drawing,
                                                    const Vector& place,
                                                    std::optional<std::size_t> but = std::nullopt);

// The bodies whose middle is seen in the rectangle between two of its corners; none without extent,
// as a floor.
[[nodiscard]] std::vector<std::size_t> bodiesWithin(const render::Drawing& drawing,
                                                    const Sight& sight, const Eigen::Vector2d& one,
                                                    const Eigen::Vector2d& other);

// The trajectory whose line passes nearest, within `reach`.
[[nodiscard]] std::optional<std::size_t> trajectoryAt(const scene::Scene& scene, const Sight& sight,
                                                      const Eigen::Vector2d& pixels, double reach);

// The surface of one body, in its shape's frame; null: its shape cannot be made. Made once for each
// description; hulls of many points take a while, so prepareShapes() has them made by a thread that
// has time. Any thread.
using ShapePointer = std::shared_ptr<const geometry::Shape>;
[[nodiscard]] ShapePointer shapeOf(const scene::Scene& scene, const std::string& body);
// And forgets those of other scenes.
void prepareShapes(const std::vector<std::shared_ptr<const scene::Scene>>& scenes);
[[nodiscard]] bool isEndless(const geometry::Shape& shape); // a floor

} // namespace gestures
