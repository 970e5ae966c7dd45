#include "physics/mass.h"

#include "geometry/mass.h"
#include "scene/shape_of.h"

#include <algorithm>
#include <cmath>

namespace physics {
namespace {

using geometry::Matrix;

constexpr double negligible = 1e-13; // of the trace

Matrix givenInertia(const std::array<double, 6>& entries) {
    const auto [xx, yy, zz, xy, xz, yz] = entries;
    Matrix inertia;
    inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return inertia;
}

Matrix cleared(Matrix inertia) {
    const double limit = negligible * inertia.trace();
    inertia = (inertia.array().abs() < limit).select(Matrix::Zero(), inertia);
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (std::abs(inertia(i, i) - inertia(j, j)) < limit)
            inertia(j, j) = inertia(i, i);
    }
    return inertia;
}

} // namespace

bool BodyMass::isPrincipal() const {
    return inertia(0, 1) == 0 && inertia(0, 2) == 0 && inertia(1, 2) == 0;
}

bool BodyMass::isIsotropic() const {
    return isPrincipal() && inertia(0, 0) == inertia(1, 1) && inertia(1, 1) == inertia(2, 2);
}

std::variant<BodyMass, std::string> massOf(const scene::Scene& scene, const scene::Body& body) {
    const auto set = std::ranges::find(scene.shapeSets, body.shape, &scene::ShapeSet::name);
    if (set == scene.shapeSets.end())
        return "body \"" + body.name + "\": no shape set named \"" + body.shape + "\"";
    auto made = scene::shapeOf(*set);
    if (const auto* sentence = std::get_if<std::string>(&made))
        return "body \"" + body.name + "\": shape set \"" + body.shape + "\": " + *sentence;
    const auto& shape = std::get<geometry::Shape>(made);
    auto properties = geometry::massProperties(shape, body.density);
    if (body.mass)
        properties = geometry::scaledToMass(properties, *body.mass);
    BodyMass result;
    result.mass = properties.mass;
    result.centroid = properties.centroid;
    result.radius = geometry::radiusAbout(shape, properties.centroid);
    const double limit = negligible * result.radius;
    result.centroid =
        (result.centroid.array().abs() < limit).select(geometry::Vector::Zero(), result.centroid);
    result.inertia = cleared(body.inertia ? givenInertia(*body.inertia) : properties.inertia);
    return result;
}

} // namespace physics
