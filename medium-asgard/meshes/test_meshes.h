// Solids that are known exactly, as meshes and as files.
#pragma once

#include "meshes/ears.h"
#include "meshes/mesh.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <string>

namespace meshes {

// A polygon of the plane x y, counter-clockwise, from z = 0 to z = height.
inline Mesh prism(const std::vector<Eigen::Vector2d>& outline, double height) {
    Mesh mesh;
    const auto n = static_cast<std::uint32_t>(outline.size());
    std::vector<std::uint32_t> bottom, top;
    for (const auto& p : outline)
        mesh.vertices.emplace_back(p.x(), p.y(), 0);
    for (const auto& p : outline)
        mesh.vertices.emplace_back(p.x(), p.y(), height);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t next = (i + 1) % n;
        mesh.triangles.push_back({i, next, n + next});
        mesh.triangles.push_back({i, n + next, n + i});
        bottom.push_back(n - 1 - i);
        top.push_back(n + i);
    }
    for (const auto& face : {bottom, top})
        for (const auto& t : trianglesOf(mesh.vertices, face))
            mesh.triangles.push_back(t);
    return mesh;
}

inline Mesh boxMesh(const Vector& low, const Vector& high) {
    Mesh mesh =
        prism({{low.x(), low.y()}, {high.x(), low.y()}, {high.x(), high.y()}, {low.x(), high.y()}},
              high.z() - low.z());
    for (Vector& p : mesh.vertices)
        p.z() += low.z();
    return mesh;
}

inline const std::vector<Eigen::Vector2d> ell = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
inline const std::vector<Eigen::Vector2d> cross = {{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                                                   {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};

inline Mesh torus(double ring, double tube, std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    const double turn = 2 * std::numbers::pi;
    for (std::uint32_t i = 0; i < around; ++i)
        for (std::uint32_t k = 0; k < across; ++k) {
            const double a = turn * i / around, b = turn * k / across;
            const double r = ring + tube * std::cos(b);
            mesh.vertices.emplace_back(r * std::cos(a), r * std::sin(a), tube * std::sin(b));
            const std::uint32_t i2 = (i + 1) % around, k2 = (k + 1) % across;
            mesh.triangles.push_back({i * across + k, i2 * across + k, i2 * across + k2});
            mesh.triangles.push_back({i * across + k, i2 * across + k2, i * across + k2});
        }
    return mesh;
}

inline Mesh together(Mesh a, const Mesh& b) {
    const auto first = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const auto& t : b.triangles)
        a.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    return a;
}

inline Mesh insideOut(Mesh mesh) {
    for (auto& t : mesh.triangles)
        std::swap(t[1], t[2]);
    return mesh;
}

inline std::string placeText(const Vector& p) {
    return std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
}

inline std::string stlText(const Mesh& mesh) {
    std::string text = "solid test\n";
    for (const auto& t : mesh.triangles) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const auto v : t)
            text += "   vertex " + placeText(mesh.vertices[v]);
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid test\n";
}

inline std::string stlBinary(const Mesh& mesh) {
    std::string bytes(80, ' ');
    const auto put = [&](std::uint32_t value) {
        for (int k = 0; k < 4; ++k, value >>= 8U)
            bytes += static_cast<char>(value & 0xFFU);
    };
    put(static_cast<std::uint32_t>(mesh.triangles.size()));
    for (const auto& t : mesh.triangles) {
        for (int k = 0; k < 3; ++k)
            put(0);
        for (const auto v : t)
            for (const double x : mesh.vertices[v])
                put(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
        bytes += std::string(2, '\0');
    }
    return bytes;
}

inline std::string objText(const Mesh& mesh) {
    std::string text = "# test\no thing\n";
    for (const Vector& p : mesh.vertices)
        text += "v " + placeText(p);
    for (const auto& t : mesh.triangles) {
        text += "f";
        for (const auto v : t)
            text += " " + std::to_string(v + 1) + "/1/1";
        text += "\n";
    }
    return text;
}

} // namespace meshes
