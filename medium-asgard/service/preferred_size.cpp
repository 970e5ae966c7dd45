#include "service/preferred_size.h"

#include "framing/view.h"

#include <algorithm>
#include <cmath>

namespace service {
namespace {

constexpr double widestPicture = 480, narrowestPicture = 120;
constexpr double usualAspect = 4.0 / 3, flattest = 2.2, steepest = 0.9; // width over height

// Distance of the farthest point of a shape from its origin.
double reach(const scene::ShapeSet& shape) {
    double farthest = 0;
    for (const scene::Part& part : shape.parts) {
        farthest = std::max(farthest, part.position.norm() + scene::reachOf(part));
    }
    return farthest;
}

// Width over height of what moves, as the scene's first view shows it over the whole motion.
double aspect(const scene::Scene& scene, const simulation::MotionPointer& motion) {
    const render::Size square{1000, 1000};
    const double start = motion ? motion->start() : 0, end = motion ? motion->computed() : 0;
    const render::SceneView view(scene, motion, "", square);
    Eigen::AlignedBox2d box;
    constexpr int samples = 40;
    for (int i = 0; i <= (motion ? samples : 0); ++i) {
        const double time = start + (end - start) * i / samples;
        const render::Camera camera = view.at(time);
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            const scene::ShapeSet* shape = scene::findShapeSet(scene, scene.bodies[b].shape);
            if (!shape || scene.bodies[b].fixed)
                continue;
            const geometry::Vector place =
                motion ? motion->shapePose(b, time).position : scene.bodies[b].initialPosition;
            const Eigen::Vector2d pixels = render::toPixels(camera, square, place);
            const double radius = reach(*shape) * camera.scale * square.width / 2;
            box.extend(pixels - Eigen::Vector2d::Constant(radius));
            box.extend(pixels + Eigen::Vector2d::Constant(radius));
        }
    }
    if (box.isEmpty())
        return usualAspect;
    const double ratio = box.sizes().x() / box.sizes().y();
    return std::isfinite(ratio) && ratio > 0 ? ratio : usualAspect;
}

} // namespace

ipc::PreferredSize preferredSize(const scene::Scene* scene, const simulation::MotionPointer& motion,
                                 double availableWidth, std::optional<double> availableHeight) {
    // Between the usual shape of a picture and that of what it shows.
    const double shape = scene ? std::sqrt(aspect(*scene, motion) * usualAspect) : usualAspect;
    const double ratio = std::clamp(shape, steepest, flattest);
    double width = std::clamp(availableWidth, narrowestPicture, widestPicture);
    double height = width / ratio;
    if (availableHeight && height > *availableHeight) {
        height = std::max(*availableHeight, narrowestPicture / ratio);
        width = height * ratio;
    }
    return {std::round(width), std::round(height)};
}

} // namespace service
