// The viewpoint of a scene, and its moves by pointer and keys.
//
// A point p of the world is seen at view = scale * R(rotation) * (p - center) + position, the
// screen's x right, y up, z towards the viewer (dissertation 4.1.7; scene language, `view`).
// The picture shows view coordinates -1..1 over its height and at least -4/3..4/3 over its width:
// one that is narrower than 4:3 shows more above and below, and cuts nothing at its sides. Lengths
// are exact in perspective in the plane view z = 0, orthographic everywhere.
#pragma once

#include "geometry/pose.h"
#include "motion/motion.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>

namespace render {

using geometry::Quaternion;
using geometry::Vector;

struct Camera {
    Vector center = Vector::Zero();               // world: centre of rotation and scaling
    Quaternion rotation = Quaternion::Identity(); // world to view
    double scale = 1;                             // view units per world unit
    Vector position = Vector::Zero();             // view units: pan
    bool orthographic = false;                    // parallel lines of sight
    bool operator==(const Camera& other) const;
};

struct Size {
    int width = 640, height = 480; // device pixels
    double ratio = 1;              // device pixels for one of the reader's
    bool operator==(const Size&) const = default;
};

// Of one view unit across, where lengths are exact.
[[nodiscard]] double pixelsPerUnit(Size size);

// The eye of a perspective picture stands on the view's z axis, this far in front of z = 0.
inline constexpr double eyeDistance = 5;

// Where the lines of sight come together, on the view's z axis. That of an orthographic picture is
// so far away that they are parallel to a millionth.
[[nodiscard]] inline double eyeOf(const Camera& camera) {
    return camera.orthographic ? 1e6 * eyeDistance : eyeDistance;
}

// How much larger than at z = 0 a length is seen at another view depth.
[[nodiscard]] double enlargement(const Camera& camera, double viewZ);

// Radius of the sphere that the pointer turns, view units.
inline constexpr double virtualSphere = 0.85;

// Pixels (origin top left) of a world point, and back to the world at a given view depth z.
[[nodiscard]] Eigen::Vector2d toPixels(const Camera& camera, Size size, const Vector& world);
[[nodiscard]] Vector toWorld(const Camera& camera, Size size, const Eigen::Vector2d& pixels,
                             double viewZ = 0);

// The same picture, from now on turned and scaled about another point of the world.
[[nodiscard]] Camera turningAbout(const Camera& camera, const Vector& world);

// The attitude that looks against `toward`, with `up` upwards where that is possible: along a world
// axis, the picture's plane is a coordinate plane.
[[nodiscard]] Quaternion facing(const Vector& toward, const Vector& up);

// The camera that shows all of the motion well: everything that moves, over the whole motion (what
// flies far off from all the rest only while it is near), and what is fixed near it, with a margin;
// from slightly above and to the side when the motion is not planar, straight on when it is.
// Without a motion: the bodies where they start.
[[nodiscard]] Camera framed(const scene::Scene& scene, const simulation::MotionPointer& motion,
                            Size size);

// Upright turning. The way of a pointer over the front of the scene, view units to the right and
// up: what is sideways turns it about `up`, what is upwards tilts it, and an upright picture stays
// upright. It stops straight from above and straight from below.
[[nodiscard]] Quaternion turnedUpright(const Quaternion& rotation, const Vector& up,
                                       const Eigen::Vector2d& way);

// Unshifted buttons move the view: left turns it upright, or freely, by a virtual sphere; middle
// pans in the screen's plane, right scales (vertical) or rolls about the line of sight
// (horizontal); the wheel scales about the pointer. Rotations compose as quaternions.
class CameraControl {
public:
    enum class Button : std::uint8_t { left, middle, right };

    explicit CameraControl(const Camera& camera = {}) : camera_(camera) {}
    [[nodiscard]] const Camera& camera() const { return camera_; }
    void set(const Camera& camera) { camera_ = camera; }

    // `up`: of the world, which stays upright in the picture.
    void press(Button button, Eigen::Vector2d pixels, Size size,
               const Vector& up = Vector::UnitY());
    // True when the view changed. `freely`: the left button turns it about any axis, and rolls it
    // at the picture's rim.
    bool move(Eigen::Vector2d pixels, Size size, bool freely = false);
    void release();
    void wheel(Eigen::Vector2d pixels, double notches, Size size);
    [[nodiscard]] bool active() const { return pressed_.has_value(); }

private:
    bool scaleOrRoll(Eigen::Vector2d from, Eigen::Vector2d to, Size size);

    Camera camera_;
    Vector up_ = Vector::UnitY();
    std::optional<Button> pressed_;
    Eigen::Vector2d last_ = Eigen::Vector2d::Zero();
    Eigen::Vector2d first_ = Eigen::Vector2d::Zero();
    std::optional<bool> rolls_; // of a right drag, once its direction is clear
};

} // namespace render
