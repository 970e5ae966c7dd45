#include "simulation/doubts.h"

#include "collision/separation.h"
#include "scene/shape_of.h"
#include "simulation/place_at.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace simulation {
namespace {

constexpr double rounding = 1e-9; // of sizes, and of moments of inertia

scene::Diagnostic doubt(const scene::Source& source, const std::string& option,
                        std::string message) {
    scene::Diagnostic said;
    said.severity = scene::Severity::warning;
    said.message = std::move(message);
    placeAt(source, option, said);
    return said;
}

bool overlap(const geometry::Part& one, const geometry::Part& other) {
    const geometry::Shape first{{one}}, second{{other}};
    const geometry::Box a = geometry::bounds(first), b = geometry::bounds(second);
    const double size = std::min(a.diagonal().norm(), b.diagonal().norm());
    if (!a.intersects(b))
        return false;
    collision::WarmStart warm;
    return collision::separate({.part = &one}, {.part = &other}, warm).gap < -1e-6 * size;
}

// The first two, from 1.
std::optional<std::pair<std::size_t, std::size_t>> overlapping(const geometry::Shape& shape) {
    for (std::size_t i = 0; i < shape.parts.size(); ++i)
        for (std::size_t j = i + 1; j < shape.parts.size(); ++j)
            if (overlap(shape.parts[i], shape.parts[j]))
                return std::pair(i + 1, j + 1);
    return std::nullopt;
}

// Moments about three axes are sums of x^2 + y^2, y^2 + z^2 and z^2 + x^2: none is more than the
// two others together.
bool isPossible(const std::array<double, 6>& inertia) {
    const auto [xx, yy, zz, xy, xz, yz] = inertia;
    geometry::Matrix tensor;
    tensor << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const geometry::Vector m =
        Eigen::SelfAdjointEigenSolver<geometry::Matrix>(tensor, Eigen::EigenvaluesOnly)
            .eigenvalues(); // the least first
    return m[2] <= (m[0] + m[1]) * (1 + rounding);
}

void doubtShapes(const scene::Scene& scene, std::vector<scene::Diagnostic>& doubts) {
    for (const scene::ShapeSet& set : scene.shapeSets) {
        const bool moves = std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
            return body.shape == set.name && !body.fixed;
        });
        const auto shape = scene::shapeOf(set);
        const auto* made = std::get_if<geometry::Shape>(&shape);
        const auto pair = moves && made ? overlapping(*made) : std::nullopt;
        if (pair)
            doubts.push_back(doubt(set.source, "-desc",
                                   "parts " + std::to_string(pair->first) + " and " +
                                       std::to_string(pair->second) + " of shape \"" + set.name +
                                       "\" overlap: mass, centre of mass and inertia count twice "
                                       "what they share"));
    }
}

} // namespace

std::vector<scene::Diagnostic> doubtsAbout(const scene::Scene& scene) {
    std::vector<scene::Diagnostic> doubts;
    doubtShapes(scene, doubts);
    for (const scene::Body& body : scene.bodies) {
        const std::string named = "body \"" + body.name + "\"";
        if (body.inertia && !isPossible(*body.inertia))
            doubts.push_back(doubt(body.source, "-inertia",
                                   named + ": no distribution of mass has this inertia: about no "
                                           "axis can it be more than about two others together"));
        const bool hasVelocity =
            !body.initialVelocity.isZero(0) || !body.initialAngularVelocity.isZero(0);
        if (body.fixed && hasVelocity)
            doubts.push_back(doubt(body.source,
                                   body.initialVelocity.isZero(0) ? "-init_drot" : "-init_dpos",
                                   named + " is fixed: its velocity at the start is not used"));
    }
    return doubts;
}

} // namespace simulation
