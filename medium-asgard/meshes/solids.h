// Which solids does a surface bound?
//
// A surface falls into pieces that share no edge. A piece is closed when every edge is passed as
// often in one direction as in the other; then it bounds a volume (divergence theorem), exactly
// and without a search for what is inside. Pieces whose triangles disagree about the outside are
// turned to agree where each edge has two triangles. Pieces inside out are turned; one that lies in
// another and faces inwards is a cavity of it.
#pragma once

#include "meshes/mesh.h"

namespace meshes {

struct Solid {
    Mesh surface;      // closed, counter-clockwise seen from outside
    double volume = 0; // above 0
};

struct Solids {
    std::vector<Solid> solids;
    std::vector<Mesh> open; // pieces that bound no volume
    std::size_t openEdges = 0;
    std::size_t pieces = 0; // above mostPieces the rest is left empty
    bool cancelled = false; // the same
};

inline constexpr std::size_t mostPieces = 1000;

// Corners at the same place are one; where that leaves gaps, those within a millionth of the size.
[[nodiscard]] Solids solidsOf(const Mesh& mesh, const GoOn& goOn = {});

// How often a closed surface goes around a place: 1 inside, 0 outside (Jacobson and others 2013).
[[nodiscard]] double windingNumber(const Mesh& surface, const Vector& place);
[[nodiscard]] double volumeOf(const Mesh& surface);

} // namespace meshes
