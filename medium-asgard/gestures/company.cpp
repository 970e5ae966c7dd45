#include "gestures/company.h"

#include <algorithm>

namespace gestures {

Company::Company(const scene::Scene& scene, const std::vector<std::size_t>& bodies) {
    const auto isIn = [&](std::size_t body) {
        return std::ranges::find(bodies_, body) != bodies_.end();
    };
    for (const std::size_t body : bodies) {
        if (isIn(body))
            continue;
        const scene::Body& one = scene.bodies[body];
        bodies_.push_back(body);
        auto joined = Joined::of(scene, body, one.initialPosition);
        if (!joined) {
            alone_.push_back(body);
            poses_.push_back({one.initialPosition, one.initialAttitude});
            continue;
        }
        for (const std::size_t other : joined->bodies())
            if (!isIn(other))
                bodies_.push_back(other);
        joined_.push_back(std::move(joined));
    }
    for (const auto& one : joined_)
        one->moveWith(bodies_);
}

void Company::moveAll(const geometry::Vector& way) {
    way_ = way;
    for (const auto& one : joined_)
        one->moveAll(way);
}

std::vector<editing::Wish> Company::wishes(const editing::Mapper& mapper) const {
    std::vector<editing::Wish> wishes;
    for (std::size_t i = 0; i < alone_.size(); ++i)
        std::ranges::move(
            editing::wishesOf(mapper, {alone_[i], {poses_[i].position + way_, poses_[i].attitude}}),
            std::back_inserter(wishes));
    for (const auto& one : joined_)
        std::ranges::move(one->wishes(mapper), std::back_inserter(wishes));
    return wishes;
}

} // namespace gestures
