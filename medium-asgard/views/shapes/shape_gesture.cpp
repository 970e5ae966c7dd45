#include "shapes/shape_gesture.h"

#include "editing/number_text.h"
#include "point_edits/shape_points.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

using geometry::Vector;

ShapeGesture::ShapeGesture(SceneDocument& document, std::size_t shapeSet)
    : document_(document), text_(document.text()), since_(document.revision()),
      scene_(document.shown().scene), shapeSet_(shapeSet),
      before_(editing::draftOf(scene_->shapeSets[shapeSet])) {}

bool ShapeGesture::show(const std::vector<editing::DraftPart>& draft) {
    if (!document_.mayGoOn(since_)) {
        answer_ = {};
        answer_.reason = SceneDocument::overtaken().toStdString();
        return false;
    }
    answer_ = editing::become(text_, scene_, shapeSet_, draft);
    if (answer_.possible())
        document_.preview(text::applied(text_, answer_.edits), since_, this);
    return answer_.possible();
}

void ShapeGesture::finish(const QString& label) {
    document_.finishPreview(answer_.possible() ? text::applied(text_, answer_.edits) : text_, label,
                            since_, this);
}

void ShapeGesture::cancel() { document_.finishPreview(text_, {}, since_, this); }

double decimal(double value, double length) {
    return editing::roundedTo(value, editing::decimalStep(length)) + 0.0; // and no -0
}

Vector decimal(const Vector& value, double length) {
    return value.unaryExpr([length](double x) { return decimal(x, length); });
}

scene::Part tidied(const scene::Part& before, scene::Part after, double length) {
    // A box that grows at a corner moves by half of that.
    const double half = length / 10;
    if (after.position != before.position)
        after.position = decimal(after.position, half);
    const auto* oldSphere = std::get_if<scene::SphereShape>(&before.shape);
    if (auto* sphere = std::get_if<scene::SphereShape>(&after.shape)) {
        if (!oldSphere || sphere->radius != oldSphere->radius)
            sphere->radius =
                std::max(decimal(sphere->radius, length), editing::decimalStep(length));
    } else if (auto* box = std::get_if<scene::BoxShape>(&after.shape)) {
        const auto* old = std::get_if<scene::BoxShape>(&before.shape);
        for (int k = 0; k < 3; ++k)
            if (!old || box->edges[k] != old->edges[k])
                box->edges[k] = std::max(decimal(box->edges[k], half), editing::decimalStep(half));
    } else if (!std::holds_alternative<scene::HullShape>(after.shape)) {
        const std::vector<double> old = editing::sizesOf(before);
        std::vector<double> sizes = editing::sizesOf(after);
        for (std::size_t i = 0; i < sizes.size(); ++i)
            if (i >= old.size() || sizes[i] != old[i])
                sizes[i] = std::max(decimal(sizes[i], length), editing::decimalStep(length));
        after = editing::withSizes(after, sizes);
    } else if (auto* hull = std::get_if<scene::HullShape>(&after.shape)) {
        const auto* old = std::get_if<scene::HullShape>(&before.shape);
        const bool turned = after.rotation != Vector::Zero();
        for (std::size_t i = 0; i < hull->points.size(); ++i)
            if (!old || i >= old->points.size() || hull->points[i] != old->points[i])
                hull->points[i] = decimal(hull->points[i], turned ? half : length);
    }
    return after;
}

} // namespace views
