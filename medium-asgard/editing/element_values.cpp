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

} // namespace editing
