// Where does a body touch a support, and how does each gap there change?
//
// For a body at rest the question is another than for a hit: the shapes touch for long, within a
// tolerance that is the integration's and not rounding's, and it counts which features bear.
// For each corner of the patch in which two parts touch: the constraint that keeps its gap
// (physics/resting.h), and how that gap changes (gap_rates.h).
//
// A sphere touches the feature in whose cell its centre lies (collision/nearest_feature.h).
// Where edges or vertices touch, the parts may touch along several axes at once, and stay apart as
// long as they do along one of them (collision/contact.h). Then each is told.
//
// Of what is curved each corner has the pieces of the surfaces that touch there (surface_pieces.h).
// LIMIT: of these, capsules on flat faces and round ends that lie flat have constraints; contacts
// as rows (contact_set.h) have all. LIMIT: vertices and parallel edges on each other, an edge of
// the body on a sphere, and spheres on edges of a support that turns have no constraint.
#pragma once

#include "physics/resting.h"
#include "physics/surface_gap.h"
#include "surfaces/contact_resolution.h"
#include "surfaces/placed.h"

#include <optional>
#include <span>
#include <vector>

namespace simulation {

// Two normals that count as one.
[[nodiscard]] inline bool isOneNormal(const Vector& a, const Vector& b) {
    return (a - b).norm() <= resolution::sameNormal;
}

struct Corner {
    Vector point = Vector::Zero(); // world
    double gap = 0;
    double rate = 0;  // of the gap; negative: they approach
    double extra = 0; // of the gap's acceleration
    physics::GapConstraint constraint;
    std::optional<physics::SurfaceGap> pieces; // of what is curved
};

struct Touch { // of one pair of parts
    std::size_t support = 0, bodyPart = 0, supportPart = 0;
    Vector normal = Vector::UnitX(); // from the support to the body
    double gap = 0;
    double size = 0; // of the two parts
    bool isFlat = false;
    bool isModelled = true;
    struct Roundness {
        bool isBall = false;   // one of the two is a sphere
        bool isOnEdge = false; // ... on an edge or a vertex
        bool isCurved = false; // one of the two is a capsule, cylinder, cone or ellipsoid
        bool isPatch = false;  // ... whose end lies on a face, many corners go round its rim
        double reach = 0; // of such a patch, the mean distance from its middle; 0: of its corners
    };
    Roundness round;
    bool hasPieces = false;            // of what is curved: each corner has its pieces
    std::optional<std::size_t> vertex; // of a part at a hollow part's wall: it touches alone
    std::vector<Corner> corners;
    std::vector<Vector> bodyFace, supportFace; // outlines, world; of polyhedra
    // The same parts along the other axes along which they touch: with these none of their own.
    std::vector<Touch> others;

    // The least rate of its corners; negative: they approach.
    [[nodiscard]] double rate() const;
    // The touch along the one axis along which they stay together while they approach along each
    // other one: this or one of `others`; this where they approach along all. None: they part along
    // one, or go by each other. Of rates, `speed` counts as none.
    [[nodiscard]] const Touch* lasting(double speed) const;
};

struct PartsInTouch {
    std::size_t support = 0, bodyPart = 0, supportPart = 0;
    auto operator<=>(const PartsInTouch&) const = default;
};

// The touch of all pairs of parts whose gap is below `tolerance` of their size, however deep they
// overlap up to ten times that. Of those that rest on each other already, corners count up to four
// times as far: a drift by the integration's error is put back (rest.h), and opens nothing.
[[nodiscard]] std::vector<Touch> touchesOf(const Placed& body, const Placed& support,
                                           double tolerance,
                                           std::span<const PartsInTouch> resting = {});

} // namespace simulation
