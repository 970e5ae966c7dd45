#include "commands/proposal.h"

#include "framing/extent.h"
#include "scene/joint_types.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace commands {

using editing::Element, editing::Kind;

namespace {

template <class All> Element named(Kind kind, const All& all, const std::string& name) {
    const auto found = std::ranges::find_if(all, [&](const auto& one) { return one.name == name; });
    return {kind, static_cast<std::size_t>(found - all.begin())};
}

// The body or joint on which the element acts, or the element itself.
Element meantBy(const scene::Scene& scene, const Element& element) {
    switch (element.kind) {
    case Kind::force:
        return named(Kind::body, scene.bodies, scene.forces[element.index].body);
    case Kind::constraint:
        return named(Kind::body, scene.bodies, scene.constraints[element.index].body);
    case Kind::shapeSet: {
        const auto has = [&](const scene::Body& body) {
            return body.shape == scene.shapeSets[element.index].name && !body.fixed;
        };
        const auto found = std::ranges::find_if(scene.bodies, has);
        return {Kind::body, static_cast<std::size_t>(found - scene.bodies.begin())};
    }
    case Kind::gear: {
        const auto& terms = scene.gears[element.index].terms;
        return terms.empty() ? element : named(Kind::joint, scene.joints, terms.front().joint);
    }
    default:
        return element;
    }
}

bool isGround(const scene::Scene& scene, const std::string& name) {
    const scene::Body* body = scene::findBody(scene, name);
    return body && body->fixed;
}

// The joint by whose one coordinate the body moves; none: it moves in more ways.
std::optional<Element> jointOfOneWay(const scene::Scene& scene, const std::string& body) {
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const scene::Joint& joint = scene.joints[i];
        const bool isHeld = joint.body1 == body
                                ? !joint.body2 || isGround(scene, *joint.body2)
                                : joint.body2 == body && isGround(scene, joint.body1);
        if (isHeld && scene::traitsOf(joint.type).coordinates.size() == 1)
            return Element{Kind::joint, i};
    }
    return std::nullopt;
}

// The axis along which it moves farthest; the upright one unless another has clearly more.
Eigen::Index wayOf(const scene::Scene& scene, const simulation::Motion* motion, std::size_t body) {
    Eigen::Index upright = 0;
    render::upOf(scene).cwiseAbs().maxCoeff(&upright);
    if (!motion || body >= motion->bodies())
        return upright;
    constexpr int samples = 200;
    Eigen::AlignedBox3d box;
    for (int i = 0; i <= samples; ++i)
        box.extend(
            motion->at(body, motion->start() + (motion->computed() - motion->start()) * i / samples)
                .position);
    Eigen::Index farthest = 0;
    const double most = box.sizes().maxCoeff(&farthest);
    constexpr double clearly = 1.05;
    return std::isfinite(most) && most > clearly * box.sizes()[upright] ? farthest : upright;
}

} // namespace

std::optional<Proposal> proposalOf(const scene::Scene& scene, const simulation::Motion* motion,
                                   const std::vector<Measured>& offered,
                                   const std::optional<Element>& about) {
    const auto placeOf = [&](const Element& element) {
        return static_cast<std::size_t>(std::ranges::find(offered, element, &Measured::element) -
                                        offered.begin());
    };
    if (offered.empty())
        return std::nullopt;
    std::size_t place = about ? placeOf(meantBy(scene, *about)) : offered.size();
    if (place == offered.size())
        place = 0;
    const Element element = offered[place].element;
    if (element.kind != Kind::body)
        return Proposal{place, 0};
    if (const auto joint = jointOfOneWay(scene, scene.bodies[element.index].name))
        if (const std::size_t of = placeOf(*joint); of < offered.size())
            return Proposal{of, 0};
    return Proposal{place, static_cast<std::size_t>(wayOf(scene, motion, element.index))};
}

} // namespace commands
