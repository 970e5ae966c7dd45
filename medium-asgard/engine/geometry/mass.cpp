#include "geometry/mass.h"

#include <numbers>
#include <vector>

namespace geometry {

namespace {

// Of one part at density 1: the second moment C = integral of x x' about its own centroid.
struct Moments {
    double volume = 0;
    Vector centroid = Vector::Zero();
    Matrix second = Matrix::Zero();
};

Moments ofSphere(const Part& part) {
    const double r = part.radius;
    const double volume = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return {volume, part.center(), Matrix::Identity() * (volume * r * r / 5)};
}

Moments ofPolyhedron(const Polyhedron& polyhedron) {
    Vector inner = Vector::Zero();
    for (const Vector& v : polyhedron.vertices)
        inner += (v - polyhedron.vertices[0]) / static_cast<double>(polyhedron.vertices.size());
    inner += polyhedron.vertices[0];

    Moments sum;
    for (const Face& face : polyhedron.faces) {
        const Vector u = polyhedron.vertices[face.vertices[0]] - inner;
        for (std::size_t i = 1; i + 1 < face.vertices.size(); ++i) {
            const Vector v = polyhedron.vertices[face.vertices[i]] - inner;
            const Vector w = polyhedron.vertices[face.vertices[i + 1]] - inner;
            const Vector s = u + v + w;
            const double volume = u.dot(v.cross(w)) / 6;
            sum.volume += volume;
            sum.centroid += volume / 4 * s;
            sum.second +=
                volume / 20 *
                (u * u.transpose() + v * v.transpose() + w * w.transpose() + s * s.transpose());
        }
    }
    sum.centroid /= sum.volume;
    sum.second -= sum.volume * sum.centroid * sum.centroid.transpose();
    sum.centroid += inner;
    return sum;
}

} // namespace

namespace {

Moments momentsOf(const Part& part) {
    return part.isSphere() ? ofSphere(part) : ofPolyhedron(part.core);
}

// The union of parts whose moments are of volume, or of mass: then the volume is the mass.
MassProperties together(const std::vector<Moments>& parts) {
    MassProperties result;
    for (const Moments& m : parts)
        result.volume += m.volume;
    // Weights first: volume times place would lose digits far from the frame's origin.
    for (const Moments& m : parts)
        result.centroid += m.volume / result.volume * (m.centroid - parts[0].centroid);
    result.centroid += parts[0].centroid;
    Matrix second = Matrix::Zero();
    for (const Moments& m : parts) {
        const Vector d = m.centroid - result.centroid;
        second += m.second + m.volume * d * d.transpose();
    }
    result.inertia = second.trace() * Matrix::Identity() - second;
    return result;
}

} // namespace

MassProperties massProperties(const Shape& shape, double density) {
    std::vector<Moments> parts;
    for (const Part& part : shape.parts)
        parts.push_back(momentsOf(part));
    MassProperties result = together(parts);
    result.mass = density * result.volume;
    result.inertia = density * result.inertia;
    return result;
}

MassProperties massProperties(const Shape& shape, std::span<const double> densities) {
    std::vector<Moments> parts;
    double volume = 0;
    for (std::size_t i = 0; i < shape.parts.size(); ++i) {
        Moments moments = momentsOf(shape.parts[i]);
        volume += moments.volume;
        moments.volume *= densities[i];
        moments.second *= densities[i];
        parts.push_back(moments);
    }
    MassProperties result = together(parts);
    result.mass = result.volume;
    result.volume = volume;
    return result;
}

MassProperties scaledToMass(MassProperties properties, double mass) {
    properties.inertia *= mass / properties.mass;
    properties.mass = mass;
    return properties;
}

} // namespace geometry
