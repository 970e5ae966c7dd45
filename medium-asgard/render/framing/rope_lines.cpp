#include "framing/rope_lines.h"

#include "framing/body_places.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

namespace render {
namespace {

constexpr double straight = 1e-9; // of the sine of a turn
constexpr double slack = 1e-6;    // of the length
constexpr double bend = 0.15;     // radians between two corners of an arc

struct Place {
    Vector at = Vector::Zero(), axis = Vector::UnitZ();
    double radius = 0; // signed: positive where the centre lies to the left of the rope
};

class Route {
public:
    Route(const scene::Rope& rope, std::vector<Place> places)
        : rope_(rope), places_(std::move(places)) {}

    // As the path by the centres turns: once, at the start.
    [[nodiscard]] std::vector<double> orientedRadii() const {
        std::vector<double> radii;
        const std::size_t count = places_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Place& place = places_[i];
            radii.push_back(place.radius);
            if (place.radius == 0 || isEnd(i))
                continue;
            const Vector before = (place.at - places_[(i + count - 1) % count].at).normalized(),
                         after = (places_[(i + 1) % count].at - place.at).normalized();
            const double turn = place.axis.dot(before.cross(after));
            if (std::abs(turn) > straight && turn < 0)
                radii.back() = -radii.back();
        }
        return radii;
    }
    [[nodiscard]] bool hasDrum() const {
        return !rope_.isClosed && (places_.front().radius != 0 || places_.back().radius != 0);
    }

    // The corners; of its longest span the first one, and what it measures.
    struct Line {
        std::vector<Vector> corners;
        std::size_t longest = 0;
        double length = 0;
    };
    // `isOff`: off the wheels between points round which it would go the long way.
    [[nodiscard]] Line line(bool isOff = false) const {
        Line line;
        const std::size_t count = places_.size(), spans = rope_.isClosed ? count : count - 1;
        std::vector<Span> all;
        for (std::size_t i = 0; i < spans; ++i)
            all.push_back(spanOf(places_[i], places_[(i + 1) % count]));
        std::vector<bool> offs(count, false);
        for (std::size_t i = 1; isOff && !rope_.isClosed && i + 1 < count; ++i) {
            const Vector &before = all[i - 1].direction, &after = all[i].direction;
            const double turn = places_[i].radius * places_[i].axis.dot(before.cross(after));
            offs[i] = turn < 0 && places_[i - 1].radius == 0 && places_[i + 1].radius == 0;
        }
        if (!rope_.isClosed)
            addWound(line, places_.front(), all.front().direction);
        double longest = -1;
        for (std::size_t i = 0; i < spans; ++i) {
            if (offs[i])
                continue;
            if (offs[(i + 1) % count])
                all[i].to = all[i + 1].to;
            const double free = (all[i].to - all[i].from).norm();
            line.corners.push_back(all[i].from);
            if (free > longest) {
                longest = free;
                line.longest = line.corners.size() - 1;
            }
            line.length += free;
            line.corners.push_back(all[i].to);
            const std::size_t next = (i + 1) % count;
            if ((i + 1 < spans || rope_.isClosed) && !offs[next])
                line.length +=
                    addArc(line, places_[next], all[i].direction, all[(i + 1) % spans].direction);
        }
        if (!rope_.isClosed)
            addWound(line, places_.back(), all.back().direction);
        return line;
    }

private:
    struct Span {
        Vector from, to, direction;
    };
    [[nodiscard]] bool isEnd(std::size_t i) const {
        return !rope_.isClosed && (i == 0 || i + 1 == places_.size());
    }
    // physics/rope_paths.h has the derivation.
    static Span spanOf(const Place& a, const Place& b) {
        const Vector d = b.at - a.at, axis = a.radius != 0 ? a.axis : b.axis;
        const double sense = a.axis.dot(b.axis) < 0 ? -1 : 1;
        const double first = a.radius != 0 ? a.radius : 0,
                     second = a.radius != 0 ? sense * b.radius : b.radius;
        const double off = second - first, square = d.squaredNorm();
        const double l = std::sqrt(std::max(0.0, square - off * off));
        if (!(square > 0))
            return {a.at, b.at, Vector::UnitX()};
        const Vector u = (l * d - off * axis.cross(d)) / square, left = axis.cross(u);
        return {a.at - first * left, b.at - second * left, u};
    }
    // From one direction of the rope to the other; answers with its length.
    static double addArc(Line& line, const Place& wheel, const Vector& before,
                         const Vector& after) {
        if (wheel.radius == 0)
            return 0;
        double angle = std::atan2(wheel.axis.dot(before.cross(after)), before.dot(after));
        const double side = wheel.radius < 0 ? -1 : 1;
        if (side * angle < -straight)
            angle += side * 2 * std::numbers::pi;
        addTurn(line, wheel, before, angle);
        return std::abs(wheel.radius * angle);
    }
    static void addTurn(Line& line, const Place& wheel, const Vector& before, double angle) {
        const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / bend)));
        for (int i = 1; i < parts; ++i) {
            const Vector u = Eigen::AngleAxisd(angle * i / parts, wheel.axis) * before;
            line.corners.push_back(wheel.at - wheel.radius * wheel.axis.cross(u));
        }
    }
    // One turn on a drum.
    static void addWound(Line& line, const Place& drum, const Vector& direction) {
        if (drum.radius != 0)
            addTurn(line, drum, direction, 2 * std::numbers::pi);
    }

    const scene::Rope& rope_;
    std::vector<Place> places_;
};

// Hangs in the longest span; for a shallow parabola over c, 8 h^2 / 3 c is what is longer.
void sag(Route::Line& line, double longer, const Vector& up) {
    constexpr int parts = 24;
    const Vector from = line.corners[line.longest], to = line.corners[line.longest + 1];
    const double across = (to - from).norm() + longer / 2;
    const double depth = std::sqrt(3.0 / 8 * longer * across);
    std::vector<Vector> hanging;
    for (int i = 1; i < parts; ++i) {
        const double s = static_cast<double>(i) / parts;
        hanging.push_back(from + s * (to - from) - 4 * depth * s * (1 - s) * up);
    }
    line.corners.insert(line.corners.begin() + static_cast<std::ptrdiff_t>(line.longest) + 1,
                        hanging.begin(), hanging.end());
}

class Ropes {
public:
    Ropes(const scene::Scene& scene, const simulation::Motion* motion)
        : scene_(scene), motion_(motion) {
        for (std::size_t i = 0; i < scene.bodies.size(); ++i)
            bodies_.emplace(scene.bodies[i].name, i);
    }

    [[nodiscard]] std::optional<std::vector<Vector>> cornersOf(const scene::Rope& rope, double time,
                                                               const Vector& up) const {
        auto start = placesOf(rope, std::nullopt), now = placesOf(rope, time);
        if (!start || !now || now->size() < 2)
            return std::nullopt;
        const std::vector<double> radii = Route(rope, *start).orientedRadii();
        for (std::size_t i = 0; i < radii.size(); ++i)
            (*start)[i].radius = (*now)[i].radius = radii[i];
        const Route route(rope, *now);
        Route::Line line = route.line();
        if (!std::ranges::all_of(line.corners, [](const Vector& c) { return c.allFinite(); }))
            return std::nullopt;
        const double length = rope.length.value_or(Route(rope, *start).line().length);
        if (line.length > (1 + slack) * length)
            line = route.line(true);
        const double longer = length - line.length;
        if (route.hasDrum())
            return line.corners;
        if (longer < -slack * length && rope.release)
            return std::nullopt;
        if (longer > slack * length)
            sag(line, longer, up);
        return line.corners;
    }

    [[nodiscard]] std::optional<RopeEnd> endOf(const scene::Rope& rope, double time) const {
        auto start = placesOf(rope, std::nullopt), now = placesOf(rope, time);
        if (rope.isClosed || !start || !now || now->size() < 2)
            return std::nullopt;
        const std::vector<double> radii = Route(rope, *start).orientedRadii();
        for (std::size_t i = 0; i < radii.size(); ++i)
            (*start)[i].radius = (*now)[i].radius = radii[i];
        const Route::Line line = Route(rope, *now).line();
        const Vector last = line.corners.back() - line.corners[line.corners.size() - 2];
        const double measured = Route(rope, *start).line().length;
        if (Route(rope, *now).hasDrum() || !(last.norm() > 0) || !line.corners.back().allFinite() ||
            !std::isfinite(measured))
            return std::nullopt;
        return RopeEnd{line.corners.back(), last.normalized(), measured};
    }

private:
    [[nodiscard]] std::optional<std::vector<Place>> placesOf(const scene::Rope& rope,
                                                             std::optional<double> time) const {
        std::vector<Place> places;
        for (const scene::Rope::Point& point : rope.points) {
            Place place{point.place.value_or(Vector::Zero()), point.axis.normalized(),
                        point.radius};
            if (point.body) {
                const auto body = bodies_.find(*point.body);
                if (body == bodies_.end())
                    return std::nullopt;
                const geometry::Pose pose =
                    poseOf(scene_, time ? motion_ : nullptr, body->second, time.value_or(0));
                const bool isKnown = motion_ != nullptr && body->second < motion_->bodies();
                const Vector centre = isKnown ? motion_->centroid(body->second) : Vector::Zero();
                place.at = pose.toWorld(point.place.value_or(centre));
                place.axis = pose.attitude * place.axis;
            }
            places.push_back(place);
        }
        return places;
    }

    const scene::Scene& scene_;
    const simulation::Motion* motion_;
    std::unordered_map<std::string, std::size_t> bodies_;
};

} // namespace

std::vector<RopeLine> ropeLinesOf(const scene::Scene& scene, const simulation::Motion* motion,
                                  double time, const Vector& up) {
    std::vector<RopeLine> lines;
    if (scene.ropes.empty())
        return lines;
    const Ropes ropes(scene, motion);
    for (std::size_t r = 0; r < scene.ropes.size(); ++r)
        if (auto corners = ropes.cornersOf(scene.ropes[r], time, up))
            lines.push_back({r, std::move(*corners)});
    return lines;
}

std::optional<RopeEnd> ropeEndOf(const scene::Scene& scene, const simulation::Motion* motion,
                                 std::size_t rope, double time) {
    return Ropes(scene, motion).endOf(scene.ropes[rope], time);
}

std::vector<Vector> ropeAnchorsOf(const scene::Scene& scene) {
    std::vector<Vector> anchors;
    for (const scene::Rope& rope : scene.ropes)
        for (const scene::Rope::Point& point : rope.points)
            if (!point.body && point.place && point.place->allFinite())
                anchors.push_back(*point.place);
    return anchors;
}

} // namespace render
