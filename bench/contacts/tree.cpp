#include "tree.h"

#include <algorithm>

namespace bench::contacts {

std::optional<std::size_t> treeJoint(const Case& scene, std::size_t body) {
    std::optional<std::size_t> found;
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
        if (static_cast<std::size_t>(scene.joints[j].body1) == body &&
            (!found || scene.joints[j].type == Joint::Type::slider))
            found = j;
    return found;
}

std::vector<std::size_t> loopJoints(const Case& scene) {
    std::vector<std::size_t> loops;
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
        if (treeJoint(scene, static_cast<std::size_t>(scene.joints[j].body1)) != j)
            loops.push_back(j);
    return loops;
}

std::vector<Place> closingPoints(const Case& scene, const Joint& hinge) {
    if (std::ranges::all_of(scene.joints, [](const Joint& joint) {
            return joint.type == Joint::Type::slider || joint.axis == Place{0, 0, 1};
        }))
        return {hinge.at};
    std::vector<Place> points(2, hinge.at);
    for (std::size_t a = 0; a < 3; ++a) {
        points[0][a] -= hinge.axis[a] / 2;
        points[1][a] += hinge.axis[a] / 2;
    }
    return points;
}

double treeRate(const Case& scene, std::size_t body) {
    const std::optional<std::size_t> found = treeJoint(scene, body);
    if (!found)
        return 0;
    const Joint& joint = scene.joints[*found];
    if (joint.type == Joint::Type::slider)
        return scene.bodies[body].velocity[0] * joint.axis[0] +
               scene.bodies[body].velocity[1] * joint.axis[1];
    const double carrier =
        joint.body2 < 0 ? 0 : scene.bodies[static_cast<std::size_t>(joint.body2)].spin;
    return scene.bodies[body].spin - carrier;
}

} // namespace bench::contacts
