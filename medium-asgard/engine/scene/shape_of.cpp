#include "scene/shape_of.h"

#include "geometry/hull.h"

namespace scene {
namespace {

using Made = std::variant<geometry::Part, std::string>;

struct PartMaker {
    geometry::Pose pose;

    Made operator()(const SphereShape& sphere) const {
        return geometry::spherePart(sphere.radius, pose.position);
    }
    Made operator()(const BoxShape& box) const {
        return geometry::polyhedronPart(geometry::box(box.edges), pose);
    }
    Made operator()(const HullShape& hull) const {
        const auto made = geometry::convexHull(hull.points);
        if (const auto* refusal = std::get_if<geometry::HullRefusal>(&made))
            return refusal->sentence;
        return geometry::polyhedronPart(std::get<geometry::Hull>(made).polyhedron, pose);
    }
};

} // namespace

std::variant<geometry::Shape, std::string> shapeOf(const ShapeSet& set) {
    geometry::Shape shape;
    for (const Part& part : set.parts) {
        const geometry::Pose pose{part.position, geometry::fromRotationVector(part.rotation)};
        Made made = std::visit(PartMaker{pose}, part.shape);
        if (auto* sentence = std::get_if<std::string>(&made))
            return std::move(*sentence);
        shape.parts.push_back(std::get<geometry::Part>(std::move(made)));
    }
    return shape;
}

} // namespace scene
