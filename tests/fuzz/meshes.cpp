// Any bytes are a mesh file or a sentence: what is read has its own corners, and small meshes are
// closed, measured and cut into convex parts.
#include "require.h"

#include "meshes/convex_parts.h"
#include "meshes/mesh_file.h"

#include <cmath>

namespace {

constexpr std::size_t mostTrianglesToCut = 40;
constexpr int mostQuestions = 2000; // of the work whether it should go on

void checkMesh(const meshes::Mesh& mesh) {
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t corner : triangle)
            FUZZ_REQUIRE(corner < mesh.vertices.size());
    for (const meshes::Vector& vertex : mesh.vertices)
        FUZZ_REQUIRE(vertex.allFinite() && vertex.cwiseAbs().maxCoeff() <= meshes::mostCoordinate);
}

void checkParts(const meshes::Mesh& mesh) {
    int asked = 0;
    const meshes::GoOn goOn = [&](double share) {
        FUZZ_REQUIRE(share >= 0 && share <= 1);
        return ++asked < mostQuestions;
    };
    const meshes::Solids solids = meshes::solidsOf(mesh, goOn);
    for (const meshes::Solid& solid : solids.solids) {
        checkMesh(solid.surface);
        FUZZ_REQUIRE(solid.volume > 0);
    }
    const meshes::ConvexParts parts = meshes::convexParts(solids, {0.1, 4, 12}, goOn);
    for (const auto& part : parts.parts)
        for (const meshes::Vector& point : part)
            FUZZ_REQUIRE(point.allFinite());
    FUZZ_REQUIRE(std::isfinite(parts.volume) && std::isfinite(parts.partsVolume));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    for (const char* name : {"mesh.stl", "mesh.obj"}) {
        const meshes::ReadMesh read = meshes::readMesh(bytes, name);
        if (const auto* fault = std::get_if<meshes::FileFault>(&read)) {
            FUZZ_REQUIRE(fault->sentence.starts_with(name));
            continue;
        }
        const auto& mesh = std::get<meshes::Mesh>(read);
        checkMesh(mesh);
        checkMesh(meshes::welded(mesh));
        if (mesh.triangles.size() <= mostTrianglesToCut)
            checkParts(mesh);
    }
    return 0;
}
