#include "collision/ball_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {

namespace {

using Kind = FlightMeeting::Kind;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double lowHop = 1e-8;      // of the radius: lower hops are left to the general search
constexpr double graze = 1e-9;       // of the radius: so near a miss formulas are not trusted
constexpr double nearAnEdge = 1e-12; // of the extent

double largest(const Vector& p) {
    return std::max(std::max(std::abs(p[0]), std::abs(p[1])), std::abs(p[2]));
}

// How far what moves so fast goes within the resolution of times about t: an impact is off by that.
double timeOff(double t, double speeds) { return 8 * epsilon * std::abs(t) * speeds; }

// The gap |p + v s| - R is refined once where it falls steeply enough.
double refined(const Vector& p, const Vector& v, double speed, double radius, double s) {
    const Vector r = p + s * v;
    const double distance = r.norm(), along = r.dot(v);
    return along < -1e-6 * speed * distance ? s - (distance - radius) * distance / along : s;
}

FlightMeeting hitAt(double time, Interval during) {
    if (time > during.to)
        return {};
    return {Kind::hit, std::max(time, during.from)};
}

} // namespace

FlightMeeting meetingOf(const Approach& approach, const BallFlight& first, const BallFlight& second,
                        Interval during) {
    if (!approach.isStraight)
        return {Kind::unclear, 0};
    const double radius = first.radius + second.radius;
    const Vector &p = approach.place, &v = approach.velocity;
    const double distance = std::sqrt(approach.distanceSquare), gap = distance - radius;
    const double roundOff =
        4 * epsilon * (radius + largest(approach.firstPlace) + largest(approach.secondPlace));
    if (!(gap > roundOff)) { // only what parts for ever
        const double speeds =
            first.velocityAt(approach.from).norm() + second.velocityAt(approach.from).norm();
        const bool isDeep = gap < -100 * roundOff - timeOff(approach.from, speeds);
        if (!isDeep && approach.along > distance * approachThreshold * speeds)
            return {};
        return {Kind::unclear, 0};
    }
    if (approach.along >= 0)
        return {};
    const double across = (p - (approach.along / approach.speedSquare) * v).norm();
    if (across >= radius)
        return across < radius * (1 + graze) ? FlightMeeting{Kind::unclear, 0} : FlightMeeting{};
    if (across > radius * (1 - graze))
        return {Kind::unclear, 0};
    const double speed = std::sqrt(approach.speedSquare);
    const double root = speed * std::sqrt((radius - across) * (radius + across));
    const double s = gap * (distance + radius) / (root - approach.along);
    const double time = approach.from + refined(p, v, speed, radius, s);
    if (time < during.from - 1e-9 * s) // what that was is not for this window
        return {Kind::unclear, 0};
    return hitAt(time, during);
}

namespace {

// The way along a face's normal: above + rate s + bend s^2.
struct Way {
    double above = 0, rate = 0, bend = 0;
};

Way wayOf(const BallFlight& ball, const StandingFace::Plane& plane) {
    return {plane.above(ball.place) - ball.radius, plane.normal.dot(ball.velocity),
            plane.normal.dot(ball.half)};
}

// The first s > 0 at which it comes down to 0, from above or from a touch that it leaves; infinity:
// never. None: too near a graze to tell.
std::optional<double> landing(const Way& way, bool touches) {
    if (way.bend == 0)
        return touches || way.rate >= 0 ? HUGE_VAL : -way.above / way.rate;
    const double square = way.rate * way.rate, lift = 4 * way.above * way.bend;
    const double discriminant = square - lift;
    if (way.bend > 0 && way.rate >= 0)
        return HUGE_VAL;
    if (std::abs(discriminant) <= graze * (square + std::abs(lift)))
        return std::nullopt;
    if (discriminant < 0)
        return HUGE_VAL;
    const double q = -0.5 * (way.rate + std::copysign(std::sqrt(discriminant), way.rate));
    const double one = q / way.bend, other = q != 0 ? way.above / q : 0;
    if (touches || way.bend < 0) // the later of the two: the earlier is before, or now
        return std::max(one, other);
    return std::min(one, other);
}

enum class Over { inside, outside, edge };

Over overFace(const StandingFace& face, const Vector& point, double extent) {
    Over result = Over::inside;
    for (const StandingFace::Plane& side : face.sides) {
        const double in = side.above(point);
        if (in < -nearAnEdge * extent)
            return Over::outside;
        if (in < nearAnEdge * extent)
            result = Over::edge;
    }
    return result;
}

} // namespace

const StandingFace& StandingPart::facing(const Vector& point) const {
    const StandingFace* best = &faces[0];
    double most = best->plane.above(point);
    for (std::size_t i = 1; i < faces.size(); ++i)
        if (const double above = faces[i].plane.above(point); above > most) {
            most = above;
            best = &faces[i];
        }
    return *best;
}

StandingPart standingPart(const geometry::Part& part, const Pose& pose) {
    StandingPart standing;
    std::vector<Vector> corners;
    for (const Vector& vertex : part.core.vertices)
        corners.push_back(pose.toWorld(vertex));
    for (const Vector& corner : corners)
        standing.extent = std::max(standing.extent, corner.cwiseAbs().maxCoeff());
    if (part.isPlane()) {
        const Vector normal = pose.attitude * part.curved->axis();
        standing.faces.push_back({{normal, normal.dot(pose.toWorld(part.curved->center))}, {}});
    }
    for (const geometry::Face& face : part.core.faces) {
        StandingFace made;
        const Vector normal = pose.attitude * face.normal;
        made.plane = {normal, face.offset + normal.dot(pose.position)};
        for (std::size_t i = 0; i < face.vertices.size(); ++i) {
            const Vector& a = corners[face.vertices[i]];
            const Vector& b = corners[face.vertices[(i + 1) % face.vertices.size()]];
            const Vector inward = normal.cross(b - a).normalized();
            made.sides.push_back({inward, inward.dot(a)});
        }
        standing.faces.push_back(std::move(made));
    }
    return standing;
}

FlightMeeting meetingOf(const BallFlight& ball, const StandingPart& part, Interval during) {
    double t = std::max(during.from, ball.from);
    for (int face = 0; face < 4; ++face) {
        const Vector centre = ball.centreAt(t);
        const StandingFace& facing = part.facing(centre);
        const double roundOff =
            4 * epsilon * (ball.radius + part.extent) + 4 * epsilon * centre.cwiseAbs().maxCoeff();
        const double gap = facing.plane.above(centre) - ball.radius;
        const bool touches = gap <= roundOff;
        Way way = wayOf(ball, facing.plane);
        if (touches) {
            // Only what leaves a face just now, and does not come back at once.
            const double least = approachThreshold * ball.velocity.norm();
            const double deepest = 100 * roundOff + timeOff(t, ball.velocity.norm());
            const bool leaves = t == ball.from && gap > -deepest && way.rate > least;
            if (face > 0 || !leaves ||
                (way.bend < 0 && way.rate * way.rate < -4 * way.bend * lowHop * ball.radius))
                return {Kind::unclear, 0};
        }
        const auto s = landing(way, touches);
        if (!s)
            return {Kind::unclear, 0};
        const double time = ball.from + *s;
        if (!(time <= during.to))
            return {};
        if (time < t)
            return {Kind::unclear, 0};
        const Over over = overFace(facing, ball.centreAt(time), part.extent);
        if (over == Over::inside)
            return hitAt(time, during);
        if (over == Over::edge || time == t)
            return {Kind::unclear, 0};
        t = time;
    }
    return {Kind::unclear, 0};
}

FlightContact contactOf(const PlacedBall& first, const PlacedBall& second, double tolerance) {
    const Vector p = first.centre - second.centre;
    const double distance = p.norm(), gap = distance - (first.radius + second.radius);
    if (std::abs(gap) > tolerance || !(distance > 0))
        return {};
    const Vector normal = p / distance;
    return {FlightContact::Kind::contact, second.centre + (second.radius + gap / 2) * normal,
            normal, gap};
}

FlightContact contactOf(const PlacedBall& ball, const StandingPart& part, double tolerance) {
    const StandingFace& facing = part.facing(ball.centre);
    const double gap = facing.plane.above(ball.centre) - ball.radius;
    if (std::abs(gap) > tolerance)
        return {gap > 0 ? FlightContact::Kind::none : FlightContact::Kind::unclear, {}, {}, gap};
    if (overFace(facing, ball.centre, part.extent) != Over::inside)
        return {FlightContact::Kind::unclear, {}, {}, gap};
    const Vector& normal = facing.plane.normal;
    return {FlightContact::Kind::contact, ball.centre - (ball.radius + gap / 2) * normal, normal,
            gap};
}

} // namespace collision
