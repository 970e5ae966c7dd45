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
    std::vector<std::vector<double>> jumps;
    for (std::size_t body = 0; body < std::min(extent.moves.size(), motion->bodies()); ++body)
        if (extent.moves[body] && trails_.size() < most) { // LIMIT: of a crowd the first alone
            trails_.push_back({body, {{start, motion->at(body, start).position, true}}});
            jumps.push_back(motion->jumps(body));
        }
    // Piece by piece: bodies share what a motion works out for a time.
    double t0 = start;
    for (int i = 1; i <= pieces && t0 < motion->computed(); ++i) {
        const double t1 = std::min(start + length * i / pieces, motion->computed());
        for (std::size_t k = 0; k < trails_.size(); ++k) {
            const Vector p0 = trails_[k].points.back().place;
            const Vector p1 = motion->at(trails_[k].body, t1).position;
            refine(trails_[k], *motion, jumps[k], {t0, p0}, {t1, p1}, bend, 0);
        }
        t0 = t1;
    }
}

void Trails::refine(Trail& trail, const simulation::Motion& motion,
                    const std::vector<double>& jumps, const Place& from, const Place& to,
                    double bend, int depth) {
    const double middle = (from.time + to.time) / 2;
    const Vector p = motion.at(trail.body, middle).position;
    if (depth < deepest && ((from.place + to.place) / 2 - p).norm() > bend) {
        refine(trail, motion, jumps, from, {middle, p}, bend, depth + 1);
        refine(trail, motion, jumps, {middle, p}, to, bend, depth + 1);
        return;
    }
    const bool jumped =
        std::ranges::any_of(jumps, [&](double t) { return from.time < t && t <= to.time; });
    trail.points.push_back({to.time, to.place, jumped});
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
