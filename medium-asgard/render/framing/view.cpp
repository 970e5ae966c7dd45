#include "framing/view.h"

#include "framing/framing.h"
#include "simulation/simulation.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

// A number or three of a view: written out, or the values of expressions from `first` on.
struct Bound {
    bool given = false;
    Vector constant = Vector::Zero();
    std::optional<std::size_t> first;
};

} // namespace

struct SceneView::Implementation {
    Extent framed; // as it was given
    Extent extent;
    Size size;
    std::vector<std::string> expressions;
    std::vector<std::string> faults;
    std::optional<simulation::Quantities> quantities;
    Bound position, rotation, center, scale, eye, look, up;

    Bound bind(const std::optional<scene::VectorValue>& value);
    Bound bindNumber(const std::optional<scene::ScalarValue>& value);
    void bindAll(const scene::View& view);
    [[nodiscard]] std::optional<Vector> read(const Bound& bound, int count,
                                             const std::vector<double>& values) const;
    [[nodiscard]] Camera fromEye(const std::vector<double>& values) const;
    [[nodiscard]] Camera fromAttitude(const std::vector<double>& values) const;
};

Bound SceneView::Implementation::bind(const std::optional<scene::VectorValue>& value) {
    Bound bound;
    if (!value)
        return bound;
    bound.given = true;
    if (const auto* numbers = std::get_if<Vector>(&*value)) {
        bound.constant = *numbers;
        return bound;
    }
    bound.first = expressions.size();
    if (const auto* formulas = std::get_if<std::array<scene::Expression, 3>>(&*value))
        expressions.insert(expressions.end(), formulas->begin(), formulas->end());
    else if (const auto* trajectory = std::get_if<std::string>(&*value))
        for (const char* component : {".x", ".y", ".z"})
            expressions.push_back(*trajectory + component);
    return bound;
}

Bound SceneView::Implementation::bindNumber(const std::optional<scene::ScalarValue>& value) {
    Bound bound;
    if (!value)
        return bound;
    bound.given = true;
    if (const auto* number = std::get_if<double>(&*value)) {
        bound.constant.x() = *number;
    } else {
        bound.first = expressions.size();
        expressions.push_back(std::get<scene::Expression>(*value));
    }
    return bound;
}

void SceneView::Implementation::bindAll(const scene::View& view) {
    position = bind(view.position);
    rotation = bind(view.rotation);
    center = bind(view.center);
    scale = bindNumber(view.scale);
    eye = bind(view.eye);
    look = bind(view.look);
    up = bind(view.up);
    // While the scene turns, the scale that is not given must not breathe: the whole box, seen
    // from any side, stays in the picture.
    if (rotation.first)
        extent.balls = {{extent.box.center(), extent.box.sizes().norm() / 2}};
}

// Nothing where the view says nothing, or nothing finite.
std::optional<Vector> SceneView::Implementation::read(const Bound& bound, int count,
                                                      const std::vector<double>& values) const {
    if (!bound.given)
        return std::nullopt;
    Vector result = bound.constant;
    if (bound.first) {
        if (*bound.first + static_cast<std::size_t>(count) > values.size())
            return std::nullopt;
        for (int i = 0; i < count; ++i)
            result[i] = values[*bound.first + static_cast<std::size_t>(i)];
    }
    if (!result.allFinite())
        return std::nullopt;
    return result;
}

Camera SceneView::Implementation::fromEye(const std::vector<double>& values) const {
    Camera usual = fitted(extent, bestAttitude(extent), size);
    const Vector target = read(look, 3, values).value_or(usual.center);
    const Vector away = usual.rotation.conjugate() * Vector(0, 0, eyeDistance / usual.scale);
    const Vector stand = read(eye, 3, values).value_or(target + away);
    const double distance = (stand - target).norm();
    if (distance == 0)
        return usual;
    const Vector upward = read(up, 3, values).value_or(extent.up);
    return {target, facing((stand - target) / distance, upward), eyeDistance / distance,
            read(position, 3, values).value_or(Vector::Zero())};
}

Camera SceneView::Implementation::fromAttitude(const std::vector<double>& values) const {
    const std::optional<Vector> turn = read(rotation, 3, values);
    const Quaternion attitude = turn ? geometry::fromRotationVector(*turn) : bestAttitude(extent);
    const std::optional<Vector> middle = read(center, 3, values);
    Camera camera =
        middle ? fittedAbout(extent, attitude, *middle, size) : fitted(extent, attitude, size);
    if (const auto factor = read(scale, 1, values); factor && factor->x() > 0)
        camera.scale = factor->x();
    camera.position = read(position, 3, values).value_or(Vector::Zero());
    return camera;
}

SceneView::SceneView(const scene::Scene& scene, const simulation::MotionPointer& motion,
                     const std::string& name, Size size, std::optional<Extent> framed)
    : implementation_(std::make_unique<Implementation>()) {
    Implementation& my = *implementation_;
    my.framed = framed ? *std::move(framed) : extentOf(scene, motion.get());
    my.extent = my.framed;
    my.size = size;
    const auto named = std::find_if(scene.views.begin(), scene.views.end(),
                                    [&](const auto& v) { return name.empty() || v.name == name; });
    if (named == scene.views.end())
        return;
    my.bindAll(*named);
    if (motion != nullptr && !my.expressions.empty())
        my.quantities.emplace(scene, simulation::Options{}, motion, my.expressions, my.faults);
}

SceneView::~SceneView() = default;
SceneView::SceneView(SceneView&&) noexcept = default;
SceneView& SceneView::operator=(SceneView&&) noexcept = default;

Camera SceneView::at(double time) const {
    const Implementation& my = *implementation_;
    const std::vector<double> values =
        my.quantities ? my.quantities->at(time) : std::vector<double>{};
    return my.eye.given || my.look.given ? my.fromEye(values) : my.fromAttitude(values);
}

const Extent& SceneView::framed() const { return implementation_->framed; }

bool SceneView::follows() const { return !implementation_->expressions.empty(); }

const std::vector<std::string>& SceneView::faults() const { return implementation_->faults; }

Camera cameraOf(const scene::Scene& scene, const simulation::MotionPointer& motion,
                const std::string& view, double time, Size size) {
    return SceneView(scene, motion, view, size).at(time);
}

} // namespace render
