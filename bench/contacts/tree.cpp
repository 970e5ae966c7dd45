#include "tree.h"

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

double treeRate(const Case& scene, std::size_t body) {
    const std::optional<std::size_t> found = treeJoint(scene, body);
    if (!found)
        return 0;
    const Joint& joint = scene.joints[*found];
    if (joint.type == Joint::Type::slider)
        return scene.bodies[body].velocity[0];
    const double carrier =
        joint.body2 < 0 ? 0 : scene.bodies[static_cast<std::size_t>(joint.body2)].spin;
    return scene.bodies[body].spin - carrier;
}

} // namespace bench::contacts
