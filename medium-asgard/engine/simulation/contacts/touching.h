// Where does a body touch a support, and how does each gap there change?
//
// For a body at rest the question is another than for a hit: the shapes touch for long, within a
// tolerance that is the integration's and not rounding's, and it counts which features bear. The
// patch in which two parts touch has corners: of each its gap and how fast that changes.
//
// A sphere touches the feature in whose cell its centre lies (collision/nearest_feature.h).
// Where edges or vertices touch, the parts may touch along several axes at once, and stay apart as
// long as they do along one of them (collision/contact.h). Then each is told.
//
// Of what is curved each corner has the pieces of the surfaces that touch there (surface_pieces.h).
// LIMIT: vertices, or parallel edges, that touch each other have no contact that lasts.
#pragma once

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
    double rate = 0; // of the gap; negative: they approach
    // The features that touch there, of spheres: each in the frame of the body that it belongs to,
    // points from its centre of mass.
    struct Features {
        enum class Kind {
            onSupportPlane, // a point of the body (a sphere's centre) on a plane of the support
            onBodyPlane,    // a point of the support on a plane of the body
            onLine,         // a sphere's centre on an edge of the support
            onPoint         // ... on a point of it (its own sphere's centre, a vertex)
        };
        Kind kind = Kind::onSupportPlane;
        Vector bodyPoint = Vector::Zero(), supportPoint = Vector::Zero();
        Vector normal = Vector::UnitX(); // from the support to the body, of the plane's owner
        Vector edge = Vector::Zero();    // onLine
    };
    Features features;
    std::optional<physics::SurfaceGap> pieces; // of what is curved
};

struct Touch { // of one pair of parts
    std::size_t bodyPart = 0, supportPart = 0;
    Vector normal = Vector::UnitX(); // from the support to the body
    double gap = 0;
    double size = 0; // of the two parts
    bool isFlat = false;
    bool isModelled = true;
    struct Roundness {
        bool isBall = false;   // one of the two is a sphere
        double border = 0;     // so far beyond the border of a face, by rounding, is on the face
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

// The touch of all pairs of parts whose gap is below `tolerance` of their size, however deep they
// overlap up to ten times that.
[[nodiscard]] std::vector<Touch> touchesOf(const Placed& body, const Placed& support,
                                           double tolerance);

} // namespace simulation
