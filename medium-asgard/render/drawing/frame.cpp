#include "drawing/frame.h"

#include "drawing/shaders.h"

#include <algorithm>
#include <cmath>

namespace render {

Frame::Frame(const Drawing& drawing, Size size)
    : camera_(drawing.camera), size_(size),
      linear_(drawing.camera.scale * drawing.camera.rotation.toRotationMatrix()) {}

double Frame::pixels(double viewLength, double viewZ) const {
    const double toward = enlargement(camera_, std::min(viewZ, eyeDistance - 0.02));
    return viewLength * toward * pixelsPerUnit(size_);
}

float Frame::stroke(double width) const {
    const double scale = std::min(size_.width, size_.height) / 480.0;
    return static_cast<float>(width * std::clamp(scale, 0.8 * size_.ratio, 8 * size_.ratio));
}

std::array<float, 16> Frame::projection(double nearestZ, double furthestZ) const {
    const double units = 2 * pixelsPerUnit(size_);
    std::array<float, 16> m{};
    if (camera_.orthographic) {
        const double deep = std::max(nearestZ - furthestZ, 1e-3);
        m[0] = static_cast<float>(units / size_.width);
        m[5] = static_cast<float>(-units / size_.height);
        m[10] = static_cast<float>(-2 / deep);
        m[14] = static_cast<float>((nearestZ + furthestZ) / deep);
        m[15] = 1;
        return m;
    }
    const double near = std::max(eyeDistance - nearestZ, 0.02);
    const double far = std::max(eyeDistance - furthestZ, near * 1.001);
    const double a = (far + near) / (far - near), b = -2 * far * near / (far - near);
    // With the distance from the eye d = D - z: clip z = a d + b, clip w = d.
    m[0] = static_cast<float>(eyeDistance * units / size_.width);
    m[5] = static_cast<float>(-eyeDistance * units / size_.height);
    m[10] = static_cast<float>(-a);
    m[11] = -1;
    m[14] = static_cast<float>(a * eyeDistance + b);
    m[15] = static_cast<float>(eyeDistance);
    return m;
}

double linearLight(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<Light> lightsOf(const scene::Scene& scene, const Vector& toSun, const Frame& frame) {
    std::vector<Light> lights;
    for (const scene::LightSource& source : scene.lights) {
        if (lights.size() == mostLights)
            break; // LIMIT: further light sources do not shine
        Light light;
        light.isPoint = !source.direction;
        if (source.direction && source.direction->norm() > 0)
            light.place = frame.directionInView(-source.direction->normalized());
        else if (source.position)
            light.place = frame.toView(*source.position);
        const scene::Color& c = source.color;
        for (int i = 0; i < 3; ++i)
            light.color[i] = static_cast<float>(0.75 * linearLight(i == 0   ? c.red
                                                                   : i == 1 ? c.green
                                                                            : c.blue));
        lights.push_back(light);
    }
    if (lights.empty()) {
        lights.push_back({frame.directionInView(toSun), false, {0.70F, 0.68F, 0.64F}, true});
    }
    return lights;
}

int shadowedOf(const std::vector<Light>& lights) {
    const auto far = std::ranges::find(lights, false, &Light::isPoint);
    return far == lights.end() ? 0 : static_cast<int>(far - lights.begin());
}

std::array<float, 16> LightSight::columns() const {
    std::array<float, 16> columns;
    for (std::size_t i = 0; i < columns.size(); ++i)
        columns[i] = static_cast<float>(matrix(static_cast<int>(i % 4), static_cast<int>(i / 4)));
    return columns;
}

} // namespace render
