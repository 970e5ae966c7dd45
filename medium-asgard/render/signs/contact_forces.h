// The forces of contacts now, read from a motion, for their arrows and friction cones.
//
// Of each pair of bodies that touch: what one does to the other, at the centre of pressure.
// Where the scene names no contact of a pair, the motion is computed again with names for all.
// LIMIT: of a scene of more bodies those of the first 60, which may be a crowd already; where the
// motion takes longer than two seconds, those of its beginning. The picture's thread computes it,
// anew for each motion, and nobody can cancel that.
#pragma once

#include "drawing/drawing.h"
#include "drawing/frame.h"
#include "drawing/lines.h"
#include "geometry/shape.h"
#include "simulation/simulation.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace render {

struct ContactForce {
    std::size_t first = 0, second = 0; // bodies
    Vector point = Vector::Zero();     // world
    Vector force = Vector::Zero();     // on the first body, world
    Vector normal = Vector::Zero();    // of length 1, towards the first body
    double friction = 0;               // coefficient while it sticks
};

class ContactForces {
public:
    [[nodiscard]] std::vector<ContactForce>
    at(const scene::Scene& scene, const simulation::MotionPointer& motion, double time);
    // View units for a force of 1: round; the weight of a few of the bodies is a good arrow.
    [[nodiscard]] double scale() const { return scale_; }

private:
    using Pair = std::pair<std::size_t, std::size_t>;
    void follow(const scene::Scene& scene, const simulation::MotionPointer& motion);

    std::weak_ptr<const simulation::Motion> of_;
    simulation::MotionPointer read_;                     // the same, with names for all contacts
    std::vector<std::optional<geometry::Shape>> shapes_; // of the bodies
    std::vector<Pair> pairs_;
    std::optional<simulation::Quantities> quantities_; // of each pair: n, force, place
    double scale_ = 1;
};

// An arrow for each force, on the body that moves, or on the first, and a cone about its normal
// that the force cannot leave while the contact sticks.
void addContactForces(Lines& lines, const std::vector<ContactForce>& forces,
                      const scene::Scene& scene, double scale, const Frame& frame,
                      const Display& display);

} // namespace render
