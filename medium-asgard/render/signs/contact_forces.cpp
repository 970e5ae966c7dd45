#include "signs/contact_forces.h"

#include "drawing/overlay.h"
#include "drawing/round_numbers.h"

#include <cmath>

namespace render {

double contactForceScale(const simulation::Motion& motion) {
    double weight = 0, moving = 0;
    for (std::size_t i = 0; i < motion.bodies(); ++i)
        if (std::isfinite(motion.mass(i))) {
            weight += 9.81 * motion.mass(i);
            ++moving;
        }
    return roundBelow(weight > 0 ? 0.65 * std::sqrt(moving) / weight : 0.65);
}

void addContactForces(Lines& lines, const std::vector<simulation::ContactForce>& forces,
                      double scale, const Frame& frame, const Display& display) {
    const Ink ink{{0.78F, 0.20F, 0.30F}, 0.95F, frame.stroke(2.2)};
    const double perForce = scale / frame.camera().scale;
    for (const simulation::ContactForce& one : forces) {
        if (display.contactForces)
            addArrow(lines, frame, one.point, one.point + perForce * one.force, ink);
        if (!display.frictionCones || !(one.friction > 0))
            continue;
        constexpr int sides = 40;
        const double height = perForce * one.force.dot(one.normal);
        const Vector axis = one.normal, u = axis.unitOrthogonal(), v = axis.cross(u);
        const double radius = height * one.friction;
        Ink faint{{0.85F, 0.55F, 0.15F}, 0.55F, frame.stroke(1.1)};
        Vector last = one.point + height * axis + radius * u;
        for (int i = 1; i <= sides; ++i) {
            const double angle = 2 * M_PI * i / sides;
            const Vector next =
                one.point + height * axis + radius * (std::cos(angle) * u + std::sin(angle) * v);
            lines.add(frame.toView(last), frame.toView(next), faint);
            if (i % 5 == 0)
                lines.add(frame.toView(one.point), frame.toView(next), faint);
            last = next;
        }
    }
}

} // namespace render
