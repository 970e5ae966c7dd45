#include "render/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace render {
namespace {

using geometry::Vector;

Vector vertex(const Mesh& mesh, std::size_t index) {
    const float* p = &mesh.vertices[6 * mesh.indices[index]];
    return {p[0], p[1], p[2]};
}

double volume(const Mesh& mesh) {
    double sum = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        sum += vertex(mesh, i).dot(vertex(mesh, i + 1).cross(vertex(mesh, i + 2))) / 6;
    return sum;
}

TEST(SphereMesh, ApproachesTheBallFromBothSides) {
    double last = 1;
    for (int level = 1; level <= finestSphere; ++level) {
        const Mesh mesh = sphereMesh(level);
        EXPECT_EQ(mesh.indices.size(), 3U * 20U * (1U << (2 * level)));
        const double error = std::abs(volume(mesh) / (4 * M_PI / 3) - 1);
        EXPECT_LT(error, 0.4 * last) << level;
        last = error;
    }
    EXPECT_LT(last, 1e-3);
}

TEST(SphereMesh, IsFinerWhereItIsLargerOnScreen) {
    EXPECT_EQ(sphereLevel(2), 1);
    EXPECT_LE(sphereLevel(10), 2);
    EXPECT_EQ(sphereLevel(1e6), finestSphere);
    for (double radius = 1; radius < 2000; radius *= 1.3)
        EXPECT_LE(sphereLevel(radius), sphereLevel(radius * 1.3));
}

TEST(PolyhedronMesh, OfABoxHasItsVolumeTwelveEdgesAndFlatFaces) {
    const Mesh mesh = polyhedronMesh(geometry::box(Vector(1, 2, 3)));
    EXPECT_NEAR(volume(mesh), 6, 1e-6);
    EXPECT_EQ(mesh.edges.size(), 12U);
    EXPECT_EQ(mesh.indices.size(), 3U * 12U);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const Vector normal = (vertex(mesh, i + 1) - vertex(mesh, i))
                                  .cross(vertex(mesh, i + 2) - vertex(mesh, i))
                                  .normalized();
        const float* n = &mesh.vertices[6 * mesh.indices[i] + 3];
        EXPECT_NEAR(normal.dot(Vector(n[0], n[1], n[2])), 1, 1e-6);
    }
}

TEST(HullMesh, OfPointsWithoutAHullIsEmpty) {
    EXPECT_TRUE(hullMesh({Vector(0, 0, 0), Vector(1, 0, 0)}).indices.empty());
    const Mesh tetrahedron =
        hullMesh({Vector(0, 0, 0), Vector(1, 0, 0), Vector(0, 1, 0), Vector(0, 0, 1)});
    EXPECT_NEAR(volume(tetrahedron), 1.0 / 6, 1e-6);
    EXPECT_EQ(tetrahedron.edges.size(), 6U);
}

} // namespace
} // namespace render
