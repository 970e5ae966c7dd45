#include "recipes/begun_recipe.h"

#include "gestures/snapping.h"
#include "scene/shape_of.h"

#include <QObject>

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

gestures::ShapePointer restingShape(const std::vector<scene::Part>& ghost) {
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

} // namespace

BegunRecipe::BegunRecipe(Recipe recipe)
    : recipe_(std::move(recipe)), ghost_(restingShape(recipe_.ghost)) {}

const Step& BegunRecipe::step() const {
    return recipe_.steps[std::min(shown_.size(), recipe_.steps.size() - 1)];
}

void BegunRecipe::offerBody(const scene::Scene& scene,
                            const std::vector<editing::Element>& selected) {
    Step& first = recipe_.steps.front();
    if (first.wanted != Wanted::body || !first.otherwise.isEmpty())
        return;
    std::vector<std::size_t> candidates;
    for (const editing::Element& element : selected)
        if (element.kind == editing::Kind::body)
            candidates.push_back(element.index);
    if (candidates.empty() && scene.bodies.size() == 1)
        candidates = {0};
    if (candidates.size() != 1)
        return;
    first.offered = candidates.front();
    first.otherwise = QObject::tr("Return: %1.")
                          .arg(QString::fromStdString(scene.bodies[candidates.front()].name));
}

void BegunRecipe::fit(const gestures::Sight& sight, const Vector& place) {
    if (!recipe_.sized || !shown_.empty())
        return;
    const double times = timesAt(sight, place);
    if (times == times_)
        return;
    const auto sized = recipe_.sized;
    recipe_ = sized(times);
    recipe_.sized = sized;
    ghost_ = restingShape(recipe_.ghost);
    times_ = times;
}

std::optional<Judged> BegunRecipe::judge(const scene::Scene& scene, const Indicated& next) const {
    return step().judge && (next.body || step().wanted != Wanted::body)
               ? std::optional(step().judge(scene, shown_, next))
               : std::nullopt;
}

bool BegunRecipe::take(const Indicated& indicated) {
    const bool repeats = step().repeats;
    shown_.push_back(indicated);
    return !repeats && shown_.size() == recipe_.steps.size();
}

} // namespace views
