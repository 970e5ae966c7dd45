// Mass, centre and inertia of a body, as its author gave them or as they follow from its shape.
#pragma once

#include "geometry/mass.h"
#include "scene/shape_of.h"

#include <string>
#include <unordered_map>
#include <variant>

namespace physics {

struct BodyMass {
    double mass = 0;
    geometry::Vector centroid = geometry::Vector::Zero(); // from the reference point, body frame
    geometry::Matrix inertia = geometry::Matrix::Zero();  // about the centroid, body axes
    double radius = 0;                                    // of the shape about the centroid

    // The same about every axis: rotation needs no gyroscopic term.
    [[nodiscard]] bool isIsotropic() const;
    [[nodiscard]] bool isPrincipal() const; // no products of inertia
};

// Rounding errors of products and differences that are 0 (1e-13 of the trace) are cleared, so that
// no equation depends on what it does not. Each shape set is worked out once.
class MassReader {
public:
    MassReader(const scene::Scene& scene, scene::ShapeReader& shapes);

    // The sentence says why there is no mass.
    [[nodiscard]] std::variant<BodyMass, std::string> massOf(const scene::Body& body);

private:
    struct OfUnitDensity {
        geometry::MassProperties properties;
        double radius = 0;
    };
    [[nodiscard]] const std::variant<OfUnitDensity, std::string>&
    propertiesOf(const scene::ShapeSet& set);

    // Of a body whose shape has these at density 1 throughout.
    [[nodiscard]] geometry::MassProperties propertiesOf(const scene::Body& body,
                                                        const scene::ShapeSet& set,
                                                        const geometry::MassProperties& unit);

    scene::ShapeReader& shapes_;
    std::unordered_map<std::string, const scene::ShapeSet*> sets_;
    std::unordered_map<const scene::ShapeSet*, std::variant<OfUnitDensity, std::string>> known_;
};

} // namespace physics
