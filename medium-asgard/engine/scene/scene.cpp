#include "scene/scene.h"

#include <algorithm>

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

} // namespace scene
