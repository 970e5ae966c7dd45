// The triangles of an STL file (text or binary) or an OBJ file.
//
// Files come from anywhere and are not trusted: whatever the bytes are, the answer is a mesh whose
// indices are its own, or one short sentence that says what is wrong and where, the line of a text
// or the byte of a binary file; that reading was ended is such a sentence too. Nothing is allocated
// for what a file only announces.
//
// OBJ: `v` and `f`; polygons become triangles (concave ones by cutting off ears). Normals, texture
// coordinates, groups and materials are passed over.
// LIMIT: OBJ's free-form curves and surfaces are refused.
//
// References: 3D Systems, StereoLithography Interface Specification (1989); Wavefront, Advanced
// Visualizer manual, appendix B1. Why no library: docs/decisions, "Meshes".
#pragma once

#include "meshes/mesh.h"

#include <string>
#include <string_view>
#include <variant>

namespace meshes {

inline constexpr std::size_t mostBytes = 200'000'000;
inline constexpr std::size_t mostTriangles = 500'000;
inline constexpr double mostCoordinate = 1e12;

struct FileFault {
    std::string sentence; // "wing.stl, line 7: ..."
};

using ReadMesh = std::variant<Mesh, FileFault>;

// By the ending of the name: .obj, else STL of the kind that the bytes show. Not welded.
[[nodiscard]] ReadMesh readMesh(std::string_view bytes, const std::string& name,
                                const GoOn& goOn = {});

[[nodiscard]] ReadMesh readStl(std::string_view bytes, const std::string& name, const GoOn& goOn);
[[nodiscard]] ReadMesh readObj(std::string_view bytes, const std::string& name, const GoOn& goOn);
// The sentence of all of them when they are cancelled.
[[nodiscard]] FileFault wasEnded(const std::string& name);

} // namespace meshes
