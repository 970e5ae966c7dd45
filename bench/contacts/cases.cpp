#include "cases.h"

#include "case_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <utility>

namespace bench::contacts {

Place turned(double angle, const Place& direction) {
    const auto [x, y, z] = direction;
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * x + s * y, c * y - s * x, z};
}

Place inBody(const Body& body, const Place& place) {
    return turned(body.angle,
                  {place[0] - body.at[0], place[1] - body.at[1], place[2] - body.at[2]});
}

std::vector<Place> Body::balls() const {
    if (shape == Shape::box)
        return {};
    if (shape == Shape::ball)
        return {{0, 0, 0}};
    if (shape == Shape::capsule)
        return {{0, -size[1] / 2, 0}, {0, size[1] / 2, 0}};
    std::vector<Place> centres;
    for (const double side : {-size[2], size[2]})
        for (int i = 0; i < feet; ++i) { // the first one straight below
            const double angle = (2.0 * i / feet - 0.5) * std::numbers::pi;
            centres.push_back({size[1] * std::cos(angle), size[1] * std::sin(angle), side});
        }
    return centres;
}

Place Body::inertia() const {
    if (moments)
        return *moments;
    const double ball = 0.4 * size[0] * size[0];
    if (shape == Shape::ball)
        return {mass * ball, mass * ball, mass * ball};
    if (shape == Shape::feet) {
        const double ring = size[1] * size[1], across = size[2] * size[2];
        const double tilting = mass * (ball + ring / 2 + across);
        return {tilting, tilting, mass * (ball + ring)};
    }
    const auto of = [&](double a, double b) { return mass / 12 * (a * a + b * b); };
    return {of(size[1], size[2]), of(size[0], size[2]), of(size[0], size[1])};
}

bool Case::needs(Feature feature) const {
    const auto anyJoint = [&](auto&& has) { return std::ranges::any_of(joints, has); };
    switch (feature) {
    case Feature::boxOnBox:
        return collide && std::ranges::count(bodies, Body::Shape::box, &Body::shape) > 1;
    case Feature::rebound:
        return collide && restitution > 0;
    case Feature::stop:
        return anyJoint([](const Joint& joint) { return joint.least.has_value(); });
    case Feature::heldSpeed:
        return anyJoint([](const Joint& joint) { return joint.speed.has_value(); });
    case Feature::dryCouple:
        return anyJoint([](const Joint& joint) { return joint.dryCouple != 0; });
    }
    return false;
}

std::vector<Case> allCases(bool few) {
    std::vector<Case> all;
    for (std::vector<Case>& group :
         std::array{contactCases(), jointCases(), machineCases(), boxCases(few), chainCases(few)})
        std::ranges::move(group, std::back_inserter(all));
    return all;
}

double worstDistance(const Case& scene, const std::vector<std::vector<Place>>& places) {
    if (places.size() != scene.right.size())
        return std::numeric_limits<double>::quiet_NaN();
    double worst = 0;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            const Place &is = places[i][b], &should = scene.right[i][b];
            const double d = std::hypot(is[0] - should[0], is[1] - should[1], is[2] - should[2]);
            if (!(d <= worst)) // what is not a number stays
                worst = d;
        }
    return worst;
}

} // namespace bench::contacts
