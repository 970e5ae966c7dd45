#include "editing/element.h"

namespace editing {

namespace {

template <class List> const scene::Source* sourceIn(const List& list, std::size_t index) {
    return index < list.size() ? &list[index].source : nullptr;
}

} // namespace

const scene::Source* sourceOf(const scene::Scene& scene, const Element& element) {
    switch (element.kind) {
    case Kind::simulator:
        return scene.simulator.source ? &*scene.simulator.source : nullptr;
    case Kind::shapeSet:
        return sourceIn(scene.shapeSets, element.index);
    case Kind::body:
        return sourceIn(scene.bodies, element.index);
    case Kind::force:
        return sourceIn(scene.forces, element.index);
    case Kind::link:
        return sourceIn(scene.links, element.index);
    case Kind::joint:
        return sourceIn(scene.joints, element.index);
    case Kind::gear:
        return sourceIn(scene.gears, element.index);
    case Kind::rope:
        return sourceIn(scene.ropes, element.index);
    case Kind::contact:
        return sourceIn(scene.contacts, element.index);
    case Kind::trajectory:
        return sourceIn(scene.trajectories, element.index);
    case Kind::constraint:
        return sourceIn(scene.constraints, element.index);
    case Kind::light:
        return sourceIn(scene.lights, element.index);
    case Kind::view:
        return sourceIn(scene.views, element.index);
    case Kind::parameter:
        return sourceIn(scene.parameters, element.index);
    case Kind::plot:
        break;
    }
    return sourceIn(scene.plots, element.index);
}

std::string nameOf(const scene::Scene& scene, const Element& element) {
    switch (element.kind) {
    case Kind::shapeSet:
        return scene.shapeSets[element.index].name;
    case Kind::body:
        return scene.bodies[element.index].name;
    case Kind::link:
        return scene.links[element.index].name;
    case Kind::joint:
        return scene.joints[element.index].name;
    case Kind::gear:
        return scene.gears[element.index].name;
    case Kind::rope:
        return scene.ropes[element.index].name;
    case Kind::contact:
        return scene.contacts[element.index].name;
    case Kind::trajectory:
        return scene.trajectories[element.index].name;
    case Kind::light:
        return scene.lights[element.index].name;
    case Kind::view:
        return scene.views[element.index].name;
    case Kind::parameter:
        return scene.parameters[element.index].name;
    case Kind::plot:
        return scene.plots[element.index].name;
    default:
        return "";
    }
}

std::string wordOf(Kind kind) {
    constexpr const char* words[] = {"simulator",  "shape set", "body", "force",     "link",
                                     "joint",      "gear",      "rope", "contact",   "trajectory",
                                     "constraint", "light",     "view", "parameter", "plot"};
    return words[static_cast<std::size_t>(kind)];
}

std::string commandOf(Kind kind) {
    constexpr const char* names[] = {"simulator", "shape_set",   "body", "force",     "link",
                                     "joint",     "gear",        "rope", "contact",   "trajectory",
                                     "constrain", "lightsource", "view", "parameter", "plot"};
    return names[static_cast<std::size_t>(kind)];
}

std::string commandOf(const scene::Scene& scene, const Element& element) {
    const bool isSpring = element.kind == Kind::link && element.index < scene.links.size() &&
                          scene.links[element.index].spring.has_value();
    return isSpring ? "spring" : commandOf(element.kind);
}

std::string describe(const scene::Scene& scene, const Element& element) {
    const scene::Source* source = sourceOf(scene, element);
    const std::string name = source ? nameOf(scene, element) : "";
    const std::string word =
        commandOf(scene, element) == "spring" ? "spring" : wordOf(element.kind);
    if (!name.empty())
        return word + " \"" + name + "\"";
    return "the " + word +
           (source && source->line > 0 ? " of line " + std::to_string(source->line) : "");
}

std::size_t countOf(const scene::Scene& scene, Kind kind) {
    if (kind == Kind::simulator) // whatever its index
        return sourceOf(scene, {kind, 0}) ? 1 : 0;
    std::size_t count = 0;
    while (sourceOf(scene, {kind, count}))
        ++count;
    return count;
}

} // namespace editing
