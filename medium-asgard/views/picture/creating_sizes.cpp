// The size of a new body, by the place that is pointed at.
#include "picture/creating.h"

#include "picture/scene_display.h"
#include "scene/shape_of.h"

#include <algorithm>

namespace views {

namespace {

// About a sixth of what the picture shows in its narrower direction, as deep as the place; of one
// behind the eye, in the middle. A metre is taken where that is not far from it.
double timesAt(const gestures::Sight& sight, const Vector& place) {
    const bool isBefore = sight.depth(place) < render::eyeOf(sight.camera);
    const double pixel = sight.pixelLength(isBefore ? place : Vector(sight.camera.center));
    constexpr double usual = 1.0 / 6, near = 1.7;
    const double wanted = usual * pixel * std::min(sight.size.width, sight.size.height);
    return wanted / near <= 1 && 1 <= wanted * near ? 1 : gestures::roundStep(wanted / near);
}

} // namespace

void Creating::fit(const Vector& place) {
    if (!recipe_->sized || !shown_.empty())
        return;
    const double times = timesAt(display_.sight(), place);
    if (times == times_)
        return;
    const auto sized = recipe_->sized;
    recipe_ = sized(times);
    recipe_->sized = sized;
    ghost_ = restingShape(recipe_->ghost);
    times_ = times;
}

// Null: it cannot rest on a body.
gestures::ShapePointer Creating::restingShape(const std::vector<scene::Part>& ghost) {
    const bool isPlane = std::ranges::any_of(ghost, [](const scene::Part& part) {
        return std::holds_alternative<scene::PlaneShape>(part.shape);
    });
    if (ghost.empty() || isPlane)
        return nullptr;
    scene::ShapeSet set;
    set.parts = ghost;
    const auto made = scene::shapeOf(set);
    const auto* shape = std::get_if<geometry::Shape>(&made);
    return shape ? std::make_shared<const geometry::Shape>(*shape) : nullptr;
}

} // namespace views
