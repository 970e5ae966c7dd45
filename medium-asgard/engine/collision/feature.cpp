#include "collision/feature.h"

#include <algorithm>
#include <cmath>

namespace collision {
namespace {

using geometry::Curved;
using Kind = Feature::Kind;

void addPolyhedron(std::vector<Feature>& features, const Part& part, const Vector& direction,
                   double depth) {
    const geometry::Polyhedron& core = part.core;
    std::vector<double> heights;
    for (const Vector& vertex : core.vertices)
        heights.push_back(direction.dot(vertex));
    const double least = *std::ranges::max_element(heights) - depth;
    const auto isNear = [&](std::size_t vertex) { return heights[vertex] >= least; };
    for (const geometry::Face& face : core.faces) {
        if (!std::ranges::all_of(face.vertices, isNear) || face.normal.dot(direction) <= 0)
            continue;
        Feature feature{
            .kind = Kind::face, .place = core.vertices[face.vertices[0]], .axis = face.normal};
        for (const std::size_t vertex : face.vertices)
            feature.outline.push_back(core.vertices[vertex]);
        features.push_back(std::move(feature));
    }
    const auto addEdge = [&](std::size_t from, std::size_t to) {
        if (!isNear(from) || !isNear(to))
            return;
        const Vector along = core.vertices[to] - core.vertices[from];
        features.push_back({.kind = Kind::segment,
                            .place = (core.vertices[from] + core.vertices[to]) / 2,
                            .axis = along.normalized(),
                            .radius = part.radius,
                            .length = along.norm()});
    };
    if (part.isCapsule())
        addEdge(0, 1);
    for (const geometry::Edge& edge : core.edges)
        addEdge(edge.from, edge.to);
    for (std::size_t i = 0; i < core.vertices.size(); ++i)
        if (isNear(i))
            features.push_back({.kind = Kind::point,
                                .place = core.vertices[i],
                                .axis = Vector::UnitY(),
                                .radius = part.radius});
}

Feature disc(Kind kind, const Curved& curved, double sign) {
    return {.kind = kind,
            .place = curved.center + sign * curved.half() * curved.axis(),
            .axis = sign * curved.axis(),
            .radius = curved.radius()};
}

void addCylinder(std::vector<Feature>& features, const Curved& curved, double along, double depth) {
    const double fall = 2 * curved.half() * std::abs(along); // from the upper end to the lower
    const double upper = along >= 0 ? 1 : -1;
    features.push_back(disc(Kind::face, curved, upper));
    if (fall <= depth && curved.half() > 0)
        features.push_back({.kind = Kind::segment,
                            .place = curved.center,
                            .axis = curved.axis(),
                            .radius = curved.radius(),
                            .length = 2 * curved.half()});
    features.push_back(disc(Kind::circle, curved, upper));
    if (fall <= depth && curved.half() > 0) {
        features.push_back(disc(Kind::circle, curved, -upper));
        features.push_back(disc(Kind::face, curved, -upper));
    }
}

void addCone(std::vector<Feature>& features, const Curved& curved, double along, double across,
             double depth) {
    const double apex = curved.half() * along;
    const double rim = curved.radius() * across - curved.half() * along;
    const Vector tip = curved.center + curved.half() * curved.axis();
    if (rim >= apex - depth && (along < 0 || 2 * curved.radius() * across <= depth))
        features.push_back(disc(Kind::face, curved, -1));
    if (std::abs(apex - rim) <= depth)
        features.push_back(
            {.kind = Kind::cone,
             .place = tip,
             .axis = curved.axis(),
             .radius = curved.radius(),
             .length = 2 * curved.half(),
             .sine = curved.radius() / std::hypot(curved.radius(), 2 * curved.half())});
    if (rim >= apex - depth)
        features.push_back(disc(Kind::circle, curved, -1));
    if (apex >= rim - depth)
        features.push_back({.kind = Kind::point, .place = tip});
}

// Its outside, edge and lid.
void addBowl(std::vector<Feature>& features, const Curved& curved, double along, double across,
             double depth) {
    const double r = curved.radius();
    if (along > 0 && 2 * r * across <= depth)
        features.push_back(disc(Kind::face, curved, 1));
    if (along * r <= depth)
        features.push_back({.kind = Kind::point, .place = curved.center, .radius = r});
    if (along > 0 || r * across >= r - depth)
        features.push_back(disc(Kind::circle, curved, 1));
}

} // namespace

std::vector<Feature> featuresAlong(const Part& part, const Vector& direction, double depth) {
    std::vector<Feature> features;
    if (!part.curved) {
        addPolyhedron(features, part, direction, depth);
        return features;
    }
    const Curved& curved = *part.curved;
    const Vector d = curved.frame.transpose() * direction;
    switch (curved.kind) {
    case Curved::Kind::cylinder:
    case Curved::Kind::tube:
        addCylinder(features, curved, d.y(), depth);
        break;
    case Curved::Kind::bowl:
        addBowl(features, curved, d.y(), std::hypot(d.x(), d.z()), depth);
        break;
    case Curved::Kind::cone:
        addCone(features, curved, d.y(), std::hypot(d.x(), d.z()), depth);
        break;
    case Curved::Kind::ellipsoid:
        features.push_back({.kind = Kind::ellipsoid,
                            .place = curved.center,
                            .axis = curved.axis(),
                            .axes = curved.frame * curved.sizes.asDiagonal()});
        break;
    case Curved::Kind::plane:
        features.push_back({.kind = Kind::face, .place = curved.center, .axis = curved.axis()});
        break;
    }
    return features;
}

Feature placed(Feature feature, const Posed& posed) {
    feature.place = posed.rotation * feature.place + posed.offset;
    feature.axis = posed.rotation * feature.axis;
    feature.axes = posed.rotation * feature.axes;
    for (Vector& corner : feature.outline)
        corner = posed.rotation * corner + posed.offset;
    return feature;
}

} // namespace collision
