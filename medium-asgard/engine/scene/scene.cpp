#include "scene/scene.h"

#include <algorithm>
#include <cmath>

namespace scene {

namespace {

template <typename Element>
const Element* find(const std::vector<Element>& elements, const std::string& name) {
    const auto found = std::find_if(elements.begin(), elements.end(),
                                    [&](const Element& e) { return e.name == name; });
    return found == elements.end() ? nullptr : &*found;
}

} // namespace

const ShapeSet* findShapeSet(const Scene& scene, const std::string& name) {
    return find(scene.shapeSets, name);
}

const Body* findBody(const Scene& scene, const std::string& name) {
    return find(scene.bodies, name);
}

const Trajectory* findTrajectory(const Scene& scene, const std::string& name) {
    return find(scene.trajectories, name);
}

const Joint* findJoint(const Scene& scene, const std::string& name) {
    return find(scene.joints, name);
}

namespace {

struct Reach {
    double operator()(const SphereShape& sphere) const { return sphere.radius; }
    double operator()(const BoxShape& box) const { return box.edges.norm() / 2; }
    double operator()(const CylinderShape& cylinder) const {
        return std::hypot(cylinder.radius, cylinder.height / 2);
    }
    double operator()(const ConeShape& cone) const {
        return std::hypot(cone.radius, cone.height / 2);
    }
    double operator()(const CapsuleShape& capsule) const {
        return capsule.radius + capsule.height / 2;
    }
    double operator()(const EllipsoidShape& ellipsoid) const { return ellipsoid.axes.maxCoeff(); }
    double operator()(const PlaneShape&) const { return 0; }
    double operator()(const TubeShape& tube) const {
        return std::hypot(tube.outer, tube.height / 2);
    }
    double operator()(const BowlShape& bowl) const { return bowl.outer; }
    double operator()(const HullShape& hull) const {
        double farthest = 0;
        for (const Vector& point : hull.points)
            farthest = std::max(farthest, point.norm());
        return farthest;
    }
};

} // namespace

double reachOf(const Part& part) { return std::visit(Reach{}, part.shape); }

bool hasPlane(const ShapeSet& set) {
    return std::ranges::any_of(
        set.parts, [](const Part& part) { return std::holds_alternative<PlaneShape>(part.shape); });
}

bool hasVolume(const ShapeSet& set) {
    return std::ranges::any_of(set.parts, [](const Part& part) {
        const auto* cylinder = std::get_if<CylinderShape>(&part.shape);
        return !std::holds_alternative<PlaneShape>(part.shape) &&
               (!cylinder || cylinder->height > 0);
    });
}

const Contact* findContact(const Scene& scene, const std::string& body1, const std::string& body2) {
    for (const Contact& contact : scene.contacts)
        if ((contact.body1 == body1 && contact.body2 == body2) ||
            (contact.body1 == body2 && contact.body2 == body1))
            return &contact;
    return nullptr;
}

} // namespace scene
