#include "framing/framing.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace render {

namespace {

constexpr double filled = 0.88; // of the picture's half width and height

Eigen::Vector2d halfExtent(Size size) {
    const double units = 2 * pixelsPerUnit(size);
    return {size.width / units, size.height / units};
}

// A ball at (x, y, z) about the centre, radius r, seen at scale s, reaches on screen to
// s (|x| + r) D / (D - s z); that is within m when s <= m D / ((|x| + r) D + m z).
double fittingScale(const std::vector<Ball>& seen, const Vector& center, Size size, double eye) {
    const Eigen::Vector2d m = filled * halfExtent(size);
    double scale = std::numeric_limits<double>::infinity();
    for (const Ball& ball : seen) {
        const Vector p = ball.center - center;
        for (int axis = 0; axis < 2; ++axis) {
            const double needed =
                (std::abs(p[axis]) + ball.radius) * eye + m[axis] * (p.z() + ball.radius);
            if (needed > 0)
                scale = std::min(scale, m[axis] * eye / needed);
        }
    }
    return std::isfinite(scale) ? scale : 1;
}

std::vector<Ball> turned(const Extent& extent, const Quaternion& attitude) {
    std::vector<Ball> seen = extent.balls;
    for (Ball& ball : seen)
        ball.center = attitude * ball.center;
    return seen;
}

// The point of the same depth whose picture is in the middle of all pictures of the balls.
Vector recentred(const std::vector<Ball>& seen, const Vector& center, double scale, double eye) {
    Eigen::AlignedBox2d onScreen;
    for (const Ball& ball : seen) {
        const Vector p = scale * (ball.center - center);
        const double nearness = eye / std::max(eye - p.z(), 0.05);
        const double r = scale * ball.radius * nearness;
        const Eigen::Vector2d q = p.head<2>() * nearness;
        onScreen.extend(Eigen::Vector2d(q.array() - r));
        onScreen.extend(Eigen::Vector2d(q.array() + r));
    }
    Vector moved = center;
    moved.head<2>() += onScreen.center() / scale;
    return moved;
}

} // namespace

// 28 degrees to the side of the front, 20 above. The front is z, or -y where z is up.
Vector sideAndAbove(const Vector& up) {
    const Vector front =
        std::abs(up.z()) < 0.5 ? Vector(Vector::UnitZ()) : Vector(-Vector::UnitY());
    const Vector right = up.cross(front);
    const double side = 28 * M_PI / 180, above = 20 * M_PI / 180;
    return std::cos(above) * (std::cos(side) * front + std::sin(side) * right) +
           std::sin(above) * up;
}

Quaternion bestAttitude(const Extent& extent) {
    return facing(extent.planeNormal.value_or(sideAndAbove(extent.up)), extent.up);
}

Vector sunOf(const Extent& extent) {
    const Vector toward = bestAttitude(extent).conjugate() * Vector::UnitZ();
    const Vector front = (toward - toward.dot(extent.up) * extent.up).normalized();
    const Vector left = front.cross(extent.up);
    return (0.42 * left + 0.80 * extent.up + 0.50 * front).normalized();
}

Camera fittedAbout(const Extent& extent, const Quaternion& attitude, const Vector& center,
                   Size size, bool orthographic) {
    Camera camera{center, attitude, 1, Vector::Zero(), orthographic};
    camera.scale = fittingScale(turned(extent, attitude), attitude * center, size, eyeOf(camera));
    return camera;
}

Camera fitted(const Extent& extent, const Quaternion& attitude, Size size, bool orthographic) {
    const double eye = eyeOf({.orthographic = orthographic});
    const std::vector<Ball> seen = turned(extent, attitude);
    Eigen::AlignedBox3d box;
    for (const Ball& ball : seen) {
        box.extend(Vector(ball.center.array() - ball.radius));
        box.extend(Vector(ball.center.array() + ball.radius));
    }
    Vector center = box.center();
    // Perspective makes what is nearer larger: centre and scale settle in a few rounds.
    for (int round = 0; round < 4; ++round)
        center = recentred(seen, center, fittingScale(seen, center, size, eye), eye);
    return {attitude.conjugate() * center, attitude, fittingScale(seen, center, size, eye),
            Vector::Zero(), orthographic};
}

bool isWithin(const Camera& camera, Size size, const Ball& ball) {
    const double depth =
        camera.scale * (camera.rotation * (ball.center - camera.center)).z() + camera.position.z();
    if (depth + ball.radius * camera.scale >= eyeOf(camera))
        return false;
    const double radius =
        ball.radius * camera.scale * pixelsPerUnit(size) * enlargement(camera, depth);
    const Eigen::Vector2d middle = toPixels(camera, size, ball.center);
    const Eigen::AlignedBox2d picture(Eigen::Vector2d(0, 0),
                                      Eigen::Vector2d(size.width, size.height));
    return picture.contains(Eigen::Vector2d(middle.array() - radius)) &&
           picture.contains(Eigen::Vector2d(middle.array() + radius));
}

Camera steppedBack(const Camera& camera, Size size, const std::vector<Ball>& balls) {
    constexpr double step = 0.96;
    constexpr int most = 200;
    Camera back = camera;
    const auto isSeen = [&](const Ball& ball) { return isWithin(back, size, ball); };
    for (int i = 0; i < most && !std::ranges::all_of(balls, isSeen); ++i) {
        back.scale *= step;
        back.position *= step;
    }
    return back;
}

Camera keeping(const Camera& camera, Size before, Size now, const std::vector<Ball>& balls) {
    std::vector<Ball> seen;
    std::ranges::copy_if(balls, std::back_inserter(seen),
                         [&](const Ball& ball) { return isWithin(camera, before, ball); });
    return steppedBack(camera, now, seen);
}

Camera framed(const scene::Scene& scene, const simulation::MotionPointer& motion, Size size) {
    const Extent extent = extentOf(scene, motion.get());
    return fitted(extent, bestAttitude(extent), size);
}

} // namespace render
