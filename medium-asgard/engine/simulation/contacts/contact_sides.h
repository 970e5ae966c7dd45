// Where does a point of a contact end, though the bodies still touch?
//
// A vertex over a face stays over it, a crossing between the ends of both edges, a sphere in the
// cell of its face, edge or vertex, a side against a ball between its ends. Beyond, the bodies
// touch otherwise (contact_places.h). Each condition is one of `ContactPoint::Side`; what is beyond
// already by rounding stays.
#pragma once

#include "contacts/touching.h"
#include "physics/contact_rows.h"

#include <limits>
#include <utility>
#include <vector>

namespace simulation {

inline constexpr double sideSlack = 1e-9;  // of the parts' size: so far a contact goes beyond
inline constexpr double samePlace = 1e-9;  // of the same: a corner at a vertex, or on an edge
inline constexpr double uncrossing = 1e-6; // the sine of an angle: edges that do not cross

[[nodiscard]] Vector localOf(const Placed& owner, const Vector& point);
[[nodiscard]] std::vector<Vector> localOf(const Placed& owner, const std::vector<Vector>& points);
[[nodiscard]] physics::SurfacePose poseOf(const Placed& owner);
[[nodiscard]] physics::NearestSurfaces nearestOf(const physics::SurfaceGap& gap, const Placed& body,
                                                 const Placed& support);
using Ends = std::pair<Vector, Vector>;                            // of an edge
[[nodiscard]] physics::SurfacePiece lineBetween(const Ends& ends); // in its body's frame
// The vertex of a part nearest to a place in the part's frame.
[[nodiscard]] std::size_t vertexAt(const geometry::Part& part, const Vector& place);

// Of one point: in the frame of one body.
class Sides {
public:
    // `place` in that frame. `beside`: so far beyond a place may lie where the bodies touch, so
    // that one that is beyond already stays to there, and at least as far again. (If it went on by
    // a slack each time, faces that slide off each other would never have done with it.)
    Sides(std::size_t body, const Vector& place, double size, double beside = 0)
        : body_(body), place_(place), slack_(sideSlack * size), beside_(beside) {}

    // A place that is within the borders of its cell by more than the slack ends this far beyond
    // them, which rounding needs: it comes to a border but once.
    void endAtBorders(double rounding) { border_ = rounding; }
    // A place at a border, but for the slack, may go this far beyond it.
    void letBeyond(double far) { beyond_ = far; }
    // From here on a point that lies `shift` beside the place, along the contact's normal `normal`
    // (in this frame).
    void moveAlong(const Vector& normal, double shift);
    // inward . (p - on) >= 0
    void add(const Vector& inward, const Vector& on);
    // inward . (p - on) + radial |across the axis| + offset >= 0
    void addRound(const Vector& inward, double radial, double offset, const Vector& axis,
                  const Vector& on);
    void addOutline(const std::vector<Vector>& outline, const Vector& normal);
    void addEnds(const Vector& from, const Vector& to);

    std::vector<physics::ContactPoint::Side> sides;

private:
    std::size_t body_;
    Vector place_;
    [[nodiscard]] double roomFor(double inside) const;

    double slack_, beside_;
    double shift_ = 0;
    double border_ = std::numeric_limits<double>::infinity(), beyond_ = 0;
};

// A sphere on a polyhedron.
[[nodiscard]] std::vector<physics::ContactPoint::Side>
sidesOfRound(const Touch& touch, const Placed& body, const Placed& support);

// Pieces of which one belongs to a curved part: over a face, or each in its cell.
[[nodiscard]] std::vector<physics::ContactPoint::Side> sidesOfPieces(const physics::SurfaceGap& gap,
                                                                     const Touch& touch,
                                                                     const Placed& body,
                                                                     const Placed& support);

} // namespace simulation
