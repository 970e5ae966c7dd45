#include "render/ground.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

// The largest of 1, 2, 5 times a power of ten that is not above x.
double roundLength(double x) {
    const double power = std::pow(10, std::floor(std::log10(x)));
    for (double factor : {5.0, 2.0})
        if (factor * power <= x)
            return factor * power;
    return power;
}

// Area of the mesh's level upward faces that stand highest, and their height.
struct Top {
    double area = 0;
    double height = 0;
};

Top topOf(const Solid& solid, const Mesh& mesh, const Vector& up) {
    Top top;
    const auto corner = [&](std::size_t index) {
        const float* p = &mesh.vertices[6 * mesh.indices[index]];
        return solid.toView(Vector(p[0], p[1], p[2]));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const Vector a = corner(i);
        const Vector twice = (corner(i + 1) - a).cross(corner(i + 2) - a);
        if (twice.dot(up) < 0.9999 * twice.norm())
            continue;
        const double height = a.dot(up);
        if (top.area == 0 || height > top.height + 1e-6 * solid.radius)
            top = {0, height};
        top.area += twice.norm() / 2;
    }
    return top;
}

} // namespace

Plane groundOf(const Extent& extent, const Frame& frame) {
    const Vector up = frame.directionInView(extent.ground);
    const double rise = extent.lowest - extent.box.center().dot(extent.ground);
    return {up, frame.toView(extent.box.center()).dot(up) + frame.camera().scale * rise};
}

std::optional<Floor> floorOf(std::span<const Solid> solids, const Extent& extent,
                             const Frame& frame, Solids& meshes) {
    const Vector up = frame.directionInView(extent.ground);
    const double enough = std::pow(0.3 * extent.size * frame.camera().scale, 2);
    std::optional<Floor> floor;
    double largest = enough;
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const Solid& solid = solids[i];
        if (extent.moves[solid.body] ||
            std::holds_alternative<scene::SphereShape>(solid.part->shape))
            continue;
        const Top top = topOf(solid, meshes.meshOf(solid, frame), up);
        if (top.area > largest) {
            largest = top.area;
            floor = Floor{i, {up, top.height}};
        }
    }
    return floor;
}

void addGrid(Lines& lines, const Extent& extent, const Frame& frame, double strength) {
    const Vector up = extent.ground;
    const Vector u = std::abs(up.x()) > 0.5 ? Vector(Vector::UnitY()) : Vector(Vector::UnitX());
    const Vector v = up.cross(u);
    const double cell = roundLength(extent.size / 5);
    const Vector below = extent.box.center() + (extent.lowest - extent.box.center().dot(up)) * up;
    // Lines stand at whole multiples of the cell, so that lengths can be read off.
    const double footU = std::round(below.dot(u) / cell), footV = std::round(below.dot(v) / cell);
    const double across =
        std::max(extent.box.sizes().dot(u.cwiseAbs()), extent.box.sizes().dot(v.cwiseAbs()));
    const int reach = std::clamp(static_cast<int>(std::ceil(0.85 * across / cell)) + 3, 4, 14);
    const auto place = [&](double i, double j) {
        return frame.toView(below.dot(up) * up + (footU + i) * cell * u + (footV + j) * cell * v);
    };
    // Seen at a slant the lines crowd: they fade, and are gone when the ground is seen edge-on.
    const Plane ground = groundOf(extent, frame);
    const double rise = std::abs(eyeDistance * ground.normal.z() - ground.offset) / eyeDistance;
    const double slant = std::clamp((rise - 0.02) / 0.12, 0.0, 1.0);
    if (slant == 0)
        return;
    const auto alpha = [&](double i, double j) {
        const double d = std::hypot(i, j) / reach;
        return static_cast<float>(0.5 * strength * slant * std::max(0.0, 1 - d * d));
    };
    for (int line = -reach; line <= reach; ++line)
        for (int along = -reach; along < reach; ++along) {
            const bool tenth = std::llround(footU + line) % 5 == 0;
            const bool otherTenth = std::llround(footV + line) % 5 == 0;
            const float a = alpha(line, along), b = alpha(line, along + 1);
            if (a <= 0 && b <= 0)
                continue;
            const Eigen::Vector3f grey(0.58F, 0.61F, 0.66F);
            const auto ink = [&](bool strong) {
                return Ink{grey, strong ? a * 1.3F : a, frame.stroke(0.9)};
            };
            lines.add(place(line, along), place(line, along + 1), ink(tenth), tenth ? b * 1.3F : b);
            lines.add(place(along, line), place(along + 1, line), ink(otherTenth),
                      otherTenth ? b * 1.3F : b);
        }
}

} // namespace render
