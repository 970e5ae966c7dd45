#include "scene/shape_of.h"

#include "geometry/hull.h"

#include <cstdio>

namespace scene {
namespace {

using Made = std::variant<geometry::Part, std::string>;

struct PartMaker {
    geometry::Pose pose;
    const std::function<void()>& meanwhile;

    Made operator()(const SphereShape& sphere) const {
        return geometry::spherePart(sphere.radius, pose.position);
    }
    Made operator()(const BoxShape& box) const {
        return geometry::polyhedronPart(geometry::box(box.edges), pose);
    }
    Made operator()(const CylinderShape& cylinder) const {
        return geometry::cylinderPart(cylinder.radius, cylinder.height, pose);
    }
    Made operator()(const ConeShape& cone) const {
        return geometry::conePart(cone.radius, cone.height, pose);
    }
    Made operator()(const CapsuleShape& capsule) const {
        return geometry::capsulePart(capsule.radius, capsule.height, pose);
    }
    Made operator()(const EllipsoidShape& ellipsoid) const {
        return geometry::ellipsoidPart(ellipsoid.axes, pose);
    }
    Made operator()(const PlaneShape&) const { return geometry::planePart(pose); }
    Made operator()(const TubeShape& tube) const {
        return geometry::tubePart(tube.inner, tube.outer, tube.height, pose);
    }
    Made operator()(const BowlShape& bowl) const {
        return geometry::bowlPart(bowl.inner, bowl.outer, pose);
    }
    Made operator()(const HullShape& hull) const {
        const auto made = geometry::convexHull(hull.points, meanwhile);
        if (const auto* refusal = std::get_if<geometry::HullRefusal>(&made))
            return refusal->sentence;
        return geometry::polyhedronPart(std::get<geometry::Hull>(made).polyhedron, pose);
    }
};

// Inertia is of the fifth power of sizes, and what divides by it of the sixth.
constexpr double least = 1e-50, most = 1e50;

std::optional<std::string> refusedSize(const geometry::Part& part) {
    if (part.isPlane())
        return std::nullopt;
    const double size = geometry::bounds({{part}}).sizes().maxCoeff();
    if (size >= least && size <= most)
        return std::nullopt;
    char text[120];
    std::snprintf(text, sizeof text,
                  "a part of it is %g long, and sizes from %g to %g can be computed with", size,
                  least, most);
    return text;
}

} // namespace

std::variant<geometry::Shape, std::string> shapeOf(const ShapeSet& set,
                                                   const std::function<void()>& meanwhile) {
    geometry::Shape shape;
    for (const Part& part : set.parts) {
        const geometry::Pose pose{part.position, geometry::fromRotationVector(part.rotation)};
        Made made = std::visit(PartMaker{pose, meanwhile}, part.shape);
        if (auto* sentence = std::get_if<std::string>(&made))
            return std::move(*sentence);
        shape.parts.push_back(std::get<geometry::Part>(std::move(made)));
        if (auto sentence = refusedSize(shape.parts.back()))
            return std::move(*sentence);
    }
    return shape;
}

const ShapeReader::Made& ShapeReader::of(const ShapeSet& set) {
    const auto place = known_.find(&set);
    return place != known_.end() ? place->second
                                 : known_.emplace(&set, shapeOf(set, meanwhile_)).first->second;
}

} // namespace scene
