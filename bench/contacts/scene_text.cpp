#include "scene_text.h"

#include <charconv>
#include <cmath>

namespace bench::contacts {
namespace {

std::string number(double value) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, value).ptr}; // the shortest that is exact
}

std::string list(const Place& place) {
    return "{" + number(place[0]) + " " + number(place[1]) + " " + number(place[2]) + "}";
}

bool any(const Place& place) { return place[0] != 0 || place[1] != 0 || place[2] != 0; }

std::string partsOf(const Body& body) {
    if (body.shape == Body::Shape::box)
        return "-sub {-box " + list(body.size) + "}";
    if (body.shape == Body::Shape::capsule)
        return "-sub {-capsule {" + number(body.size[0]) + " " + number(body.size[1]) + "}}";
    std::string parts;
    for (const Place& at : body.balls())
        parts += std::string(parts.empty() ? "" : " ") + "-sub {" +
                 (any(at) ? "-pos " + list(at) + " " : "") + "-sphere " + number(body.size[0]) +
                 "}";
    return parts;
}

std::string surface(const Case& scene, double friction) {
    return (friction > 0 ? " -friction " + number(friction) : std::string()) + " -restitution " +
           number(scene.restitution);
}

// Whether planes have a friction that does not follow from the bodies' own.
bool ownFriction(const Case& scene) {
    return scene.planeFriction > 0 && scene.planeFriction != scene.friction;
}

std::string planeText(const Case& scene, const Plane& plane) {
    std::string text = "body " + plane.name + " ground -fixed 1";
    if (plane.slope != 0)
        text += " -init_rot " + list({0, 0, plane.slope});
    return text + surface(scene, ownFriction(scene) ? 0 : scene.planeFriction) + "\n";
}

std::string pairText(const Case& scene) {
    std::string text;
    if (ownFriction(scene))
        for (const Plane& plane : scene.planes)
            for (const Body& body : scene.bodies)
                text += "contact -body1 " + body.name + " -body2 " + plane.name + " -friction " +
                        number(scene.planeFriction) + "\n";
    return text;
}

std::string bodyText(const Case& scene, const Body& body) {
    std::string text = "shape_set " + body.name + "_shape -desc {" + partsOf(body) + "}\n";
    text += "body " + body.name + " " + body.name + "_shape -mass " + number(body.mass);
    if (body.moments)
        text += " -inertia " + list(*body.moments);
    text += " -init_pos " + list(body.at);
    if (body.angle != 0)
        text += " -init_rot " + list({0, 0, body.angle});
    if (any(body.velocity))
        text += " -init_dpos " + list(body.velocity);
    if (body.spin != 0)
        text += " -init_drot " + list({0, 0, body.spin});
    if (!scene.planes.empty())
        text += surface(scene, scene.friction);
    text += "\n";
    if (scene.gravity != 0)
        text +=
            "force -body " + body.name + " -gravitational " + list({0, -scene.gravity, 0}) + "\n";
    return text;
}

std::string jointText(const Case& scene, const Joint& joint, std::size_t index) {
    const Body& body = scene.bodies[static_cast<std::size_t>(joint.body1)];
    const Place axis = turned(body.angle, joint.axis);
    std::string text = "joint j" + std::to_string(index) + " -type ";
    text += joint.type == Joint::Type::slider ? "slider" : "hinge";
    if (joint.type == Joint::Type::slider || axis != Place{0, 0, 1}) // by default a hinge's is z
        text += " -axis " + list(axis);
    text += " -body1 " + body.name + " -offset1 " + list(inBody(body, joint.at));
    if (joint.body2 >= 0)
        text += " -body2 " + scene.bodies[static_cast<std::size_t>(joint.body2)].name;
    if (joint.couple != 0)
        text += " -motor " + number(joint.couple);
    if (joint.speed)
        text += " -speed " + number(*joint.speed);
    if (joint.least)
        text += " -limits {" + number(*joint.least) + " {}} -limit_restitution " +
                number(scene.restitution);
    if (joint.stiffness != 0)
        text += " -stiffness " + number(joint.stiffness) + " -rest " + number(joint.rest);
    if (joint.dryCouple != 0)
        text += " -friction " + number(joint.dryCouple);
    return text + "\n";
}

} // namespace

std::string sceneText(const Case& scene) {
    std::string text = "simulator -finish " + number(scene.times.back());
    text += scene.collide ? "\n" : " -collisions 0\n";
    if (!scene.planes.empty())
        text += "shape_set ground -desc {-sub {-plane}}\n";
    for (const Plane& plane : scene.planes)
        text += planeText(scene, plane);
    for (const Body& body : scene.bodies)
        text += bodyText(scene, body);
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        text += jointText(scene, scene.joints[i], i);
    return text + pairText(scene);
}

} // namespace bench::contacts
