#include "gestures/grasp.h"

#include <algorithm>
#include <variant>

namespace gestures {

namespace {

using Button = render::CameraControl::Button;
using render::Handle;
using render::HandleKind;

Grasp bodyHeld(const render::Drawing& drawing, const Sight& sight, const Picked& picked,
               Button button) {
    const scene::Body& body = drawing.scene->bodies[picked.body];
    if (button == Button::left)
        return {Grasp::What::drag,
                {HandleKind::position, picked.body, 0, body.initialPosition, body.initialPosition}};
    const geometry::Pose pose =
        render::poseOf(*drawing.scene, drawing.motion.get(), picked.body, drawing.time);
    const Handle turned{HandleKind::orientation,
                        picked.body,
                        0,
                        pose.position,
                        picked.point,
                        (picked.point - pose.position).norm(),
                        pose};
    if (button == Button::middle)
        return {Grasp::What::drag, turned};
    constexpr double pixels = 40; // of the arm that is rolled
    const double reach = pixels * sight.pixelLength(pose.position);
    const Vector right = sight.camera.rotation.conjugate() * Vector::UnitX();
    return {Grasp::What::roll,
            {HandleKind::orientation, picked.body, 0, pose.position, pose.position + reach * right,
             reach, pose}};
}

} // namespace

bool isGrasped(const scene::Scene& scene, std::size_t body) {
    const scene::Body& one = scene.bodies[body];
    const scene::ShapeSet* set = scene::findShapeSet(scene, one.shape);
    const bool isEndless = set && std::ranges::any_of(set->parts, [](const scene::Part& part) {
                               return std::holds_alternative<scene::PlaneShape>(part.shape);
                           });
    return !one.fixed || !isEndless;
}

std::optional<Grasp> graspAt(const render::Drawing& drawing, const render::HandleSet& handles,
                             const Sight& sight, Button button, const Eigen::Vector2d& pixels,
                             double reach) {
    if (const auto index = handleAt(handles, sight, pixels, reach)) {
        const Handle& handle = handles.handles[*index];
        if (button == Button::left)
            return Grasp{Grasp::What::drag, handle};
        if (handle.kind == HandleKind::trajectoryPoint)
            return Grasp{button == Button::middle ? Grasp::What::newPoint
                                                  : Grasp::What::removePoint,
                         handle};
    }
    const auto picked = bodyAt(drawing, sight, pixels);
    if (!picked || !isGrasped(*drawing.scene, picked->body))
        return std::nullopt;
    return bodyHeld(drawing, sight, *picked, button);
}

} // namespace gestures
