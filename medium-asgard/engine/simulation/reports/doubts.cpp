#include "reports/doubts.h"

#include "collision/separation.h"
#include "reports/place_at.h"
#include "scene/shape_of.h"

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

struct BoxedPart {
    const geometry::Part* part;
    geometry::Box box;
    std::size_t number; // in the shape, from 1
};

bool overlap(const BoxedPart& one, const BoxedPart& other) {
    if (!one.box.intersects(other.box))
        return false;
    const double size = std::min(one.box.diagonal().norm(), other.box.diagonal().norm());
    collision::WarmStart warm;
    return collision::separate({.part = one.part}, {.part = other.part}, warm).gap < -1e-6 * size;
}

// Two of them, the lesser first; boxes are swept along x.
std::optional<std::pair<std::size_t, std::size_t>> overlapping(const geometry::Shape& shape) {
    std::vector<BoxedPart> parts;
    std::size_t number = 0;
    for (const geometry::Part& part : shape.parts)
        if (++number; !part.isPlane()) // without volume
            parts.push_back({&part, geometry::bounds(geometry::Shape{{part}}), number});
    std::ranges::sort(parts, {}, [](const BoxedPart& p) { return p.box.min().x(); });
    std::vector<const BoxedPart*> open;
    for (const BoxedPart& part : parts) {
        std::erase_if(open,
                      [&](const BoxedPart* o) { return o->box.max().x() < part.box.min().x(); });
        for (const BoxedPart* other : open)
            if (overlap(*other, part))
                return std::minmax(other->number, part.number);
        open.push_back(&part);
    }
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
        const bool counts = std::ranges::any_of(scene.bodies, [&](const scene::Body& body) {
            const bool isGiven = body.mass && body.inertia && body.center;
            return body.shape == set.name && !body.fixed && !isGiven;
        });
        const auto shape = scene::shapeOf(set);
        const auto* made = std::get_if<geometry::Shape>(&shape);
        const auto pair = counts && made ? overlapping(*made) : std::nullopt;
        if (pair)
            doubts.push_back(doubt(set.source, "-desc",
                                   "parts " + std::to_string(pair->first) + " and " +
                                       std::to_string(pair->second) + " of shape \"" + set.name +
                                       "\" overlap: mass, centre of mass and inertia count their "
                                       "common volume twice"));
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
                                   named + ": no body has such an inertia: no principal moment may "
                                           "be larger than the sum of the other two"));
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
