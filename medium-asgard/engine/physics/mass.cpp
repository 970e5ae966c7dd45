#include "physics/mass.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

bool hasOwnDensities(const scene::ShapeSet& set) {
    return std::ranges::any_of(set.parts,
                               [](const scene::Part& part) { return part.density.has_value(); });
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

MassReader::MassReader(const scene::Scene& scene, scene::ShapeReader& shapes) : shapes_(shapes) {
    for (const scene::ShapeSet& set : scene.shapeSets)
        sets_.try_emplace(set.name, &set);
}

const std::variant<MassReader::OfUnitDensity, std::string>&
MassReader::propertiesOf(const scene::ShapeSet& set) {
    const auto [it, isNew] = known_.try_emplace(&set);
    if (!isNew)
        return it->second;
    const auto& made = shapes_.of(set);
    if (const auto* sentence = std::get_if<std::string>(&made)) {
        it->second = *sentence;
    } else {
        const auto& shape = std::get<geometry::Shape>(made);
        const auto properties = geometry::massProperties(shape, 1);
        it->second = OfUnitDensity{properties, geometry::radiusAbout(shape, properties.centroid)};
    }
    return it->second;
}

geometry::MassProperties MassReader::propertiesOf(const scene::Body& body,
                                                  const scene::ShapeSet& set,
                                                  const geometry::MassProperties& unit) {
    if (!hasOwnDensities(set))
        return geometry::scaledToMass(unit, body.mass.value_or(body.density * unit.volume));
    std::vector<double> densities;
    for (const scene::Part& part : set.parts)
        densities.push_back(part.density.value_or(body.density));
    const auto own =
        geometry::massProperties(std::get<geometry::Shape>(shapes_.of(set)), densities);
    return body.mass ? geometry::scaledToMass(own, *body.mass) : own;
}

std::variant<BodyMass, std::string> MassReader::massOf(const scene::Body& body) {
    const auto set = sets_.find(body.shape);
    if (set == sets_.end())
        return "body \"" + body.name + "\": no shape set named \"" + body.shape + "\"";
    const auto& known = propertiesOf(*set->second);
    if (const auto* sentence = std::get_if<std::string>(&known))
        return "body \"" + body.name + "\": shape set \"" + body.shape + "\": " + *sentence;
    const auto& [unit, radius] = std::get<OfUnitDensity>(known);
    const auto properties = propertiesOf(body, *set->second, unit);
    BodyMass result;
    result.mass = properties.mass;
    const auto isRounding = properties.centroid.array().abs() < negligible * radius;
    result.centroid =
        body.center.value_or(isRounding.select(geometry::Vector::Zero(), properties.centroid));
    result.radius = radius;
    if (body.center || hasOwnDensities(*set->second))
        result.radius = geometry::radiusAbout(std::get<geometry::Shape>(shapes_.of(*set->second)),
                                              result.centroid);
    if (!(result.radius > 0) && !body.fixed) // a half space that is led: the unit of its search
        result.radius = 1;
    result.inertia = cleared(body.inertia ? givenInertia(*body.inertia) : properties.inertia);
    return result;
}

} // namespace physics
