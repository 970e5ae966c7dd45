#include "handles/vector_values.h"

#include "framing/standing_points.h"

#include <algorithm>
#include <utility>

namespace render {

const VectorTexts* componentsOf(const scene::Force& force) {
    const auto* kind = std::get_if<scene::ComponentForce>(&force.kind);
    return kind ? &kind->components : nullptr;
}

VectorTexts valuesOf(const std::string& trajectory) {
    return {trajectory + ".x", trajectory + ".y", trajectory + ".z"};
}

std::optional<Vector> VectorValues::constant(const VectorTexts& texts) {
    Vector value;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [one, isNew] = constants_.try_emplace(texts[i]);
        if (isNew)
            one->second = constantValue(names_, scene_, motion_.get(), texts[i]);
        if (!one->second)
            return std::nullopt;
        value[static_cast<Eigen::Index>(i)] = *one->second;
    }
    return value;
}

void VectorValues::prepare() {
    const auto add = [&](const VectorTexts& texts) {
        changing_.insert(changing_.end(), texts.begin(), texts.end());
    };
    for (const scene::Force& force : scene_.forces) {
        if (const auto* components = componentsOf(force))
            add(*components);
        else if (const auto* path = std::get_if<scene::TrajectoryForce>(&force.kind))
            add(valuesOf(path->trajectory));
    }
    for (const scene::Link& link : scene_.links) {
        if (const auto* point = std::get_if<scene::PointEnd>(&link.second))
            add(point->coordinates);
        else if (const auto* path = std::get_if<scene::TrajectoryEnd>(&link.second))
            add(valuesOf(path->trajectory));
    }
    std::ranges::sort(changing_);
    changing_.erase(std::unique(changing_.begin(), changing_.end()), changing_.end());
    std::vector<std::string> faults;
    quantities_.emplace(scene_, simulation::Options{}, motion_, changing_, faults);
    if (!faults.empty())
        quantities_.reset();
}

std::optional<Vector> VectorValues::at(const VectorTexts& texts, double time) {
    if (auto value = constant(texts))
        return value;
    if (!motion_)
        return std::nullopt;
    if (!std::exchange(isPrepared_, true))
        prepare();
    if (!quantities_)
        return std::nullopt;
    if (time_ != time) {
        time_ = time;
        values_ = quantities_->at(std::clamp(time, motion_->start(), motion_->computed()));
    }
    Vector value;
    for (std::size_t i = 0; i < 3; ++i)
        value[static_cast<Eigen::Index>(i)] = values_[static_cast<std::size_t>(
            std::ranges::lower_bound(changing_, texts[i]) - changing_.begin())];
    return value.allFinite() ? std::optional(value) : std::nullopt;
}

} // namespace render
