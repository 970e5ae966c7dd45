#include "collision/nearest_feature.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {
namespace {

using geometry::Edge;
using geometry::Face;
using geometry::Polyhedron;

const Face& facing(const Polyhedron& core, const Vector& point) {
    return *std::ranges::max_element(
        core.faces, {}, [&](const Face& face) { return face.normal.dot(point) - face.offset; });
}

bool isOver(const Polyhedron& core, const Face& face, const Vector& point, double border) {
    for (std::size_t i = 0; i < face.vertices.size(); ++i) {
        const Vector& a = core.vertices[face.vertices[i]];
        const Vector& b = core.vertices[face.vertices[(i + 1) % face.vertices.size()]];
        if (face.normal.cross(b - a).normalized().dot(point - a) < -border)
            return false;
    }
    return true;
}

struct Nearest {
    std::vector<std::size_t> vertices;
    Vector place = Vector::Zero();
    double square = std::numeric_limits<double>::infinity();
};

Nearest nearestOnEdges(const Polyhedron& core, const Vector& point, double border) {
    Nearest nearest;
    for (const Edge& edge : core.edges) {
        const Vector &a = core.vertices[edge.from], &b = core.vertices[edge.to];
        const double length = (b - a).norm(), along = (b - a).dot(point - a) / length;
        const Vector place = a + (b - a) * (std::clamp(along, 0.0, length) / length);
        const double square = (point - place).squaredNorm();
        if (square > nearest.square || (square == nearest.square && nearest.vertices.size() == 2))
            continue;
        nearest = {{edge.from, edge.to}, place, square};
        if (along < -border)
            nearest.vertices = {edge.from};
        else if (along > length + border)
            nearest.vertices = {edge.to};
    }
    return nearest;
}

} // namespace

namespace {

NearestFeature footOnPlane(const Posed& posed, const Vector& point) {
    NearestFeature feature;
    feature.normal = posed.rotation * posed.part->curved->axis();
    const Vector origin = posed.rotation * posed.part->curved->center + posed.offset;
    feature.distance = feature.normal.dot(point - origin);
    const Vector foot = point - feature.distance * feature.normal;
    const Vector right = feature.normal.unitOrthogonal(), up = feature.normal.cross(right);
    feature.corners = {foot, foot + right, foot + up};
    return feature;
}

} // namespace

NearestFeature nearestFeature(const Posed& posed, const Vector& point, double border) {
    if (posed.part->isPlane())
        return footOnPlane(posed, point);
    const Polyhedron& core = posed.part->core;
    const Vector local = posed.rotation.transpose() * (point - posed.offset);
    const Face& face = facing(core, local);
    NearestFeature feature;
    std::vector<std::size_t> vertices = face.vertices;
    if (isOver(core, face, local, border)) {
        feature.normal = posed.rotation * face.normal;
        feature.distance = face.normal.dot(local) - face.offset;
    } else {
        Nearest nearest = nearestOnEdges(core, local, border);
        feature.distance = std::sqrt(nearest.square);
        feature.normal = posed.rotation * ((local - nearest.place) / feature.distance);
        vertices = std::move(nearest.vertices);
    }
    for (const std::size_t vertex : vertices)
        feature.corners.push_back(posed.world(vertex));
    return feature;
}

} // namespace collision
