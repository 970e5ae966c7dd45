#include "drawing/mesh.h"

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

// Outward triangles, normals of unit length that are those of the true surface, and a volume that
// approaches the true one.
TEST(RoundMeshes, ApproachTheTrueSurfaces) {
    const double r = 0.7, h = 1.9;
    const auto check = [](const Mesh& mesh, double expected, double within) {
        EXPECT_NEAR(volume(mesh) / expected, 1, within);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vector across = (vertex(mesh, i + 1) - vertex(mesh, i))
                                      .cross(vertex(mesh, i + 2) - vertex(mesh, i));
            for (std::size_t k = i; k < i + 3; ++k) {
                const float* n = &mesh.vertices[6 * mesh.indices[k] + 3];
                const Vector normal(n[0], n[1], n[2]);
                EXPECT_NEAR(normal.norm(), 1, 1e-6);
                EXPECT_GE(across.dot(normal), 0.9 * across.norm() - 1e-7);
            }
        }
    };
    for (const int sides : {24, 96, 384}) {
        const double within = 8.0 / (sides * sides);
        check(cylinderMesh(r, h, sides), M_PI * r * r * h, within);
        check(coneMesh(r, h, sides), M_PI * r * r * h / 3, within);
        check(capsuleMesh(r, h, sides), M_PI * r * r * (h + 4 * r / 3), 2 * within);
    }
    check(ellipsoidMesh({1, 1.5, 0.8}, 4), 4 * M_PI / 3 * 1.2, 2e-3);
    EXPECT_EQ(cylinderMesh(r, h, 24).edges.size(), 48U);
    EXPECT_EQ(coneMesh(r, h, 24).edges.size(), 24U);
    EXPECT_TRUE(capsuleMesh(r, h, 24).edges.empty());
    EXPECT_EQ(ringSides(1), 12);
    EXPECT_EQ(ringSides(1e9), finestRing);
    for (const double pixels : {10.0, 100.0, 1000.0})
        EXPECT_LE(pixels * (1 - std::cos(M_PI / ringSides(pixels))), 1.0 / 3);
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
