#include "render/frame.h"

#include "render/shaders.h"

#include <algorithm>
#include <cmath>

namespace render {

Frame::Frame(const Drawing& drawing, Size size)
    : camera_(drawing.camera), size_(size),
      linear_(drawing.camera.scale * drawing.camera.rotation.toRotationMatrix()) {}

double Frame::pixels(double viewLength, double viewZ) const {
    const double toward = eyeDistance / std::max(eyeDistance - viewZ, 0.02);
    return viewLength * toward * 0.5 * std::min(size_.width, size_.height);
}

float Frame::stroke(double width) const {
    const double scale = std::min(size_.width, size_.height) / 480.0;
    return static_cast<float>(width * std::clamp(scale, 0.8, 8.0));
}

std::array<float, 16> Frame::projection(double nearestZ, double furthestZ) const {
    const double shorter = std::min(size_.width, size_.height);
    const double near = std::max(eyeDistance - nearestZ, 0.02);
    const double far = std::max(eyeDistance - furthestZ, near * 1.001);
    const double a = (far + near) / (far - near), b = -2 * far * near / (far - near);
    // With the distance from the eye d = D - z: clip z = a d + b, clip w = d.
    std::array<float, 16> m{};
    m[0] = static_cast<float>(eyeDistance * shorter / size_.width);
    m[5] = static_cast<float>(-eyeDistance * shorter / size_.height);
    m[10] = static_cast<float>(-a);
    m[11] = -1;
    m[14] = static_cast<float>(a * eyeDistance + b);
    m[15] = static_cast<float>(eyeDistance);
    return m;
}

double linearLight(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

std::vector<Light> lightsOf(const scene::Scene& scene, const Frame& frame) {
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
        // Into the screen, over the viewer's left shoulder: faces that meet differ in brightness.
        lights.push_back(
            {Vector(-0.36, 0.50, 0.80).normalized(), false, Eigen::Vector3f::Constant(0.75F)});
    }
    return lights;
}

} // namespace render
