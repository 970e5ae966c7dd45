// How does a body move that rests or slides on others? Its equations with the contacts as
// constraints.
//
// Each contact is a gap g >= 0, a function of the places of the body and of its support. While it
// bears, g = 0 throughout, so that with the body's acceleration a and the rate of its spin w',
//     g'  = 0           the velocities obey it from the start
//     g'' = J_v a + J_w w' + c = 0
// where J are the derivatives of g' by the body's velocities and c is all the rest: turning of the
// normal, the centripetal terms, the support's own motion. J and c come from the gap by
// differentiating it twice along the motion; no kind of contact has a formula of its own for them.
// Forces f along the normals (no friction, so nothing along the surfaces) give
//     a = a_free + J_v' f / m      w' = w'_free + I^-1 J_w' f      (J M^-1 J') f = -(J a_free + c)
// which is solved by elimination of expressions, without pivoting: the matrix is positive definite
// when the constraints are independent, and independentOf() chooses such ones.
//
// A face that lies on a face takes away one translation and two turns; on a support that does not
// turn these are constants of the body, so that nothing drifts.
//
// A held unknown has its own rate: no force changes it, and J is 0 there.
//
// The constraints hold the gap's second derivative only: errors of the integration in gaps stay, as
// in any other quantity, within the tolerance. LIMIT: two bodies that can both give way are not
// constrained to each other.
#pragma once

#include "physics/equations_of_motion.h"
#include "physics/impact.h"

#include <span>
#include <vector>

namespace physics {

// The coordinates of a body that impacts and contacts do not change. A hold makes no hinge
// (docs/scene-language.md): a body that is held at a place beside its centre of mass takes no spin,
// as if its attitude were held.
[[nodiscard]] Held unyieldingAt(const EquationsOfMotion& equations, std::size_t body, double time);

struct GapConstraint {
    enum class Kind {
        onSupportPlane, // a point of the body (a sphere's centre) on a plane of the support
        onBodyPlane,    // a point of the support on a plane of the body
        roundOnLine,    // a sphere's centre at its radius from an edge of the support
        roundOnPoint,   // ... from a point of it (its own sphere's centre, a vertex)
        edgeOnEdge,     // an edge of the body crosses one of the support
        tilt            // inPlane stays in the plane: no turning about bodyEdge, which lies in it
    };
    Kind kind = Kind::onSupportPlane;
    std::size_t support = 0;
    // Each in the frame of the body that it belongs to, points from its centre of mass.
    Vector bodyPoint = Vector::Zero(), supportPoint = Vector::Zero();
    Vector normal = Vector::UnitX(); // from the support to the body, of the plane's owner
    Vector bodyEdge = Vector::Zero(), supportEdge = Vector::Zero();
    Vector inPlane = Vector::Zero(); // tilt: a direction of the body across bodyEdge
    double radius = 0;               // of the gap: the spheres' together
    bool flipped = false;            // edgeOnEdge: the normal is supportEdge x bodyEdge instead
    bool supportTurns = true;        // else its attitude stays what it is:
    Matrix supportRotation = Matrix::Identity();
};

// g' = 0 and g'' = 0 at one state, as numbers: the rows of J along the axes of the body's spin.
struct GapRow {
    Vector linear = Vector::Zero(), angular = Vector::Zero();
    double rate = 0; // g'
};

// Indices of constraints that are independent of the earlier chosen ones, in order. `held`: what
// contacts do not change (unyieldingAt).
[[nodiscard]] std::vector<std::size_t> independentOf(const BodyMotion& body, const Held& held,
                                                     std::span<const GapRow> rows);

// The least change of velocities, in the sense of kinetic energy, that makes all rates 0. Spin
// along the axes of the body's unknowns.
struct VelocityChange {
    Vector linear = Vector::Zero(), angular = Vector::Zero();
};
[[nodiscard]] VelocityChange changeToRates(const BodyMotion& body, const Held& held,
                                           std::span<const GapRow> rows);

struct ConstrainedRates {
    NodeVector acceleration, spinRate; // d/dt of dx dy dz, and of the spin's unknowns
};

// Expressions of gaps along the motion. `set` is the one in force (its graph grows); `free` are
// the equations without contacts that it came from.
class GapExpressions {
public:
    GapExpressions(expression::EquationSet& set, const EquationsOfMotion& free, std::size_t body,
                   double time);

    // J and g' at a state of all unknowns.
    [[nodiscard]] std::vector<GapRow> rowsAt(std::span<const GapConstraint> constraints,
                                             std::span<const double> state);
    [[nodiscard]] ConstrainedRates constrained(std::span<const GapConstraint> independent);

private:
    struct Row {
        NodeVector linear, angular; // J
        Node rate;                  // g'
        Node rest;                  // c
    };
    [[nodiscard]] Row rowOf(const GapConstraint& constraint);
    [[nodiscard]] Row tiltRow(const Vector& axis);
    [[nodiscard]] Node gapOf(const GapConstraint& constraint);
    // d/dt along the motion, without the part of the body's own accelerations.
    [[nodiscard]] Node rateOf(Node value);
    [[nodiscard]] Node freeRate(std::size_t unknown) const;
    [[nodiscard]] NodeVector loadOf(const NodeVector& angular);

    expression::EquationSet& set_;
    Graph& g_;
    const EquationsOfMotion& free_;
    std::size_t body_;
    double time_;
    Held held_;                                                // what contacts do not change
    std::unordered_map<std::uint32_t, std::size_t> unknownOf_; // by symbol
};

} // namespace physics
