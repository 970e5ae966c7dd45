#include "gestures/copies.h"

#include "editing/number_text.h"
#include "framing/extent.h"
#include "gestures/standing.h"

#include <algorithm>
#include <functional>
#include <limits>

namespace gestures {

namespace {

// A little more than the bodies of the scene with those names are wide together, along x.
geometry::Vector besideThem(const scene::Scene& scene, const std::set<std::string>& names) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const scene::Body& body : scene.bodies) {
        if (!names.contains(body.name))
            continue;
        for (const render::Ball& ball : render::outlineOf(scene, body)) {
            const double x = (body.initialPosition + body.initialAttitude * ball.center).x();
            least = std::min(least, x - ball.radius);
            most = std::max(most, x + ball.radius);
        }
    }
    const double width = std::max(0.0, most - least);
    const double step = editing::decimalStep(width);
    return {width > 0 ? editing::roundedTo(1.1 * width, step / 10) : 1, 0, 0};
}

// LIMIT: one whose shape comes with it counts as a small ball.
bool isInsideOfAny(const scene::Scene& scene, const editing::CopiedBody& body) {
    scene::Scene alone;
    alone.shapeSets.push_back(body.shape ? *body.shape : scene::ShapeSet());
    scene::ShapeSet& set = alone.shapeSets.front();
    if (set.parts.empty())
        set.parts.emplace_back().shape = scene::SphereShape{1e-3};
    alone.bodies.emplace_back().shape = set.name;
    const ShapePointer shape = shapeOf(alone, alone.bodies.front().name);
    return shape && isInsideOfOthers(scene, *shape, body.pose, scene.bodies.size());
}

} // namespace

editing::Pasted pastedBeside(const std::string& text, const scene::Scene& scene,
                             const std::string& commands) {
    const auto meets = [&](const std::vector<editing::CopiedBody>& bodies) {
        return std::ranges::any_of(
            bodies, [&](const editing::CopiedBody& body) { return isInsideOfAny(scene, body); });
    };
    editing::Pasted paste = editing::pasted(text, scene, commands,
                                            besideThem(scene, editing::bodiesOf(commands)), meets);
    const auto isBody = [](const editing::Element& one) { return one.kind == editing::Kind::body; };
    if (std::ranges::any_of(paste.added, isBody))
        std::erase_if(paste.added, std::not_fn(isBody));
    return paste;
}

} // namespace gestures
