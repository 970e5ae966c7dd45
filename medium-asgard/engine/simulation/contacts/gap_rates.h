// How does the gap at a corner of a touch change?
//
// Its rate, and the part of its acceleration that does not come from the body's own accelerations,
//     plane with point:   n.(w x (w x r) - a_s) + 2 n'.(v_b - v_s) - R |n'|^2
//     round on a point    n.(w x (w x r) - a_s) + |u|^2 / R       u: the speed across the normal
// with n' from the turning of the plane's owner, r from the body's centre of mass to the point.
#pragma once

#include "contacts/touching.h"

namespace simulation {

// Fills in what the corner's constraint tells of gap, rate and acceleration; points of the world.
void measureGap(Corner& corner, const Touch& touch, const Vector& bodyPoint,
                const Vector& supportPoint, const Placed& body, const Placed& support);

} // namespace simulation
