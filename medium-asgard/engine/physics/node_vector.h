// Vectors and rotations whose entries are expressions.
#pragma once

#include "expression/graph.h"
#include "geometry/pose.h"

#include <array>
#include <cstddef>

namespace physics {

using expression::Graph;
using expression::Node;
using expression::Op;
using geometry::Matrix;
using geometry::Quaternion;
using geometry::Vector;

using NodeVector = std::array<Node, 3>;
using NodeQuaternion = std::array<Node, 4>;   // w x y z
using NodeMatrix = std::array<NodeVector, 3>; // rows

[[nodiscard]] NodeVector constant(Graph& g, const Vector& v);
// A number that differs from one owner to the next, as sizes and places of contacts do: 0 and 1
// shape expressions, all else is a parameter (expression/graph.h), so that contacts of the same
// kind have equations of the same form. Vectors share their numbers where they are equal as a
// whole: two corners of a box have other coordinates in common than two others.
[[nodiscard]] Node numberOf(Graph& g, double value, Node owner, std::uint32_t place = 0);
[[nodiscard]] NodeVector numbersOf(Graph& g, const Vector& v, Node owner);
[[nodiscard]] NodeVector add(Graph& g, const NodeVector& a, const NodeVector& b);
[[nodiscard]] NodeVector subtract(Graph& g, const NodeVector& a, const NodeVector& b);
[[nodiscard]] NodeVector scaled(Graph& g, Node factor, const NodeVector& v);
[[nodiscard]] NodeVector cross(Graph& g, const NodeVector& a, const NodeVector& b);
[[nodiscard]] Node dot(Graph& g, const NodeVector& a, const NodeVector& b);
[[nodiscard]] NodeVector times(Graph& g, const NodeMatrix& m, const NodeVector& v);
[[nodiscard]] NodeVector transposedTimes(Graph& g, const NodeMatrix& m, const NodeVector& v);
[[nodiscard]] bool isZero(const Graph& g, const NodeVector& v);

// The rotation that a quaternion means, divided by |q|²: exact for every q but 0, so that an
// integrator's drift of |q| between renormalisations turns into no stretch of the body.
[[nodiscard]] NodeMatrix rotationMatrix(Graph& g, const NodeQuaternion& q);

// dq/dt of an attitude that turns with angular velocity w, given along the world's axes
// (w q / 2) or along the body's (q w / 2).
[[nodiscard]] NodeQuaternion attitudeRate(Graph& g, const NodeQuaternion& q, const NodeVector& w,
                                          bool isInWorldAxes);

// The attitude that a rotation vector means: (cos a/2, sin(a/2) v/a) for a = |v|.
[[nodiscard]] NodeQuaternion attitudeOf(Graph& g, const NodeVector& v);

// The angular velocity of a body whose rotation vector is v and changes at the rate u: with a = |v|
//     w = sin a / a  u  ±  (1 - cos a)/a²  v x u  +  (a - sin a)/a³ (v.u) v
// with + along the world's axes and - along the body's. Near a = 0 the coefficients are series.
[[nodiscard]] NodeVector spinOf(Graph& g, const NodeVector& v, const NodeVector& u,
                                bool inWorldAxes);

} // namespace physics
