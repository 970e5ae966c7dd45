#include "motion/contact_slips.h"

#include <algorithm>

namespace simulation {
namespace {

physics::SurfaceMotion surfaceMotionOf(const BodyState& state) {
    physics::SurfaceMotion made;
    made.pose = {state.position, state.attitude.toRotationMatrix()};
    made.velocity = state.velocity;
    made.spin = state.angularVelocity;
    return made;
}

} // namespace

bool holdsAt(const solution::Histories& histories, std::size_t row, double time) {
    const double mode = row < histories.unknowns() ? histories.value(row, time) : 0;
    return mode == solution::heldMode || mode == solution::jammedMode;
}

double slipSpeedAt(const ComputedMotion& motion, const solution::Histories& histories,
                   const ContactLog::Contact& contact, std::size_t body, std::size_t support,
                   double time) {
    const physics::SurfaceMotion of = surfaceMotionOf(motion.at(body, time)),
                                 on = surfaceMotionOf(motion.at(support, time));
    double fastest = 0;
    for (std::size_t k = 0; k < contact.normals.size(); ++k)
        if (holdsAt(histories, contact.normals[k], time))
            fastest = std::max(fastest, physics::slipSpeedOf(*contact.surfaces, k, of, on));
    return fastest;
}

} // namespace simulation
