#include "render/handles.h"

#include "render/extent.h"

#include <algorithm>
#include <cmath>

namespace render {

scene::Color colorOf(HandleKind kind) {
    return kind == HandleKind::position ? scene::Color{0.95, 0.55, 0.05}
                                        : scene::Color{0.10, 0.60, 0.25};
}

double radiusOf(HandleKind kind) { return kind == HandleKind::position ? 6.5 : 4; }

double velocityTime(const scene::Scene& scene, double sceneSize) {
    double fastest = 0;
    for (const scene::Body& body : scene.bodies)
        if (!body.fixed)
            fastest = std::max(fastest, body.initialVelocity.norm());
    double time = 1;
    while (fastest * time > sceneSize)
        time /= 10;
    return time;
}

std::vector<Handle> handlesOf(const Drawing& drawing, double sceneSize) {
    std::vector<Handle> handles;
    const scene::Scene& scene = *drawing.scene;
    const double time = velocityTime(scene, sceneSize);
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const scene::Body& body = scene.bodies[i];
        if (body.fixed)
            continue;
        const Vector reference = body.initialPosition;
        if (drawing.display.positionHandles)
            handles.push_back({HandleKind::position, i, reference, reference});
        if (drawing.display.velocityHandles) {
            const bool known = drawing.motion != nullptr && i < drawing.motion->bodies();
            const Vector center =
                known ? reference + body.initialAttitude * drawing.motion->centroid(i) : reference;
            handles.push_back(
                {HandleKind::velocity, i, center, center + time * body.initialVelocity});
        }
    }
    return handles;
}

} // namespace render
