#include "physics/rope_paths.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace physics {
namespace {

constexpr double offPlane = 1e-3;    // of the rope's size; an angle of 1.5708 or 1.571 is pi/2
constexpr double notParallel = 1e-6; // of the cosine
constexpr double tooShort = 1e-6;    // of the rope's size
constexpr double noTurn = 1e-9;      // of the sine of a turn
constexpr double blunt = 1e-9;       // of the rope's size: two points in one place have a direction

std::string faultOf(const scene::Rope& rope) { return "rope \"" + rope.name + "\": "; }

// With its first rate alone.
Jet quotient(Graph& g, const Jet& a, const Jet& b) {
    const Node value = g.divide(a.value, b.value);
    return {value, g.divide(g.subtract(a.rate, g.multiply(value, b.rate)), b.value), {}};
}

// The end of a span that is a wheel, if one is.
std::size_t wheelOf(const RopePath& path, const RopeSpan& span) {
    return path.points[span.from].radius != 0 ? 0 : 1;
}

double signOf(double value) { return value < 0 ? -1 : 1; }

} // namespace

RopePaths::RopePaths(Graph& g, const scene::Scene& scene, const Scope& scope,
                     std::span<const BodyMotion> bodies, std::vector<std::string>& faults)
    : g_(g), scope_(scope), bodies_(bodies), faults_(faults), start_(g, scene, scope),
      points_(g, bodies) {
    for (const scene::Rope& rope : scene.ropes)
        paths_.push_back(pathOf(rope));
}

Vector RopePaths::placeOf(const CarriedPoint& point) {
    if (!point.body)
        return point.arm;
    const geometry::Pose& pose = start_.poseOf(*point.body);
    return pose.position + pose.attitude * point.arm;
}

Vector RopePaths::directionOf(const CarriedPoint& point, const Vector& v) {
    return point.body ? Vector(start_.poseOf(*point.body).attitude * v) : v;
}

RopePath RopePaths::pathOf(const scene::Rope& rope) {
    RopePath path;
    for (const scene::Rope::Point& said : rope.points) {
        RopePoint point;
        point.arm = said.place.value_or(Vector::Zero());
        point.radius = said.radius;
        point.axis = said.axis.normalized();
        if (said.body) {
            const auto found = std::ranges::find(bodies_, *said.body, &BodyMotion::name);
            if (found == bodies_.end()) {
                faults_.push_back(faultOf(rope) + "no body named \"" + *said.body + "\"");
                return path;
            }
            point.body = static_cast<std::size_t>(found - bodies_.begin());
            point.arm = scope_.armTo(*point.body, said.place);
            const bool isKnown = std::ranges::find(path.moving, *point.body) != path.moving.end();
            if (!found->isFixed && !isKnown)
                path.moving.push_back(*point.body);
        }
        path.points.push_back(point);
    }
    const std::size_t count = path.points.size();
    for (std::size_t i = 0; i + (rope.isClosed ? 0 : 1) < count; ++i)
        path.spans.push_back({.from = i, .to = (i + 1) % count, .ends = {}});
    path.size = 0;
    for (const RopeSpan& span : path.spans)
        path.size += (placeOf(path.points[span.to]) - placeOf(path.points[span.from])).norm();
    path.size = std::max(path.size, rope.length.value_or(0));
    divide(rope, path);
    orient(rope, path);
    const std::size_t told = faults_.size();
    for (const RopeSpan& span : path.spans)
        for (const auto& [wheel, other] :
             {std::pair(span.from, span.to), std::pair(span.to, span.from)})
            if (path.points[wheel].radius != 0 && faults_.size() == told)
                checkWheel(rope, path, wheel, other);
    if (faults_.size() != told)
        return path;
    findFrames(rope, path);
    for (const std::size_t end : {0U, 1U})
        if (!rope.isClosed)
            noteOtherSide(rope, path, end);
    return path;
}

// The spans of a closed rope begin at its first wheel.
void RopePaths::divide(const scene::Rope& rope, RopePath& path) const {
    if (rope.isClosed) {
        const auto wheel = std::ranges::find_if(
            path.spans, [&](const RopeSpan& s) { return path.points[s.from].radius != 0; });
        if (wheel != path.spans.end())
            std::rotate(path.spans.begin(), wheel, path.spans.end());
    }
    std::size_t first = 0;
    for (std::size_t k = 0; k < path.spans.size(); ++k)
        if (k + 1 == path.spans.size() || path.points[path.spans[k].to].radius != 0) {
            path.stretches.emplace_back(first, k + 1);
            first = k + 1;
        }
}

// The side of each wheel on which the rope goes: that towards which the path by the centres turns,
// with a radius under 0 the other. Where it does not turn, the sign is about the axis.
void RopePaths::orient(const scene::Rope& rope, RopePath& path) {
    const std::size_t count = path.points.size();
    for (std::size_t i = 0; i < count; ++i) {
        RopePoint& point = path.points[i];
        const bool isEnd = !rope.isClosed && (i == 0 || i + 1 == count);
        if (point.radius == 0 || isEnd)
            continue;
        const Vector at = placeOf(point);
        const Vector before = (at - placeOf(path.points[(i + count - 1) % count])).normalized(),
                     after = (placeOf(path.points[(i + 1) % count]) - at).normalized();
        const double turn = directionOf(point, point.axis).dot(before.cross(after));
        if (std::abs(turn) > noTurn)
            point.radius *= signOf(turn);
    }
}

void RopePaths::checkWheel(const scene::Rope& rope, const RopePath& path, std::size_t wheel,
                           std::size_t neighbour) {
    const RopePoint &point = path.points[wheel], &other = path.points[neighbour];
    const Vector axis = directionOf(point, point.axis);
    const Vector d = placeOf(other) - placeOf(point);
    const std::string which = "point " + std::to_string(neighbour + 1),
                      of = "the wheel at point " + std::to_string(wheel + 1);
    const double off = std::abs(axis.dot(d));
    char text[200];
    if (!(off <= offPlane * path.size)) {
        std::snprintf(text, sizeof text,
                      "%s lies %.4g off the plane of %s, which is across its axis", which.c_str(),
                      off, of.c_str());
        faults_.push_back(faultOf(rope) + text);
        return;
    }
    double between = point.radius;
    if (other.radius != 0) {
        const double along = axis.dot(directionOf(other, other.axis));
        if (!(std::abs(along) > 1 - notParallel)) {
            faults_.push_back(faultOf(rope) + "the axes of the wheels at points " +
                              std::to_string(std::min(wheel, neighbour) + 1) + " and " +
                              std::to_string(std::max(wheel, neighbour) + 1) + " are not parallel");
            return;
        }
        between -= signOf(along) * other.radius;
    }
    const double apart = (d - axis * axis.dot(d)).norm();
    if (!(apart > std::abs(between))) {
        std::snprintf(text, sizeof text,
                      "%s lies %.4g from the centre of %s, and a rope cannot leave it",
                      which.c_str(), apart, of.c_str());
        faults_.push_back(faultOf(rope) + text);
    }
}

// Length of a span as the bodies stand at the start, and its direction in the plane of a wheel at
// one of its ends.
std::pair<double, Vector> RopePaths::startOf(const RopePath& path, const RopeSpan& span,
                                             std::size_t end) {
    const RopePoint &a = path.points[span.from], &b = path.points[span.to];
    const Vector d = placeOf(b) - placeOf(a);
    const RopePoint& wheel = end == 0 ? a : b;
    if (wheel.radius == 0)
        return {d.norm(), d.normalized()};
    const Vector axis = directionOf(wheel, wheel.axis), flat = d - axis * axis.dot(d);
    const double off = offOf(path, span, end), square = flat.squaredNorm();
    const double l = std::sqrt(square - off * off);
    return {std::sqrt(d.squaredNorm() - off * off), (l * flat - off * axis.cross(flat)) / square};
}

void RopePaths::findFrames(const scene::Rope& rope, RopePath& path) {
    const std::size_t count = path.points.size();
    const auto isMoving = [&](const RopePoint& point) {
        return point.body && !bodies_[*point.body].isFixed;
    };
    for (std::size_t k = 0; k < path.spans.size(); ++k) {
        RopeSpan& span = path.spans[k];
        for (const std::size_t end : {0U, 1U}) {
            RopePoint& point = path.points[end == 0 ? span.from : span.to];
            if (point.radius == 0)
                continue;
            const Vector u = startOf(path, span, end).second;
            const Vector left = directionOf(point, point.axis).cross(u);
            const Quaternion back = point.body ? start_.poseOf(*point.body).attitude.conjugate()
                                               : Quaternion::Identity();
            const bool changes = isMoving(path.points[span.from]) || isMoving(path.points[span.to]);
            span.ends[end] = {back * u, back * left,
                              changes ? g_.symbol(rope.name + ".angle" + std::to_string(k) +
                                                  (end == 0 ? "a" : "b"))
                                      : g_.constant(0)};
            (end == 0 ? point.out : point.in) = span.ends[end].angle;
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        RopePoint& point = path.points[i];
        if (!point.in || !point.out)
            continue;
        const RopeSpan to{.from = (i + count - 1) % count, .to = i, .ends = {}},
            from{.from = i, .to = (i + 1) % count, .ends = {}};
        const Vector before = startOf(path, to, 1).second, after = startOf(path, from, 0).second;
        const Vector axis = directionOf(point, point.axis);
        const double turn = std::atan2(axis.dot(before.cross(after)), before.dot(after));
        const double angle = signOf(point.radius) * turn;
        point.wrapped = angle < -noTurn ? angle + 2 * std::numbers::pi : std::max(angle, 0.0);
        const bool isBetweenPoints = path.points[(i + count - 1) % count].radius == 0 &&
                                     path.points[(i + 1) % count].radius == 0;
        const bool changes = g_.op(*point.in) == Op::symbol || g_.op(*point.out) == Op::symbol;
        if (rope.isClosed || !isBetweenPoints || !changes)
            continue;
        point.slid = g_.symbol(rope.name + ".slid" + std::to_string(i));
        if (angle < -noTurn && isTooShort(rope, path))
            point.wrapped = angle;
    }
}

// A weight beside a drum is meant to hang straight down: a span that leads along an axis of the
// world on the other side of the drum alone is on the wrong one.
void RopePaths::noteOtherSide(const scene::Rope& rope, const RopePath& path, std::size_t end) {
    constexpr double straight = 1e-6; // of the cosine
    RopePath other = path;
    const RopeSpan& span = end == 0 ? path.spans.front() : path.spans.back();
    RopePoint& drum = other.points[end == 0 ? span.from : span.to];
    drum.radius *= -1;
    const auto isStraight = [&](const RopePath& of) {
        return startOf(of, span, end).second.cwiseAbs().maxCoeff() > 1 - straight;
    };
    if (drum.radius == 0 || !drum.body || isStraight(path) || !isStraight(other))
        return;
    char text[200];
    std::snprintf(text, sizeof text,
                  "leads askew from the one side of the wheel at point %zu, and straight from the "
                  "other with a radius of %g",
                  (end == 0 ? span.from : span.to) + 1, drum.radius);
    notes_.push_back(faultOf(rope) + text);
}

// Its length does not reach around its wheels as they are wrapped.
bool RopePaths::isTooShort(const scene::Rope& rope, const RopePath& path) {
    if (!rope.length)
        return false;
    double measured = 0;
    for (const RopeSpan& span : path.spans)
        measured += startOf(path, span, wheelOf(path, span)).first;
    for (const RopePoint& point : path.points)
        measured += std::abs(point.radius) * point.wrapped;
    return *rope.length < measured - tooShort * path.size;
}

// The difference of the radii at the ends of a span, about the axis of the wheel at one of them.
double RopePaths::offOf(const RopePath& path, const RopeSpan& span, std::size_t end) {
    const RopePoint &a = path.points[span.from], &b = path.points[span.to],
                    &wheel = end == 0 ? a : b, &other = end == 0 ? b : a;
    double off = end == 0 ? -wheel.radius : wheel.radius;
    if (other.radius != 0) {
        const double sense =
            signOf(directionOf(wheel, wheel.axis).dot(directionOf(other, other.axis)));
        off += sense * (end == 0 ? other.radius : -other.radius);
    }
    return off;
}

RopePaths::Plane RopePaths::planeOf(const RopePath& path, const RopeSpan& span, std::size_t end,
                                    const Along& along) {
    const RopePoint &a = path.points[span.from], &b = path.points[span.to],
                    &wheel = end == 0 ? a : b;
    const JetVector d = points_.apart(b, a, along);
    const double off = offOf(path, span, end);
    Plane plane;
    plane.x = product(g_, points_.carried(wheel, span.ends[end].along, along), d);
    plane.y = product(g_, points_.carried(wheel, span.ends[end].left, along), d);
    const Jet square = sum(g_, product(g_, plane.x, plane.x), product(g_, plane.y, plane.y));
    plane.length = root(g_, difference(g_, square, constantJet(g_, off * off)));
    const Jet &x = plane.x, &y = plane.y, &l = plane.length;
    plane.ux = quotient(g_, sum(g_, product(g_, l, x), scaled(g_, off, y)), square);
    plane.uy = quotient(g_, difference(g_, product(g_, l, y), scaled(g_, off, x)), square);
    return plane;
}

// In space: a span that leaves the plane of its wheel is as long as the way is. A length within the
// plane would become less as the wheel tilts, and the rope's tension would drive the tilt on.
Jet RopePaths::lengthOf(const RopePath& path, const RopeSpan& span, const Along& along) {
    const RopePoint &a = path.points[span.from], &b = path.points[span.to];
    if (a.radius == 0 && b.radius == 0)
        return straight(path, span.from, span.to, along);
    const JetVector d = points_.apart(b, a, along);
    const double off = offOf(path, span, wheelOf(path, span));
    return root(g_, difference(g_, product(g_, d, d), constantJet(g_, off * off)));
}

std::optional<RopeLean> RopePaths::lean(std::size_t rope, std::size_t span, std::size_t end) {
    const RopePath& path = paths_[rope];
    const RopeSpan& of = path.spans[span];
    const RopePoint &a = path.points[of.from], &b = path.points[of.to], &wheel = end == 0 ? a : b;
    if (wheel.radius == 0 || !wheel.body)
        return std::nullopt;
    const JetVector d = points_.apart(b, a, {});
    return RopeLean{.rope = rope,
                    .body = *wheel.body,
                    .out = product(g_, points_.carried(wheel, wheel.axis, {}), d).value,
                    .way = physics::length(g_, d).value,
                    .least = std::abs(offOf(path, of, end))};
}

Jet RopePaths::straight(const RopePath& path, std::size_t from, std::size_t to,
                        const Along& along) {
    const JetVector d = points_.apart(path.points[to], path.points[from], along);
    const double least = blunt * path.size;
    return root(g_, sum(g_, product(g_, d, d), constantJet(g_, least * least)));
}

// u' = q' left(u):  l q' = u x d',  (l q')' = q' left(u) x d' + u x d''.
Jet RopePaths::angle(std::size_t rope, std::size_t span, std::size_t end, const Along& along) {
    const RopePath& path = paths_[rope];
    const RopeSpan& of = path.spans[span];
    const auto [x, y, l, ux, uy] = planeOf(path, of, end, along);
    const auto crossed = [this](Node ax, Node ay, Node bx, Node by) {
        return g_.subtract(g_.multiply(ax, by), g_.multiply(ay, bx));
    };
    const Node rate = g_.divide(crossed(ux.value, uy.value, x.rate, y.rate), l.value);
    const Node onwards = g_.add(g_.multiply(ux.value, x.rate), g_.multiply(uy.value, y.rate));
    const Node turning = g_.multiply(rate, g_.add(onwards, l.rate));
    const Node left = crossed(ux.value, uy.value, x.second, y.second);
    Node second = g_.divide(g_.subtract(left, turning), l.value);
    const Node q = of.ends[end].angle;
    // The tie moves the angle without the bodies.
    if (const auto tie = ties_.find(q.index); along.set && tie != ties_.end())
        second = g_.add(second, tie->second);
    return {q, rate, second};
}

// ux sin q - uy cos q.
Jet RopePaths::tie(std::size_t rope, std::size_t span, std::size_t end, const Along& along) {
    const RopePath& path = paths_[rope];
    const RopeSpan& of = path.spans[span];
    const auto [x, y, l, ux, uy] = planeOf(path, of, end, along);
    const Node q = of.ends[end].angle;
    const Node sine = g_.apply(Op::sin, q), cosine = g_.apply(Op::cos, q);
    const Node size = g_.constant(std::abs(path.points[end == 0 ? of.from : of.to].radius));
    const Node rateOfQ = g_.add(angle(rope, span, end, along).rate, ties_.at(q.index));
    const Node gap = g_.subtract(g_.multiply(ux.value, sine), g_.multiply(uy.value, cosine));
    const Node moved = g_.subtract(g_.multiply(ux.rate, sine), g_.multiply(uy.rate, cosine));
    const Node turned =
        g_.multiply(rateOfQ, g_.add(g_.multiply(uy.value, sine), g_.multiply(ux.value, cosine)));
    return {g_.multiply(size, gap), g_.multiply(size, g_.add(moved, turned)), {}};
}

// The angle by which the rope is wrapped around a wheel; under 0 it is off.
Node RopePaths::wrapOf(const RopePoint& wheel) {
    const Node turned =
        g_.multiply(g_.constant(signOf(wheel.radius)), g_.subtract(*wheel.out, *wheel.in));
    return g_.add(g_.constant(wheel.wrapped), turned);
}

Node RopePaths::isOffBefore(std::size_t rope, std::size_t stretch) {
    const RopePath& path = paths_[rope];
    const RopePoint& wheel = path.points[path.spans[path.stretches[stretch].first].from];
    return wheel.slid ? g_.apply(Op::less, wrapOf(wheel), g_.constant(0)) : g_.constant(0);
}

Jet RopePaths::chosen(Node condition, const Jet& a, const Jet& b) {
    return {g_.apply(Op::select, condition, a.value, b.value),
            g_.apply(Op::select, condition, a.rate, b.rate),
            g_.apply(Op::select, condition, a.second, b.second)};
}

Jet RopePaths::ownGap(std::size_t rope, std::size_t stretch, double material, const Along& along) {
    const RopePath& path = paths_[rope];
    const auto& [first, behind] = path.stretches[stretch];
    Jet gap = constantJet(g_, material);
    for (std::size_t k = first; k < behind; ++k) {
        const RopeSpan& span = path.spans[k];
        gap = difference(g_, gap, lengthOf(path, span, along));
        for (const std::size_t end : {0U, 1U}) {
            const double radius = path.points[end == 0 ? span.from : span.to].radius;
            if (radius != 0 && g_.op(span.ends[end].angle) == Op::symbol)
                gap = sum(g_, gap,
                          scaled(g_, end == 0 ? -radius : radius, angle(rope, k, end, along)));
        }
    }
    return gap;
}

const std::optional<Node>& RopePaths::slidBefore(std::size_t rope, std::size_t stretch) const {
    const RopePath& path = paths_[rope];
    return path.points[path.spans[path.stretches[stretch].first].from].slid;
}

// 0 where the stretch behind the wheel, which is off, has no slack: that is before it.
Jet RopePaths::slidTie(std::size_t rope, std::size_t stretch, double material, const Along& along) {
    const Node slid = *slidBefore(rope, stretch), isOff = isOffBefore(rope, stretch);
    const Node multiplier = ties_.at(slid.index);
    const Node gap = g_.add(ownGap(rope, stretch, material, along).value, slid);
    return {g_.apply(Op::select, isOff, gap, g_.constant(0)), multiplier, {}};
}

// The stretch behind the wheel keeps the gap that it has while the rope is off: that slides past.
Jet RopePaths::slid(std::size_t rope, std::size_t stretch, const Along& along) {
    const std::optional<Node>& slid = slidBefore(rope, stretch);
    if (!slid)
        return constantJet(g_, 0);
    const Jet sliding = scaled(g_, -1, ownGap(rope, stretch, 0, along));
    Jet jet = chosen(isOffBefore(rope, stretch), sliding, constantJet(g_, 0));
    jet.value = *slid;
    if (const auto tie = ties_.find(slid->index); along.set && tie != ties_.end())
        jet.second = g_.add(jet.second, tie->second);
    return jet;
}

Node RopePaths::slidRate(std::size_t rope, std::size_t stretch) {
    return slid(rope, stretch, {}).rate;
}

// The length that a straight span past the wheel before a stretch saves: l + l + |r| angle -
// straight.
Jet RopePaths::joining(std::size_t rope, std::size_t stretch, const Along& along) {
    const RopePath& path = paths_[rope];
    const std::size_t behind = path.stretches[stretch].first;
    const RopeSpan &before = path.spans[behind - 1], &after = path.spans[behind];
    const RopePoint& wheel = path.points[after.from];
    Jet saved = sum(g_, lengthOf(path, before, along), lengthOf(path, after, along));
    saved = difference(g_, saved, straight(path, before.from, after.to, along));
    saved = sum(g_, saved, scaled(g_, -wheel.radius, angle(rope, behind - 1, 1, along)));
    saved = sum(g_, saved, scaled(g_, wheel.radius, angle(rope, behind, 0, along)));
    return sum(g_, saved, constantJet(g_, std::abs(wheel.radius) * wheel.wrapped));
}

bool RopePaths::isStill(std::size_t rope, std::size_t stretch) {
    return g_.isConstant(ownGap(rope, stretch, 0, {}).rate, 0);
}

// With what is joined to it behind wheels that are off. A stretch between what is fixed is taut.
Jet RopePaths::wholeGap(std::size_t rope, std::size_t stretch, std::span<const double> material,
                        const Along& along) {
    Jet own = sum(g_, ownGap(rope, stretch, material[stretch], along), slid(rope, stretch, along));
    const std::size_t next = stretch + 1;
    if (next == paths_[rope].stretches.size())
        return own;
    own = difference(g_, own, slid(rope, next, along));
    const Node isOff = isOffBefore(rope, next);
    if (g_.op(isOff) == Op::constant)
        return own;
    const Jet joined = sum(g_, wholeGap(rope, next, material, along), joining(rope, next, along));
    return chosen(isOff, sum(g_, own, joined), isStill(rope, stretch) ? constantJet(g_, 0) : own);
}

Jet RopePaths::gap(std::size_t rope, std::size_t stretch, std::span<const double> material,
                   const Along& along) {
    const Jet whole = wholeGap(rope, stretch, material, along);
    const Node isOff = isOffBefore(rope, stretch);
    return g_.op(isOff) == Op::constant ? whole : chosen(isOff, constantJet(g_, 0), whole);
}

double RopePaths::startOf(std::size_t rope, std::size_t stretch) {
    const RopePath& path = paths_[rope];
    const auto& [first, behind] = path.stretches[stretch];
    Node all = g_.constant(0);
    for (std::size_t k = first; k < behind; ++k)
        all = g_.add(all, lengthOf(path, path.spans[k], {}).value);
    return start_.of(all);
}

Node RopePaths::length(std::size_t rope) {
    const RopePath& path = paths_[rope];
    Node all = g_.constant(0);
    for (const RopeSpan& span : path.spans)
        all = g_.add(all, lengthOf(path, span, {}).value);
    for (const RopePoint& point : path.points) {
        if (!point.in || !point.out)
            continue;
        const double size = std::abs(point.radius);
        all = g_.add(all, g_.constant(size * point.wrapped));
        all =
            g_.add(all, g_.multiply(g_.constant(point.radius), g_.subtract(*point.out, *point.in)));
    }
    for (std::size_t s = 1; s < path.stretches.size(); ++s)
        if (const Node isOff = isOffBefore(rope, s); g_.op(isOff) != Op::constant)
            all = g_.subtract(
                all, g_.apply(Op::select, isOff, joining(rope, s, {}).value, g_.constant(0)));
    return all;
}

} // namespace physics
