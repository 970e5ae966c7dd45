#include "signs/trails.h"

#include <algorithm>
#include <cmath>

namespace render {

namespace {

constexpr int pieces = 360;      // of the whole motion
constexpr int deepest = 4;       // halvings of a piece that bends
constexpr std::size_t most = 64; // bodies with a trail

} // namespace

void Trails::follow(const Drawing& drawing, const Extent& extent) {
    const simulation::MotionPointer& motion = drawing.motion;
    if (of_.lock() == motion && motion != nullptr)
        return;
    of_ = motion;
    trails_.clear();
    if (motion == nullptr)
        return;
    const double start = motion->start(), length = motion->finish() - start;
    const double bend = 2e-3 * extent.size;
    for (std::size_t body = 0; body < std::min(extent.moves.size(), motion->bodies()); ++body) {
        if (!extent.moves[body] || trails_.size() == most)
            continue; // LIMIT: of a crowd only the first have trails
        Trail trail{body, {}};
        const std::vector<double> jumps = motion->jumps(body);
        const auto jumped = [&](double from, double to) {
            return std::any_of(jumps.begin(), jumps.end(),
                               [&](double t) { return from < t && t <= to; });
        };
        const auto at = [&](double t) { return motion->at(body, t).position; };
        const auto refine = [&](auto&& self, double t0, const Vector& p0, double t1,
                                const Vector& p1, int depth) -> void {
            const double middle = (t0 + t1) / 2;
            const Vector p = at(middle);
            if (depth < deepest && ((p0 + p1) / 2 - p).norm() > bend) {
                self(self, t0, p0, middle, p, depth + 1);
                self(self, middle, p, t1, p1, depth + 1);
                return;
            }
            trail.points.push_back({t1, p1, jumped(t0, t1)});
        };
        double t0 = start;
        Vector p0 = at(t0);
        trail.points.push_back({t0, p0, true});
        for (int i = 1; i <= pieces && t0 < motion->computed(); ++i) {
            const double t1 = std::min(start + length * i / pieces, motion->computed());
            const Vector p1 = at(t1);
            refine(refine, t0, p0, t1, p1, 0);
            t0 = t1;
            p0 = p1;
        }
        trails_.push_back(std::move(trail));
    }
}

void Trails::add(Lines& lines, const Drawing& drawing, const Frame& frame) const {
    if (drawing.motion == nullptr)
        return;
    const double start = drawing.motion->start();
    const double fade = std::max(drawing.motion->finish() - start, 1e-12) / 2.5;
    const auto alpha = [&](double t) {
        return static_cast<float>(0.14 + 0.66 * std::exp(-(drawing.time - t) / fade));
    };
    for (const Trail& trail : trails_) {
        const scene::Body& body = drawing.scene->bodies[trail.body];
        if (isHidden(drawing.display, body))
            continue;
        Ink ink{colorOf(*drawing.scene, body), 1, frame.stroke(1.4)};
        for (std::size_t i = 1; i < trail.points.size(); ++i) {
            const Point& a = trail.points[i - 1];
            Point b = trail.points[i];
            if (a.time >= drawing.time)
                break;
            if (b.breaks || !a.place.allFinite() || !b.place.allFinite())
                continue;
            if (b.time > drawing.time)
                b = {drawing.time, drawing.motion->at(trail.body, drawing.time).position, false};
            ink.alpha = alpha(a.time);
            lines.add(frame.toView(a.place), frame.toView(b.place), ink, alpha(b.time));
        }
    }
}

} // namespace render
