#include "surroundings/ground.h"

#include "drawing/round_numbers.h"
#include "drawing/shaders.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace render {

namespace {

// Area of the mesh's level upward faces that stand highest, their height, and that of its lowest
// corner.
struct Top {
    double area = 0;
    double height = 0;
    double bottom = std::numeric_limits<double>::infinity();
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
        const double low = std::min({a.dot(up), corner(i + 1).dot(up), corner(i + 2).dot(up)});
        top.bottom = std::min(top.bottom, low);
        if (twice.dot(up) < 0.9999 * twice.norm())
            continue;
        const double height = a.dot(up);
        if (top.area == 0 || height > top.height + 1e-6 * solid.radius)
            top = {0, height, top.bottom};
        top.area += twice.norm() / 2;
    }
    return top;
}

constexpr double far = 1.5; // sizes: further away 0 would be out of the picture

// The largest level face of a fixed body, if it is large enough to be a floor and no ceiling. A
// table that stands above the ground at 0 is none.
struct Floor {
    double height = 0; // world
    Eigen::Vector3f color;
    bool isEndless = false;
};
std::optional<Floor> floorOf(std::span<const Solid> solids, const Extent& extent,
                             const Frame& frame, Solids& meshes) {
    const Vector up = frame.directionInView(extent.ground);
    const Vector middle = extent.box.center();
    const double middleHeight = frame.toView(middle).dot(up);
    const bool anyMoves = std::ranges::find(extent.moves, true) != extent.moves.end();
    const double highest = // what lies above all that moves is a ceiling
        anyMoves ? middleHeight + 0.499 * frame.camera().scale *
                                      extent.box.sizes().dot(extent.ground.cwiseAbs())
                 : std::numeric_limits<double>::infinity();
    const auto inWorld = [&](double height) {
        return middle.dot(extent.ground) + (height - middleHeight) / frame.camera().scale;
    };
    const auto isTable = [&](const Solid& solid, const Top& top) {
        const double bottom = inWorld(top.bottom);
        return !std::holds_alternative<scene::PlaneShape>(solid.part->shape) &&
               bottom >= -1e-6 * extent.size && bottom <= far * extent.size;
    };
    std::optional<Floor> floor;
    double largest = std::pow(0.3 * extent.size * frame.camera().scale, 2);
    for (const Solid& solid : solids) {
        if (!extent.fixed[solid.body] || extent.moves[solid.body] ||
            std::holds_alternative<scene::SphereShape>(solid.part->shape))
            continue;
        const Top top = topOf(solid, meshes.meshOf(solid, frame), up);
        if (top.area > largest && top.height < highest && !isTable(solid, top)) {
            largest = top.area;
            floor = {inWorld(top.height), solid.color,
                     std::holds_alternative<scene::PlaneShape>(solid.part->shape)};
        }
    }
    return floor;
}

} // namespace

bool isGroundOf(const Extent& extent, double height) {
    const double above = extent.lowest - height;
    return above >= -1e-6 * extent.size && above <= far * extent.size;
}

double groundHeight(const Extent& extent) {
    if (isGroundOf(extent, 0))
        return 0;
    if (extent.lowestStands)
        return extent.lowest;
    const double step = roundBelow(extent.size / 8);
    return step * std::floor(extent.lowest / step + 0.02);
}

Ground groundOf(std::span<const Solid> solids, const Extent& extent, const Frame& frame,
                Solids& meshes) {
    if (const auto floor = floorOf(solids, extent, frame, meshes)) {
        const GroundPlane plane = groundPlane(extent.ground, floor->height);
        if (floor->isEndless)
            return {plane, floor->color, std::nullopt};
        constexpr double beneath = 1e-4; // of the scene: the floor hides the shadows there
        return {plane, floor->color,
                groundPlane(extent.ground, floor->height - beneath * extent.size)};
    }
    const GroundPlane plane = groundPlane(extent.ground, groundHeight(extent));
    return {plane, std::nullopt, plane};
}

GroundShadow::~GroundShadow() { gl_.DeleteVertexArrays(1, &array_); }

std::string GroundShadow::build() {
    gl_.GenVertexArrays(1, &array_);
    return program_.build(groundVertexShader, {shadowFunctions, groundFragmentShader});
}

void GroundShadow::show(const GroundPlane& ground, const Light& light,
                        std::span<const LightSight> sights, const Frame& frame,
                        const float* projection, float strength) const {
    const Vector up = frame.directionInView(ground.up), foot = frame.toView(ground.place(0, 0));
    if (up.dot(frame.eye() - foot) <= 0)
        return;
    // The map's four corners along their rays to the ground.
    const Eigen::Matrix4d back = sights.back().matrix.inverse();
    std::array<float, 12> corners;
    for (std::size_t i = 0; i < 4; ++i) {
        const double x = i % 2 == 0 ? -1 : 1, y = i < 2 ? -1 : 1;
        const Vector from = (back * Eigen::Vector4d(x, y, -1, 1)).hnormalized();
        const Vector way = (back * Eigen::Vector4d(x, y, 1, 1)).hnormalized() - from;
        const double falls = -way.dot(up);
        if (falls < 1e-3 * way.norm())
            return; // LIMIT: light that comes level, or from below, throws no shadow on the ground
        const Vector hit = from + way * ((from - foot).dot(up) / falls);
        for (std::size_t k = 0; k < 3; ++k)
            corners[3 * i + k] = static_cast<float>(hit[static_cast<Eigen::Index>(k)]);
    }
    const Vector toLight =
        light.isPoint ? Vector((light.place - foot).normalized()) : Vector(light.place);
    const Eigen::Vector3f towards = toLight.cast<float>();
    program_.use();
    gl_.UniformMatrix4fv(program_.place("projection"), 1, GL_FALSE, projection);
    gl_.Uniform3fv(program_.place("corner"), 4, corners.data());
    gl_.Uniform3fv(program_.place("toLight"), 1, towards.data());
    gl_.Uniform4f(program_.place("ink"), 0.06F, 0.07F, 0.10F, strength);
    program_.giveShadow(sights);
    gl_.BindVertexArray(array_);
    gl_.Disable(GL_CULL_FACE);
    gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    gl_.Enable(GL_CULL_FACE);
}

} // namespace render
