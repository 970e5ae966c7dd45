#include "geometry/mass.h"

#include <cmath>
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

// C = volume (across (1 - u u') + along u u') for the axis u.
Moments about(const Vector& centroid, const Vector& u, double volume, double across, double along) {
    const Matrix uu = u * u.transpose();
    return {volume, centroid, volume * (across * (Matrix::Identity() - uu) + along * uu)};
}

// Two half spheres (centroid 3 r / 8 beyond their centres) and the tube between.
Moments ofCapsule(const Part& part) {
    const Vector &a = part.core.vertices[0], &b = part.core.vertices[1];
    const double r = part.radius, h = (b - a).norm();
    const double tube = std::numbers::pi * r * r * h;
    const double ball = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    const double volume = tube + ball;
    const double across = (tube * r * r / 4 + ball * r * r / 5) / volume;
    const double along =
        (tube * h * h / 12 + ball * (h * h / 4 + 3 * h * r / 8 + r * r / 5)) / volume;
    return about((a + b) / 2, (b - a) / h, volume, across, along);
}

// Half of what the shell about the same centre has.
Moments ofBowl(const Curved& bowl) {
    const auto power = [&](int n) { return std::pow(bowl.radius(), n) - std::pow(bowl.inner, n); };
    const double volume = 2 * std::numbers::pi / 3 * power(3);
    const double depth = 3 * power(4) / (8 * power(3)); // of the centroid
    const double square = power(5) / (5 * power(3));
    return about(bowl.center - depth * bowl.axis(), bowl.axis(), volume, square,
                 square - depth * depth);
}

Moments ofCurved(const Curved& curved) {
    const double r = curved.radius(), h = 2 * curved.half();
    const double disc = std::numbers::pi * r * r;
    switch (curved.kind) {
    case Curved::Kind::cylinder:
        return about(curved.center, curved.axis(), disc * h, r * r / 4, h * h / 12);
    case Curved::Kind::tube: {
        const double bore = std::numbers::pi * curved.inner * curved.inner;
        return about(curved.center, curved.axis(), (disc - bore) * h,
                     (r * r + curved.inner * curved.inner) / 4, h * h / 12);
    }
    case Curved::Kind::bowl:
        return ofBowl(curved);
    case Curved::Kind::cone:
        return about(curved.center - h / 4 * curved.axis(), curved.axis(), disc * h / 3,
                     3 * r * r / 20, 3 * h * h / 80);
    case Curved::Kind::ellipsoid: {
        const Vector& a = curved.sizes;
        const double volume = 4.0 / 3.0 * std::numbers::pi * a.prod();
        const Matrix own = (volume / 5 * a.cwiseProduct(a)).asDiagonal();
        return {volume, curved.center, curved.frame * own * curved.frame.transpose()};
    }
    case Curved::Kind::plane:
        break;
    }
    return {0, curved.center, Matrix::Zero()};
}

Moments momentsOf(const Part& part) {
    return part.curved        ? ofCurved(*part.curved)
           : part.isCapsule() ? ofCapsule(part)
           : part.isSphere()  ? ofSphere(part)
                              : ofPolyhedron(part.core);
}

bool isDisc(const Part& part) {
    return part.curved && part.curved->kind == Curved::Kind::cylinder && part.curved->half() == 0;
}

// Of nothing but discs (and half spaces): of their areas.
std::vector<Moments> momentsOf(const Shape& shape) {
    std::vector<Moments> parts;
    double volume = 0;
    for (const Part& part : shape.parts) {
        parts.push_back(momentsOf(part));
        volume += parts.back().volume;
    }
    for (std::size_t i = 0; i < parts.size() && volume == 0; ++i)
        if (isDisc(shape.parts[i])) {
            const Curved& disc = *shape.parts[i].curved;
            const double square = disc.radius() * disc.radius();
            parts[i] = about(disc.center, disc.axis(), std::numbers::pi * square, square / 4, 0);
        }
    return parts;
}

double volumeOf(const Shape& shape) {
    double volume = 0;
    for (const Part& part : shape.parts)
        volume += momentsOf(part).volume;
    return volume;
}

// The union of parts whose moments are of volume, or of mass: then the volume is the mass.
MassProperties together(const std::vector<Moments>& parts) {
    MassProperties result;
    for (const Moments& m : parts)
        result.volume += m.volume;
    result.centroid = parts[0].centroid;
    if (result.volume == 0)
        return result;
    result.centroid.setZero();
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
    MassProperties result = together(momentsOf(shape));
    result.mass = density * result.volume;
    result.inertia = density * result.inertia;
    result.volume = volumeOf(shape);
    return result;
}

MassProperties massProperties(const Shape& shape, std::span<const double> densities) {
    std::vector<Moments> parts = momentsOf(shape);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].volume *= densities[i];
        parts[i].second *= densities[i];
    }
    MassProperties result = together(parts);
    result.mass = result.volume;
    result.volume = volumeOf(shape);
    return result;
}

MassProperties scaledToMass(MassProperties properties, double mass) {
    if (properties.mass != 0)
        properties.inertia *= mass / properties.mass;
    properties.mass = mass;
    return properties;
}

} // namespace geometry
