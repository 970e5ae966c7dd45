// Which contacts and joints leave the bodies between them no room?
//
// Contacts may only part, with rates  u + J dv >= 0,  and joints keep theirs,  K dv = 0.  If no
// change dv of the velocities does all that, the one that breaks it least, in the measure of the
// kinetic energy, leaves breaches r. These are impulses in balance,  J' r + K' s = 0  on every body
// that gives way, and  r u < 0: a proof (Farkas) that no impulses part what they lead through,
// however large. Those are the contacts between a press and the floor.
//
// Solved by its dual, with a stiffness for the breaches that is 1e-9 of the bodies':
//     min f (A + d) f / 2 + u f,   f >= 0 of contacts and closed stops,   r = d f.
//
// Sides that grip may push along all directions of their cones of friction. Between these a wedge
// that is blunter than the friction is in balance, and has no room either. The breaches count along
// the normals alone.
//
// LIMIT: a cone has eight edges; what needs more than 0.92 of the friction between two of them has
// room.
#pragma once

#include "physics/impact.h"

#include <cstddef>
#include <span>
#include <vector>

namespace physics {

struct Crushing {
    std::vector<std::size_t> contacts, joints; // that have a part in it; none: there is room
    // Bodies of these contacts: those on which the contacts alone are in balance, and those that
    // something else holds against them.
    std::vector<std::size_t> pressed, between;
};
enum class Sides { slip, grip };
[[nodiscard]] Crushing crushingOf(std::span<const ImpactBody> bodies,
                                  std::span<const ImpactContact> contacts,
                                  std::span<const ImpactRow> joints, Sides sides = Sides::slip);

} // namespace physics
