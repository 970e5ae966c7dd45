// A trajectory as expressions of time.
//
// Bezier curves of degree n over [t0, t1], in u = (t - t0)/(t1 - t0): up to degree 8 as the power
// basis in u by Horner's rule, above by de Casteljau's, whose error does not grow with n. Outside
// its curves a trajectory goes on in a straight line: before the first from its start, later from
// the end of the curve that ended last.
#pragma once

#include "physics/node_vector.h"
#include "scene/scene.h"

#include <vector>

namespace physics {

struct TrajectoryPiece {
    double from = 0;  // in force from here to the next piece; the first from the start of time
    NodeVector value; // smooth in t
    NodeVector rate;  // its derivative
};

[[nodiscard]] std::vector<TrajectoryPiece> piecesOf(Graph& g, Node time,
                                                    const scene::Trajectory& trajectory);

// The piece in force at a time.
[[nodiscard]] const TrajectoryPiece& pieceAt(const std::vector<TrajectoryPiece>& pieces, double t);

// One expression for all times: a balanced tree of choices by time.
[[nodiscard]] NodeVector valueOf(Graph& g, Node time, const std::vector<TrajectoryPiece>& pieces);

[[nodiscard]] NodeVector differentiated(Graph& g, const NodeVector& v, Node symbol);

} // namespace physics
