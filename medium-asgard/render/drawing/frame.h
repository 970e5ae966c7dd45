// One picture's numbers: the camera as matrices, the depth range, the light.
#pragma once

#include "drawing/drawing.h"

#include <array>

namespace render {

class Frame {
public:
    Frame(const Drawing& drawing, Size size);

    [[nodiscard]] Vector toView(const Vector& world) const {
        return linear_ * (world - camera_.center) + camera_.position;
    }
    [[nodiscard]] const Eigen::Matrix3d& linear() const { return linear_; } // scale and rotation
    [[nodiscard]] Vector directionInView(const Vector& world) const {
        return camera_.rotation * world;
    }
    // View: where the lines of sight come together (framing/camera.h).
    [[nodiscard]] Vector eye() const { return {0, 0, eyeOf(camera_)}; }

    // How long a length at that view depth is on screen.
    [[nodiscard]] double pixels(double viewLength, double viewZ) const;
    // Line widths are meant for a picture 480 pixels high and grow with it; on a finer screen they
    // are as wide in a small picture as on any.
    [[nodiscard]] float stroke(double width) const;

    // To clip space, column by column, upside down: rows are read back bottom first, and shall be
    // the picture's top first. Depth holds what lies between the two view z.
    [[nodiscard]] std::array<float, 16> projection(double nearestZ, double furthestZ) const;

    [[nodiscard]] Size size() const { return size_; }
    [[nodiscard]] Eigen::Vector2f halfSize() const {
        return {0.5F * static_cast<float>(size_.width), 0.5F * static_cast<float>(size_.height)};
    }
    [[nodiscard]] const Camera& camera() const { return camera_; }

private:
    Camera camera_;
    Size size_;
    Eigen::Matrix3d linear_;
};

// sRGB to linear, one component.
[[nodiscard]] double linearLight(double encoded);

struct Light {
    Vector place = Vector::UnitZ(); // view: unit direction towards it, or where it stands
    bool isPoint = false;
    Eigen::Vector3f color = Eigen::Vector3f::Ones(); // linear
    bool isSun = false; // the default one: a little light from beside the eye belongs to it
};

// The scene's lights in view coordinates, at most `mostLights`. One without any has the sun, in the
// direction given (world).
[[nodiscard]] std::vector<Light> lightsOf(const scene::Scene& scene, const Vector& toSun,
                                          const Frame& frame);

// The light that throws shadows: the first that shines from afar, else the first.
[[nodiscard]] int shadowedOf(const std::vector<Light>& lights);

// How a light sees the view (shadow_map.h).
struct LightSight {
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity(); // to its clip space
    double texel = 0;    // view length of a texel of its map, where it is largest
    double softness = 0; // of a shadow's rim, as a part of the map's width
    int samples = 1;     // of the map for each pixel, at most 8; of all maps the same
    [[nodiscard]] std::array<float, 16> columns() const;
    // Where in the map a point of the view is: x, y and depth from -1 to 1.
    [[nodiscard]] Vector toMap(const Vector& view) const {
        return (matrix * view.homogeneous()).hnormalized();
    }
};
inline constexpr std::size_t mostShadowMaps = 2; // of what is near, and of everything

} // namespace render
