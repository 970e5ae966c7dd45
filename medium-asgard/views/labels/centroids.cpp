#include "labels/centroids.h"

#include "physics/mass.h"

namespace views {

geometry::Vector Centroids::of(const Shown& shown, std::size_t body) {
    if (shown.motion && body < shown.motion->bodies())
        return shown.motion->centroid(body);
    if (scene_ != shown.scene) {
        scene_ = shown.scene;
        known_.assign(scene_->bodies.size(), std::nullopt);
    }
    if (!known_[body]) {
        scene::ShapeReader shapes;
        const auto mass = physics::MassReader(*scene_, shapes).massOf(scene_->bodies[body]);
        const auto* found = std::get_if<physics::BodyMass>(&mass);
        known_[body] = found ? found->centroid : geometry::Vector::Zero();
    }
    return *known_[body];
}

} // namespace views
