#include "gestures/copies.h"

#include "editing/number_text.h"
#include "framing/extent.h"

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

} // namespace

editing::Pasted pastedBeside(const std::string& text, const scene::Scene& scene,
                             const std::string& commands) {
    editing::Pasted paste =
        editing::pasted(text, scene, commands, besideThem(scene, editing::bodiesOf(commands)));
    const auto isBody = [](const editing::Element& one) { return one.kind == editing::Kind::body; };
    if (std::ranges::any_of(paste.added, isBody))
        std::erase_if(paste.added, std::not_fn(isBody));
    return paste;
}

} // namespace gestures
