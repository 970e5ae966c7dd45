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
    std::string parts;
    for (const Place& at : body.balls())
        parts += std::string(parts.empty() ? "" : " ") + "-sub {" +
                 (any(at) ? "-pos " + list(at) + " " : "") + "-sphere " + number(body.size[0]) +
                 "}";
    return parts;
}

std::string bodyText(const Case& scene, const Body& body) {
    std::string text = "shape_set " + body.name + "_shape -desc {" + partsOf(body) + "}\n";
    text += "body " + body.name + " " + body.name + "_shape -mass " + number(body.mass);
    text += " -init_pos " + list(body.at);
    if (body.angle != 0)
        text += " -init_rot " + list({0, 0, body.angle});
    if (any(body.velocity))
        text += " -init_dpos " + list(body.velocity);
    if (body.spin != 0)
        text += " -init_drot " + list({0, 0, body.spin});
    if (scene.floor)
        text +=
            " -friction " + number(scene.friction) + " -restitution " + number(scene.restitution);
    text += "\n";
    if (scene.gravity != 0)
        text +=
            "force -body " + body.name + " -gravitational " + list({0, -scene.gravity, 0}) + "\n";
    return text;
}

// Where the place lies in the frame of a body that turns about z only.
Place inBody(const Body& body, const Place& place) {
    const double x = place[0] - body.at[0], y = place[1] - body.at[1];
    const double c = std::cos(body.angle), s = std::sin(body.angle);
    return {c * x + s * y, c * y - s * x, place[2] - body.at[2]};
}

std::string jointText(const Case& scene, const Joint& joint, std::size_t index) {
    const Body& body = scene.bodies[static_cast<std::size_t>(joint.body1)];
    const bool slides = joint.type == Joint::Type::slider;
    std::string text = "joint j" + std::to_string(index) + " -type ";
    text += slides ? "slider -axis {1 0 0}" : "hinge";
    text += " -body1 " + body.name + " -offset1 " + list(inBody(body, joint.at));
    if (joint.body2 >= 0)
        text += " -body2 " + scene.bodies[static_cast<std::size_t>(joint.body2)].name;
    if (joint.couple != 0)
        text += " -motor " + number(joint.couple);
    return text + "\n";
}

} // namespace

std::string sceneText(const Case& scene) {
    std::string text = "simulator -finish " + number(scene.times.back());
    text += scene.collide ? "\n" : " -collisions 0\n";
    if (scene.floor) {
        text += "shape_set ground -desc {-sub {-plane}}\nbody floor ground -fixed 1";
        if (scene.slope != 0)
            text += " -init_rot " + list({0, 0, scene.slope});
        text += " -friction " + number(scene.friction) + " -restitution " +
                number(scene.restitution) + "\n";
    }
    for (const Body& body : scene.bodies)
        text += bodyText(scene, body);
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
        text += jointText(scene, scene.joints[i], i);
    return text;
}

} // namespace bench::contacts
