// The impact of bodies at the instant at which they touch and approach.
//
// Instantaneous: impulses j >= 0 along the contact normals. For contact i with normal
// n (from the second body to the first) at lever arms r1, r2 from the centres of mass,
//     u_i  = n . (v1 + w1 x r1 - v2 - w2 x r2)            approach when negative
//     u'   = u + A j,   A_ij = n_i . (velocity that unit impulse j gives at contact i)
// and Newton's law of impact wants u'_i = -e_i u_i. Contacts that approach at one instant are
// solved together: j >= 0, u' + e u >= 0, and one of both 0 in each contact (complementarity). Of
// several solutions (redundant contacts) the velocities are the same; the impulses are the
// shortest. Contacts that touch at relative rest take part one after another: after each solution,
// those that now approach make the next one (Newton's cradle), until none approaches. A blow runs
// to and fro in a wall or a tower, each time a little weaker: a contact bounces until the
// powers of its restitution are below a thousandth, fifty times at most, and not at all then. A
// contact that approaches a billion times slower than the fastest does so by rounding, and is at
// relative rest; for balls side by side (simulation/side_by_side.h), a hundred times. Bodies that a
// force presses together move as one: their contacts are solved together from the start.
//
// Friction is Coulomb's law for impulses, with the coefficient of sliding: along the surfaces each
// contact takes an impulse of at most mu j that leaves no sliding velocity, or of mu j against the
// one that is left. The contacts of a patch have one such impulse at the centre of theirs, and one
// that stops turning about their normal, by the law of contacts that last
// (physics/contact_rows.h): with one for each corner a box would have more of them than freedoms.
// Together with Newton's law that may add kinetic energy; then the restitutions of that solution
// are lowered by one common factor until it does not.
//
// Joints keep their conditions J v through a blow: an impulse of a contact is one of all that hangs
// together, A = J_n W (1 - J' (J W J')^-1 J W) J_n' with W the inverse masses.
//
// Stops and ropes that are closed take part as contacts without restitution do.
//
// Bodies of infinite mass or infinite inertia (attitude held) have inverse 0; a body that is held
// along some axes of the world moves along the others only, and turns. Two bodies that cannot give
// way pass through each other; that is reported.
#pragma once

#include "geometry/pose.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace physics {

using geometry::Matrix;
using geometry::Vector;

struct ImpactBody {
    double inverseMass = 0;                 // 0: infinite
    Vector moves = Vector::Ones();          // along each axis of the world; 0: held there
    Matrix inverseInertia = Matrix::Zero(); // world axes, about the centre of mass; 0: infinite
    Vector centre = Vector::Zero();         // of mass
    Vector velocity = Vector::Zero();
    Vector angularVelocity = Vector::Zero(); // world axes
};

struct ImpactContact {
    std::size_t first = 0, second = 0; // bodies
    Vector point = Vector::Zero();
    Vector normal = Vector::UnitX(); // from second to first
    double restitution = 1;          // the smaller of the two bodies'
    bool isBeside = false;           // they go side by side: at relative rest before the blow
    // Touches at relative rest: it takes part when a blow has reached it, not with the first,
    // though rounding or an integration may leave it a speed.
    bool isResting = false;
    bool isPressed = false; // they move as one
    double friction = 0;
    std::optional<std::size_t> patch = {}; // those next to it with the same are one; none: alone
    Vector surface = Vector::Zero(); // of both, first less second, along themselves: a conveyor
};

// A condition of a joint: the sum of linear . v + angular . w of its parts stays what it is.
struct ImpactRow {
    struct Part {
        std::size_t body = 0;
        Vector linear = Vector::Zero(), angular = Vector::Zero(); // world axes
    };
    std::vector<Part> parts;
    bool isStop = false; // closed: the sum may grow, and an impulse only makes it grow
    std::optional<std::size_t> multiplier = {}; // of the equations, whose name is the joint's
};

struct ImpulseGiven {
    std::size_t contact = 0;
    double impulse = 0; // > 0
};

struct ImpactResult {
    std::vector<ImpactBody> bodies;     // with their new velocities
    std::vector<ImpulseGiven> impulses; // in order; a contact may appear several times
    std::vector<std::size_t>
        unyielding; // contacts that approach, between bodies that cannot give way
    // The bound on rounds was reached: a body that fits exactly between two others bounces between
    // them without end at one instant, and the rest of it was taken up without bounce.
    bool jammed = false;
    bool loweredRestitution = false; // so that no energy is gained
    bool settled = true;             // false: still approaching after that (a bug)
};

// The same for one contact whose normal goes through both centres of mass, so that nothing turns.
[[nodiscard]] inline double centralImpulse(double speed, double restitution, double inverseMasses) {
    return -(1 + restitution) * speed / inverseMasses;
}

[[nodiscard]] ImpactResult resolveImpact(std::vector<ImpactBody> bodies,
                                         std::span<const ImpactContact> contacts,
                                         std::span<const ImpactRow> joints = {});

} // namespace physics
