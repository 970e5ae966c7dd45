#include "framing/camera.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

// The nearest that a point may come to the eye before it is pushed away from it: keeps the
// projection of points beside and behind the eye finite.
constexpr double nearest = 1e-3;

Eigen::Vector2d middle(Size size) { return {0.5 * size.width, 0.5 * size.height}; }

// Where a pixel's line of sight meets a plane of constant view z.
Vector toView(const Camera& camera, Size size, const Eigen::Vector2d& pixels, double viewZ) {
    const Eigen::Vector2d onScreen = (pixels - middle(size)) / pixelsPerUnit(size);
    const double nearness = camera.orthographic ? 1 : (eyeDistance - viewZ) / eyeDistance;
    return {onScreen.x() * nearness, -onScreen.y() * nearness, viewZ};
}

// The virtual sphere (Chen 1988, Shoemake 1992): the pointer lies on a sphere that fills most of
// the picture; outside, it turns the sphere's rim, which rolls the scene.
Vector onVirtualSphere(Size size, const Eigen::Vector2d& pixels) {
    const Eigen::Vector2d p = (pixels - middle(size)) / (pixelsPerUnit(size) * virtualSphere);
    const double squared = p.squaredNorm();
    return Vector(p.x(), -p.y(), squared < 1 ? std::sqrt(1 - squared) : 0).normalized();
}

} // namespace

double pixelsPerUnit(Size size) { return 0.5 * std::min(0.75 * size.width, 1.0 * size.height); }

bool Camera::operator==(const Camera& other) const {
    return center == other.center && rotation.coeffs() == other.rotation.coeffs() &&
           scale == other.scale && position == other.position && orthographic == other.orthographic;
}

double enlargement(const Camera& camera, double viewZ) {
    return camera.orthographic ? 1 : eyeDistance / std::max(eyeDistance - viewZ, nearest);
}

Eigen::Vector2d toPixels(const Camera& camera, Size size, const Vector& world) {
    const Vector view =
        camera.scale * (camera.rotation * (world - camera.center)) + camera.position;
    return middle(size) + pixelsPerUnit(size) * enlargement(camera, view.z()) *
                              Eigen::Vector2d(view.x(), -view.y());
}

Vector toWorld(const Camera& camera, Size size, const Eigen::Vector2d& pixels, double viewZ) {
    const Vector view = toView(camera, size, pixels, viewZ) - camera.position;
    return camera.rotation.conjugate() * (view / camera.scale) + camera.center;
}

Camera turningAbout(const Camera& camera, const Vector& world) {
    Camera moved = camera;
    moved.position += camera.scale * (camera.rotation * (world - camera.center));
    moved.center = world;
    return moved;
}

Quaternion facing(const Vector& toward, const Vector& up) {
    Vector right = up.cross(toward);
    // Straight down or up: any side will do.
    if (right.norm() < 1e-9 * up.norm() * toward.norm())
        right = toward.unitOrthogonal();
    right.normalize();
    // Columns: where the screen's right, up and towards-the-viewer point in the world.
    Eigen::Matrix3d axes;
    axes << right, toward.cross(right).normalized(), toward.normalized();
    return Quaternion(Eigen::Matrix3d(axes.transpose())).normalized();
}

Quaternion turnedUpright(const Quaternion& rotation, const Vector& up, const Eigen::Vector2d& way) {
    constexpr double steepest = M_PI / 2 - 1e-4; // beyond it sideways would change its sense
    const Vector upInView = rotation * up.normalized();
    Vector level = upInView.cross(Vector::UnitZ()); // in the picture, to the right if it is upright
    if (level.norm() < 1e-6)                        // straight from above: all of it is level
        level = Vector::UnitX();
    level.normalize();
    const double above = std::asin(std::clamp(upInView.z(), -1.0, 1.0));
    const double sideways = way.dot(level.head<2>());
    const double upwards = way.dot(Eigen::Vector2d(-level.y(), level.x()));
    const double tilt = std::clamp(above - upwards / virtualSphere, -steepest, steepest) - above;
    return (Quaternion(Eigen::AngleAxisd(tilt, level)) * rotation *
            Quaternion(Eigen::AngleAxisd(sideways / virtualSphere, up.normalized())))
        .normalized();
}

void CameraControl::press(Button button, Eigen::Vector2d pixels, Size, const Vector& up) {
    pressed_ = button;
    up_ = up;
    first_ = last_ = pixels;
    rolls_.reset();
}

void CameraControl::release() { pressed_.reset(); }

bool CameraControl::move(Eigen::Vector2d pixels, Size size, bool freely) {
    if (!pressed_ || pixels == last_)
        return false;
    const Eigen::Vector2d from = last_;
    last_ = pixels;
    switch (*pressed_) {
    case Button::left:
        if (freely) {
            const Quaternion turn = Quaternion::FromTwoVectors(onVirtualSphere(size, from),
                                                               onVirtualSphere(size, pixels));
            camera_.rotation = (turn * camera_.rotation).normalized();
        } else {
            const Eigen::Vector2d way = (pixels - from) / pixelsPerUnit(size);
            camera_.rotation = turnedUpright(camera_.rotation, up_, {way.x(), -way.y()});
        }
        return true;
    case Button::middle:
        // In the plane through the centre of rotation, so that what one holds stays under the hand.
        camera_.position += toView(camera_, size, pixels, camera_.position.z()) -
                            toView(camera_, size, from, camera_.position.z());
        return true;
    case Button::right:
        return scaleOrRoll(from, pixels, size);
    }
    return false;
}

bool CameraControl::scaleOrRoll(Eigen::Vector2d from, Eigen::Vector2d to, Size size) {
    if (!rolls_) {
        // Which of the two is meant shows after a few pixels; until then nothing moves.
        const Eigen::Vector2d way = to - first_;
        if (way.cwiseAbs().maxCoeff() < 4)
            return false;
        rolls_ = std::abs(way.x()) > std::abs(way.y());
        from = first_;
    }
    const Eigen::Vector2d way = (to - from) / pixelsPerUnit(size);
    if (*rolls_) {
        const Quaternion turn(Eigen::AngleAxisd(-way.x() * 1.5, Vector::UnitZ()));
        camera_.rotation = (turn * camera_.rotation).normalized();
    } else {
        camera_.scale *= std::exp(-1.5 * way.y());
    }
    return true;
}

void CameraControl::wheel(Eigen::Vector2d pixels, double notches, Size size) {
    const double factor = std::exp(0.15 * notches);
    // The point of the centre's plane under the pointer stays where it is.
    const Vector held = toView(camera_, size, pixels, camera_.position.z());
    camera_.scale *= factor;
    camera_.position = held + factor * (camera_.position - held);
}

} // namespace render
