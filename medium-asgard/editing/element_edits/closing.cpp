#include "element_edits/closing.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace editing {
namespace {

using geometry::Quaternion;
using geometry::Vector;

std::vector<double> listOf(const Vector& v) { return {v.x(), v.y(), v.z()}; }

// As an author writes them: to 14 digits of the largest.
std::vector<double> rounded(std::vector<double> values) {
    double largest = 0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    if (!(largest > 0))
        return values;
    const int decimals = std::max(0, 13 - static_cast<int>(std::floor(std::log10(largest))));
    for (double& value : values) {
        char text[400];
        std::snprintf(text, sizeof text, "%.*f", decimals, value);
        value = std::strtod(text, nullptr) + 0.0; // no -0
    }
    return values;
}

// Values that rounding alone tells from those that are there are these.
std::vector<double> unchanged(std::vector<double> values, const std::vector<double>& now) {
    const double largest =
        std::abs(*std::ranges::max_element(now, {}, [](double value) { return std::abs(value); }));
    for (std::size_t i = 0; i < values.size(); ++i)
        if (std::abs(values[i] - now[i]) <= 1e-12 * largest)
            values[i] = now[i];
    return values;
}

Wish vectorOf(std::size_t body, const char* option, const Vector& value, const Vector& now) {
    return {.element = {Kind::body, body},
            .option = option,
            .path = {},
            .values = unchanged(rounded(listOf(value)), listOf(now)),
            .absent = {0, 0, 0},
            .now = listOf(now),
            .offers = false};
}

Wish rotationOf(const Mapper& mapper, std::size_t body, const Quaternion& attitude) {
    Wish wish{.element = {Kind::body, body},
              .option = "-init_rot",
              .path = {},
              .values = {},
              .absent = {0, 0, 0},
              .offers = false};
    const Eigen::AngleAxisd turn(attitude);
    wish.values = listOf(turn.angle() * turn.axis());
    if (mapper.count(wish) == 4) {
        wish.absent = {1, 0, 0, 0};
        wish.values = {attitude.w(), attitude.x(), attitude.y(), attitude.z()};
    }
    wish.values = rounded(wish.values);
    return wish;
}

} // namespace

std::vector<Wish> wishesOf(const Mapper& mapper, const NewPlace& place) {
    const scene::Body& body = mapper.scene().bodies[place.body];
    std::vector<Wish> wishes{
        vectorOf(place.body, "-init_pos", place.pose.position, body.initialPosition)};
    if (place.turns)
        wishes.push_back(rotationOf(mapper, place.body, place.pose.attitude));
    if (place.velocity) {
        wishes.push_back(
            vectorOf(place.body, "-init_dpos", place.velocity->linear, body.initialVelocity));
        wishes.push_back(vectorOf(place.body, "-init_drot", place.velocity->angular,
                                  body.initialAngularVelocity));
    }
    return wishes;
}

Closing closingEdits(const Mapper& mapper, const scene::Scene& scene,
                     const std::vector<NewPlace>& places) {
    Closing closing;
    for (const NewPlace& place : places) {
        const Answer answer = mapper.answer(wishesOf(mapper, place));
        if (!answer.possible())
            return {{}, answer.reason, answer.cause};
        for (const text::Edit& edit : answer.edits)
            if (!text::join(closing.edits, edit))
                return {{},
                        "the place of body \"" + scene.bodies[place.body].name +
                            "\" comes from numbers that place another body, too",
                        scene.bodies[place.body].source.command};
    }
    text::putInOrder(closing.edits);
    return closing;
}

} // namespace editing
