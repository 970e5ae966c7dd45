#include "signs/coils.h"

#include "framing/body_places.h"
#include "framing/standing_points.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace render {
namespace {

constexpr int turns = 10;

std::array<std::string, 3> textsOf(const scene::Link& link) {
    if (const auto* point = std::get_if<scene::PointEnd>(&link.second))
        return point->coordinates;
    const std::string& path = std::get<scene::TrajectoryEnd>(link.second).trajectory;
    return {path + ".x", path + ".y", path + ".z"};
}

} // namespace

std::vector<Vector> coilBetween(const Vector& from, const Vector& to, double across,
                                int cornersPerTurn) {
    const Vector way = to - from;
    const double length = way.norm();
    if (!(length > 0))
        return {from, to};
    const double straight = 0.1; // of it, at either end
    const Vector u = way.unitOrthogonal(), v = way.cross(u) / length;
    std::vector<Vector> points{from};
    const int corners = turns * cornersPerTurn;
    for (int i = 0; i <= corners; ++i) {
        const double part = static_cast<double>(i) / corners, angle = 2 * M_PI * turns * part;
        // Narrow at its ends, so that it goes over into the straight pieces.
        const double reach = across * std::min({1.0, turns * part, turns * (1 - part)});
        points.push_back(from + (straight + (1 - 2 * straight) * part) * way +
                         reach * (std::cos(angle) * u + std::sin(angle) * v));
    }
    points.push_back(to);
    return points;
}

std::optional<Vector> Coils::onBody(const scene::BodyEnd& end, const Drawing& drawing) {
    const auto& bodies = drawing.scene->bodies;
    const auto found = std::ranges::find(bodies, end.body, &scene::Body::name);
    if (found == bodies.end())
        return std::nullopt;
    const auto body = static_cast<std::size_t>(found - bodies.begin());
    const bool isKnown = drawing.motion && body < drawing.motion->bodies();
    return poseOf(*drawing.scene, drawing.motion.get(), body, drawing.time)
        .toWorld(end.offset.value_or(isKnown ? drawing.motion->centroid(body) : Vector::Zero()));
}

// The coordinates that change are read together.
void Coils::follow(const Drawing& drawing) {
    std::vector<std::string> texts;
    for (const scene::Link& link : drawing.scene->links) {
        const auto* point = std::get_if<scene::PointEnd>(&link.second);
        if (!link.spring || std::holds_alternative<scene::BodyEnd>(link.second) ||
            (point && standingPoint(*drawing.scene, drawing.motion.get(), *point)))
            continue;
        const auto own = textsOf(link);
        texts.insert(texts.end(), own.begin(), own.end());
    }
    if (drawing.motion && of_.lock() == drawing.motion && texts == texts_)
        return;
    of_ = drawing.motion;
    texts_ = std::move(texts);
    quantities_.reset();
    if (texts_.empty() || !drawing.motion)
        return;
    std::vector<std::string> faults;
    quantities_.emplace(*drawing.scene, simulation::Options{}, drawing.motion, texts_, faults);
}

std::optional<Vector> Coils::valueOf(const std::array<std::string, 3>& texts,
                                     const Drawing& drawing) {
    const auto first = std::search(texts_.begin(), texts_.end(), texts.begin(), texts.end());
    if (!quantities_ || first == texts_.end())
        return std::nullopt;
    const simulation::Motion& motion = *drawing.motion;
    const auto values =
        quantities_->at(std::clamp(drawing.time, motion.start(), motion.computed()));
    const auto at = static_cast<std::size_t>(first - texts_.begin());
    return Vector(values[at], values[at + 1], values[at + 2]);
}

std::optional<Coils::Ends> Coils::endsOf(const scene::Link& spring, const Drawing& drawing) {
    const auto first = onBody(spring.first, drawing);
    std::optional<Vector> second;
    if (const auto* body = std::get_if<scene::BodyEnd>(&spring.second))
        second = onBody(*body, drawing);
    else if (const auto* point = std::get_if<scene::PointEnd>(&spring.second))
        second = standingPoint(*drawing.scene, drawing.motion.get(), *point);
    if (!second && !std::holds_alternative<scene::BodyEnd>(spring.second))
        second = valueOf(textsOf(spring), drawing);
    if (!first || !second || !first->allFinite() || !second->allFinite())
        return std::nullopt;
    return Ends{*first, *second};
}

void Coils::add(Lines& lines, const Drawing& drawing, double sceneSize, const Frame& frame) {
    const auto count = std::ranges::count_if(drawing.scene->links,
                                             [](const scene::Link& l) { return bool(l.spring); });
    if (count == 0)
        return;
    follow(drawing);
    const Ink ink{{0.22F, 0.24F, 0.30F}, 0.95F, frame.stroke(1.5)};
    const int cornersPerTurn = count > 200 ? 4 : 16;
    for (const scene::Link& link : drawing.scene->links) {
        const auto ends = link.spring ? endsOf(link, drawing) : std::nullopt;
        if (!ends)
            continue;
        const double length = (ends->second - ends->first).norm();
        const bool isSlack =
            link.spring->isPullOnly && link.spring->rest && length < *link.spring->rest;
        const std::vector<Vector> points =
            isSlack ? std::vector<Vector>{ends->first, ends->second}
                    : coilBetween(ends->first, ends->second, 0.022 * sceneSize, cornersPerTurn);
        for (std::size_t i = 1; i < points.size(); ++i)
            lines.add(frame.toView(points[i - 1]), frame.toView(points[i]), ink);
    }
}

} // namespace render
