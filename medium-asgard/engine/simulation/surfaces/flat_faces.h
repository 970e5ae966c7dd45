// Flat faces of parts: of polyhedra, half spaces, and round ends.
#pragma once

#include "physics/surface_gap.h"
#include "surfaces/placed.h"

#include <optional>
#include <vector>

namespace simulation {

// The flat face of a part that looks along a direction of the world, within tolerances.
struct FlatFace {
    physics::SurfacePiece plane;
    std::vector<Vector> outline; // in the body's frame; of a round end none
    double radius = 0;           // of a round end
    [[nodiscard]] bool isEndless() const { return outline.empty() && !(radius > 0); }
};
[[nodiscard]] std::optional<FlatFace> faceTowards(const Placed& owner, std::size_t part,
                                                  const Vector& direction);

// Of a polyhedron the face whose normal comes next to a direction of the world, however far.
[[nodiscard]] std::optional<FlatFace> faceMostTowards(const Placed& owner, std::size_t part,
                                                      const Vector& direction);

// How far a point of the owner's frame lies inside the face's border; without border: endless.
[[nodiscard]] double depthIn(const FlatFace& face, const Vector& point);

} // namespace simulation
