#include "editing/element_values.h"

#include "script/numbers.h"

#include <variant>

namespace editing {

using geometry::Vector;

namespace {

using Values = std::optional<std::vector<double>>;

Values listed(const Vector& v) { return std::vector<double>{v.x(), v.y(), v.z()}; }
Values listed(const std::optional<Vector>& v) { return v ? listed(*v) : std::nullopt; }

// Of -x, -y or -z.
Values component(const std::array<scene::Expression, 3>& components, const std::string& option) {
    if (option.size() != 2 || option[1] < 'x' || option[1] > 'z')
        return std::nullopt;
    const auto value = script::decimalNumber(components[static_cast<std::size_t>(option[1] - 'x')]);
    return value ? Values(std::vector<double>{*value}) : std::nullopt;
}

Values ofBody(const scene::Body& body, const std::string& option) {
    if (option == "-mass")
        return body.mass ? Values(std::vector<double>{*body.mass}) : std::nullopt;
    if (option == "-fixed")
        return std::vector<double>{body.fixed ? 1.0 : 0.0};
    if (option == "-init_rot")
        return listed(Vector(geometry::toRotationVector(body.initialAttitude)));
    return option == "-init_pos"    ? listed(body.initialPosition)
           : option == "-init_dpos" ? listed(body.initialVelocity)
           : option == "-init_drot" ? listed(body.initialAngularVelocity)
                                    : std::nullopt;
}

Values ofForce(const scene::Force& force, const std::string& option) {
    if (option == "-offset")
        return listed(force.offset);
    if (const auto* weight = std::get_if<scene::GravitationalForce>(&force.kind))
        return option == "-gravitational" ? listed(weight->acceleration) : std::nullopt;
    const auto* given = std::get_if<scene::ComponentForce>(&force.kind);
    return given ? component(given->components, option) : std::nullopt;
}

Values ofLink(const scene::Link& link, const std::string& option) {
    const auto* end = std::get_if<scene::BodyEnd>(&link.second);
    const auto* point = std::get_if<scene::PointEnd>(&link.second);
    return option == "-offset1"          ? listed(link.first.offset)
           : option == "-offset2" && end ? listed(end->offset)
           : point                       ? component(point->coordinates, option)
                                         : std::nullopt;
}

Values ofJoint(const scene::Joint& joint, const std::string& option) {
    return option == "-offset1"   ? listed(joint.offset1)
           : option == "-offset2" ? listed(joint.offset2)
           : option == "-axis"    ? listed(joint.axis)
           : option == "-axis2"   ? listed(joint.axis2)
                                  : std::nullopt;
}

} // namespace

Values valuesOf(const scene::Scene& scene, const Element& element, const std::string& option) {
    const std::size_t i = element.index;
    switch (element.kind) {
    case Kind::body:
        return ofBody(scene.bodies[i], option);
    case Kind::force:
        return ofForce(scene.forces[i], option);
    case Kind::link:
        return ofLink(scene.links[i], option);
    case Kind::joint:
        return ofJoint(scene.joints[i], option);
    case Kind::light:
        return option == "-pos"         ? listed(scene.lights[i].position)
               : option == "-direction" ? listed(scene.lights[i].direction)
                                        : std::nullopt;
    default:
        return std::nullopt;
    }
}

namespace {

using Name = std::optional<std::string>;

Name ofEnd(const scene::Link& link, const std::string& option) {
    if (option == "-body1")
        return link.first.body;
    if (const auto* body = std::get_if<scene::BodyEnd>(&link.second); body && option == "-body2")
        return body->body;
    const auto* led = std::get_if<scene::TrajectoryEnd>(&link.second);
    return led && option == "-trajectory" ? Name(led->trajectory) : std::nullopt;
}

Name ofGear(const scene::Gear& gear, const std::string& option) {
    const std::size_t term = option == "-joint1" ? 0 : option == "-joint2" ? 1 : gear.terms.size();
    return term < gear.terms.size() ? Name(gear.terms[term].joint) : std::nullopt;
}

// Of a joint or a contact.
template <class Pair> Name ofPair(const Pair& pair, const std::string& option) {
    return option == "-body1" ? Name(pair.body1) : option == "-body2" ? pair.body2 : Name();
}

} // namespace

std::optional<std::string> namedBy(const scene::Scene& scene, const Element& element,
                                   const std::string& option) {
    switch (element.kind) {
    case Kind::body:
        return option == "-shape" ? Name(scene.bodies[element.index].shape) : std::nullopt;
    case Kind::force: {
        const scene::Force& force = scene.forces[element.index];
        const auto* path = std::get_if<scene::TrajectoryForce>(&force.kind);
        return option == "-body"                 ? Name(force.body)
               : path && option == "-trajectory" ? Name(path->trajectory)
                                                 : std::nullopt;
    }
    case Kind::link:
        return ofEnd(scene.links[element.index], option);
    case Kind::joint:
        return ofPair(scene.joints[element.index], option);
    case Kind::contact:
        return ofPair(scene.contacts[element.index], option);
    case Kind::gear:
        return ofGear(scene.gears[element.index], option);
    default:
        return std::nullopt;
    }
}

} // namespace editing
