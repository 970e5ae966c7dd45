#include "service/offered_values.h"

#include "ipc/bounds.h"
#include "scene/joint_types.h"
#include "scene/names.h"

#include <algorithm>

namespace service {

namespace {

constexpr std::size_t most = ipc::mostOffers.most;

void add(ipc::ValueOffers& offers, ipc::ValueOffer offer) {
    const bool isKnown = std::ranges::any_of(offers.items, [&](const ipc::ValueOffer& other) {
        return other.expression == offer.expression;
    });
    if (!isKnown && offers.items.size() < most &&
        offer.expression.size() <= ipc::longestExpression.most)
        offers.items.push_back(std::move(offer));
}

void addBody(ipc::ValueOffers& offers, const std::string& name) {
    for (const std::string axis : {"x", "y", "z"})
        add(offers, {name + "." + axis, name + ": position " + axis, ""});
    for (const std::string axis : {"x", "y", "z"})
        add(offers, {name + ".d" + axis, name + ": velocity " + axis, ""});
    const std::string sum = name + ".dx^2 + " + name + ".dy^2 + " + name + ".dz^2"; // of squares
    add(offers, {"sqrt(" + sum + ")", name + ": speed", ""});
    add(offers, {name + ".mass/2*(" + sum + ")", name + ": kinetic energy without spin", ""});
}

// Each coordinate with its rate, and what the joint does to its body.
void addJoint(ipc::ValueOffers& offers, const scene::Joint& joint) {
    const std::string& name = joint.name;
    const auto& kinds = scene::traitsOf(joint.type).coordinates;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const bool isAngle = kinds[i] == scene::CoordinateKind::angle;
        const std::string suffix = scene::coordinateSuffix(joint.type, i);
        const std::string which = suffix.empty() ? "" : " " + suffix;
        add(offers, {name + ".q" + suffix, name + (isAngle ? ": angle" : ": length") + which, ""});
        add(offers, {name + ".dq" + suffix,
                     name + (isAngle ? ": angular velocity" : ": velocity") + which, ""});
    }
    for (const std::string axis : {"x", "y", "z"})
        add(offers, {name + ".f" + axis, name + ": force " + axis, ""});
    for (const std::string axis : {"x", "y", "z"})
        add(offers, {name + ".t" + axis, name + ": couple " + axis, ""});
}

void addRope(ipc::ValueOffers& offers, const scene::Rope& rope) {
    add(offers, {rope.name + ".length", rope.name + ": length", ""});
    const std::size_t spans = scene::spansOf(rope);
    for (std::size_t i = 1; i <= spans; ++i) {
        const std::string which = spans > 1 ? std::to_string(i) : "";
        add(offers, {rope.name + ".tension" + which,
                     rope.name + ": tension" + (which.empty() ? "" : " " + which), ""});
    }
}

void addContact(ipc::ValueOffers& offers, const std::string& name) {
    add(offers, {name + ".n", name + ": normal force", ""});
    for (const std::string axis : {"x", "y", "z"})
        add(offers, {name + ".f" + axis, name + ": force " + axis, ""});
    add(offers, {name + ".slip", name + ": speed of slipping", ""});
    add(offers, {name + ".state", name + ": 0 open, 1 sticks, 2 slips", ""});
}

} // namespace

ipc::ValueOffers offeredValues(const scene::Scene& scene) {
    ipc::ValueOffers offers;
    for (const scene::Plot& plot : scene.plots)
        for (std::size_t i = 0; i < plot.values.size(); ++i) {
            const scene::Expression& text = plot.values[i];
            const bool isNamed = i < plot.labels.size() && !plot.labels[i].empty();
            add(offers, {text, isNamed ? plot.labels[i] : text, ""});
        }
    for (const scene::Parameter& parameter : scene.parameters)
        add(offers, {parameter.name, parameter.label.empty() ? parameter.name : parameter.label,
                     parameter.unit});
    std::size_t bodies = 0;
    for (const scene::Body& body : scene.bodies)
        if (!body.fixed && ++bodies <= mostBodiesOffered)
            addBody(offers, body.name);
    for (std::size_t i = 0; i < scene.joints.size() && i < mostBodiesOffered; ++i)
        addJoint(offers, scene.joints[i]);
    for (std::size_t i = 0; i < scene.ropes.size() && i < mostBodiesOffered; ++i)
        addRope(offers, scene.ropes[i]);
    for (std::size_t i = 0; i < scene.contacts.size() && i < mostBodiesOffered; ++i)
        if (!scene.contacts[i].name.empty())
            addContact(offers, scene.contacts[i].name);
    add(offers, {"t", "time", ""});
    add(offers, {"scene.energy", "energy of all bodies", ""});
    return offers;
}

} // namespace service
