// At which points do two bodies touch that neither part nor approach there?
//
// The answer is geometry alone (physics/contact_rows.h makes equations of it). Each corner of a
// patch belongs to a vertex of one of the two, which stays that material point, or to the crossing
// of an edge of the one with an edge of the other, which goes along both. What is curved touches
// with pieces of its surface (surface_pieces.h), and where these touch goes along them. Each has
// the sides within which it does (contact_sides.h). Beyond, the bodies touch otherwise.
//
// LIMIT: parts that touch along several axes at once (a vertex on a vertex, edges side by side)
// have no contact that lasts.
#pragma once

#include "contacts/touch_limits.h"
#include "contacts/touching.h"
#include "physics/contact_rows.h"

#include <optional>
#include <vector>

namespace simulation {

struct LastingContact {
    std::size_t bodyPart = 0, supportPart = 0;
    bool isModelled = true;
    bool rolls = false;          // a surface is curved where they touch
    bool isInPlane = false;      // its points are those of a motion in a plane
    Stand stand = {};            // without parts
    physics::ContactPlace place; // without friction
};

[[nodiscard]] std::vector<LastingContact> lastingContacts(const Placed& body, const Placed& support,
                                                          const TouchLimits& limits);

// The points in which two parts touch now, at whatever speed: as rows would have them.
struct PointInTouch {
    std::size_t bodyPart = 0, supportPart = 0;
    std::size_t patch = 0;                                   // those of one have the same friction
    Vector point = Vector::Zero(), normal = Vector::UnitX(); // from the support to the body
    std::optional<physics::SurfaceGap> gap = {};             // of the support and the body
};
[[nodiscard]] std::vector<PointInTouch> pointsInTouch(const Placed& body, const Placed& support,
                                                      double gap,
                                                      const std::optional<MotionPlane>& plane);

} // namespace simulation
