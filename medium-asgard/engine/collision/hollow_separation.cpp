#include "collision/hollow_separation.h"

#include "collision/contact.h"
#include "collision/curved_separation.h"
#include "collision/polynomial.h"
#include "collision/spheres.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace collision {
namespace {

using geometry::HollowNearest;

Vector turnedInto(const Posed& posed, const Vector& place) {
    return posed.rotation.transpose() * (place - posed.offset);
}

// The first time at which a polynomial is below 0; more than the length: not within it.
double rootOf(Polynomial p, double length, bool isLeaving) {
    if (isLeaving) { // p(0) = 0
        for (std::size_t k = 0; k + 1 < p.count; ++k)
            p.terms[k] = p.terms[k + 1];
        p.terms[p.count - 1] = 0;
        p.count = std::max<std::size_t>(p.count - 1, 1);
    }
    return firstDescent(p, length).value_or(2 * length);
}

// The gap that a search counts with: 0 for what touches and leaves.
double countedGap(const HollowQuestion& question, double own) {
    const bool counts = !question.isLeaving || own > question.pair.unnoticedDepth(question.t);
    return counts ? std::max({own, question.gap, 0.0}) : 0;
}

// How long it lasts at least, if nothing is faster.
double clearAtSpeed(double gap, double speed, double window) {
    if (!(gap > 0))
        return 0;
    return speed > 0 ? gap / speed : 2 * window;
}

// A ball and the wall now, and how they move within the window.
class Passage {
public:
    Passage(const HollowQuestion& question, std::size_t vertex)
        : question_(question), isFirst_(!question.pair.first.part->isHollow()),
          ball_(isFirst_ ? question.pair.first : question.pair.second),
          wall_(isFirst_ ? question.pair.second : question.pair.first),
          path_(relativePath(ball_.piece, wall_.piece, question.t)) {
        const Posed ball = ball_.posedAt(question.t, positionAt(ball_.piece, question.t));
        const Posed wall = wall_.posedAt(question.t, positionAt(wall_.piece, question.t));
        lever_ = ball.world(vertex);
        arm_ = positionAt(ball_.piece, question.t) - positionAt(wall_.piece, question.t) + lever_;
        nearest_ = geometry::nearestOf(*wall.part->curved, turnedInto(wall, arm_));
        normal_ = wall.rotation * nearest_.normal;
        axis_ = wall.rotation * wall.part->curved->axis();
        gap_ = countedGap(question, nearest_.distance - ball_.part->radius);
    }

    [[nodiscard]] double clear() const {
        const double speed = speedWithin(question_.window);
        const double clear = clearAtSpeed(gap_, speed, question_.window);
        return wall_.turns() ? clear : std::max(clear, alongNormal(speed));
    }

    // No faster does the ball's centre go in the wall's frame, but for turning about its axis.
    [[nodiscard]] double speedWithin(double window) const {
        double speed = 0, way = 0, power = 1;
        for (std::size_t k = 1; k <= maximumDegree; ++k, power *= window) {
            Vector term = Vector::Zero();
            for (std::size_t c = 0; c < 3; ++c)
                if (k < path_[c].count)
                    term[static_cast<Eigen::Index>(c)] = path_[c].terms[k];
            speed += static_cast<double>(k) * term.norm() * power;
            way += term.norm() * power * window;
        }
        if (lever_.norm() > 0)
            speed += turnBounds(ball_.piece, question_.t, question_.t + window).angularSpeed *
                     lever_.norm();
        if (wall_.turns())
            speed += turnBoundsAcross(wall_.piece, axis_, question_.t, question_.t + window)
                         .angularSpeed *
                     (arm_.norm() + way + 2 * lever_.norm());
        return speed;
    }

    // Nor does it change its velocity faster; of a wall that does not turn.
    [[nodiscard]] double accelerationWithin(double window) const {
        double most = 0, power = 1;
        for (std::size_t k = 2; k <= maximumDegree; ++k, power *= window) {
            Vector term = Vector::Zero();
            for (std::size_t c = 0; c < 3; ++c)
                if (k < path_[c].count)
                    term[static_cast<Eigen::Index>(c)] = path_[c].terms[k];
            most += static_cast<double>(k * (k - 1)) * term.norm() * power;
        }
        if (!ball_.turns())
            return most;
        const TurnBounds turning = turnBounds(ball_.piece, question_.t, question_.t + window);
        return most + (turning.angularSpeed * turning.angularSpeed + turning.angularAcceleration) *
                          lever_.norm();
    }

private:
    // Of a wall that does not turn.
    [[nodiscard]] double alongNormal(double speed) const {
        double window = question_.window;
        if (speed > 0) { // half as near the axis at the least
            window = std::min(window, nearest_.across / (2 * speed));
            const bool isBowl = wall_.part->curved->kind == geometry::Curved::Kind::bowl;
            if (isBowl && nearest_.piece == HollowNearest::Piece::rim)
                window = std::min(window, nearest_.above / speed);
        }
        if (!(window > 0))
            return 0;
        Polynomial gap;
        gap.count = 3;
        for (std::size_t c = 0; c < 3; ++c) {
            gap.count = std::max(gap.count, path_[c].count);
            for (std::size_t k = 1; k < path_[c].count; ++k)
                gap.terms[k] += normal_[static_cast<Eigen::Index>(c)] * path_[c].terms[k];
        }
        gap.terms[0] = gap_;
        if (speed > 0)
            gap.terms[2] -= speed * speed / nearest_.across;
        if (ball_.turns() && lever_.norm() > 0) {
            const TurnBounds turning = turnBounds(ball_.piece, question_.t, question_.t + window);
            gap.terms[1] += normal_.dot(velocityAt(ball_.piece, question_.t).angular.cross(lever_));
            gap.terms[2] -=
                (turning.angularSpeed * turning.angularSpeed + turning.angularAcceleration) *
                lever_.norm() / 2;
        }
        if (!std::isfinite(gap.terms[2]))
            return 0;
        const double root = rootOf(gap, window, gap_ == 0);
        return window < question_.window ? std::min(root, window) : root;
    }

    const HollowQuestion& question_;
    bool isFirst_;
    const PartMotion& ball_;
    const PartMotion& wall_;
    RelativePath path_;  // of the pivots
    Vector lever_, arm_; // of the ball's centre, from the ball's pivot and from the wall's
    HollowNearest nearest_;
    Vector normal_, axis_;
    double gap_ = 0; // with what is allowed to sink in; 0: it touches
};

// A lowest vertex of the other part, over the lid of the hollow, is within its mouth.
bool isOverMouth(const Posed& wall, const Posed& other, const Vector& normal) {
    const geometry::Curved& curved = *wall.part->curved;
    const Vector axis = wall.rotation * curved.axis();
    const double along = axis.dot(normal); // towards the other
    const bool isTube = curved.kind == geometry::Curved::Kind::tube;
    if ((isTube ? std::abs(along) : along) < 1 - 1e-9)
        return false;
    const Vector middle = wall.rotation * curved.center + wall.offset;
    double lowest = HUGE_VAL;
    for (std::size_t v = 0; v < other.part->core.vertices.size(); ++v)
        lowest = std::min(lowest, normal.dot(other.world(v)));
    for (std::size_t v = 0; v < other.part->core.vertices.size(); ++v) {
        const Vector from = other.world(v) - middle;
        if (normal.dot(other.world(v)) <= lowest + 1e-6 * curved.radius() &&
            axis.cross(from).norm() < curved.inner)
            return true;
    }
    return false;
}

Separation separationOf(const Vector& place, double gap, const Vector& normal, double radius,
                        bool isFirst) {
    Separation result;
    result.coreDistance = std::max(gap, 0.0);
    result.gap = gap - radius;
    result.normal = isFirst ? normal : Vector(-normal);
    result.touch = place - (radius + result.gap / 2) * normal;
    return result;
}

Separation ofBall(const Posed& ball, std::size_t vertex, const Posed& wall, bool isFirst) {
    const Vector centre = ball.world(vertex);
    const HollowNearest nearest = geometry::nearestOf(*wall.part->curved, turnedInto(wall, centre));
    Separation result = separationOf(centre, nearest.distance, wall.rotation * nearest.normal,
                                     ball.part->radius, isFirst);
    result.isInside = nearest.isInside();
    return result;
}

// An edge of the one, and the wall.
struct EdgeAtWall {
    std::size_t from = 0, to = 0;
    Separation separation;
    bool isThrough = false; // the wall: that tells how deep, and of no place where they touch
    // Of the angle between the edge and the circle of that radius.
    double sine = 0, radius = 0;
};

// The edges of a part that is, in part, in a hollow, at the circles of its mouths.
class EdgesAtWall {
public:
    EdgesAtWall(const Posed& other, const Posed& wall, bool isFirst)
        : other_(other), wall_(wall), isFirst_(isFirst), curved_(*wall.part->curved) {
        const auto& vertices = other.part->core.vertices;
        for (std::size_t v = 0; v < vertices.size(); ++v)
            own_.emplace_back(curved_.frame.transpose() *
                              (turnedInto(wall, other.world(v)) - curved_.center));
    }

    std::vector<EdgeAtWall> find() {
        if (own_.size() == 2)
            edge(0, 1);
        for (const geometry::Edge& each : other_.part->core.edges)
            edge(each.from, each.to);
        return std::move(found_);
    }

private:
    [[nodiscard]] bool isTube() const { return curved_.kind == geometry::Curved::Kind::tube; }
    [[nodiscard]] double thickness() const { return curved_.radius() - curved_.inner; }
    // Over the plane of the nearer mouth.
    [[nodiscard]] double above(const Vector& own) const {
        return (isTube() ? std::abs(own.y()) : own.y()) - curved_.half();
    }
    [[nodiscard]] double across(const Vector& own) const {
        return isTube() ? std::hypot(own.x(), own.z()) : own.norm();
    }
    void keep(std::size_t from, std::size_t to, const Vector& own, double gap, const Vector& normal,
              bool isThrough = false) {
        const Vector place = wall_.rotation * (curved_.frame * own + curved_.center) + wall_.offset;
        found_.push_back({from, to,
                          separationOf(place, gap, wall_.rotation * (curved_.frame * normal),
                                       other_.part->radius, isFirst_),
                          isThrough});
        found_.back().separation.isInside = true;
    }

    void edge(std::size_t from, std::size_t to) {
        const Vector &a = own_[from], &b = own_[to];
        throughWall(from, to);
        for (const double end : {1.0, -1.0}) {
            if (end < 0 && !isTube())
                continue;
            if (std::max(end * a.y(), end * b.y()) <= curved_.half() - thickness())
                continue; // it is below the mouth
            atCircle(from, to, end, curved_.inner);
            atCircle(from, to, end, curved_.radius());
        }
    }

    // Between the planes of the mouths an edge lies in the hollow, or beyond the wall, or it goes
    // through the wall: then this keeps how deep.
    void throughWall(std::size_t from, std::size_t to) {
        const Vector& a = own_[from];
        const Vector way = own_[to] - a;
        double first = 0, last = 1;
        for (const double end : {1.0, -1.0}) {
            if (end < 0 && !isTube())
                continue;
            const double over = end * a.y() - curved_.half(), rise = end * way.y();
            if (rise > 0)
                last = std::min(last, -over / rise);
            else if (rise < 0)
                first = std::max(first, -over / rise);
            else if (over >= 0)
                return;
        }
        if (!(first < last))
            return;
        const std::array<Vector, 2> ends{a + first * way, a + last * way};
        const double middle = curved_.inner + thickness() / 2;
        const bool isFirstIn = across(ends[0]) < middle, isLastIn = across(ends[1]) < middle;
        Vector along = way, at = a;
        if (isTube())
            along.y() = at.y() = 0;
        const double square = along.squaredNorm();
        const double nearest =
            square > 0 ? std::clamp(-at.dot(along) / square, first, last) : first;
        const double least = across(a + nearest * way);
        if (!isFirstIn && !isLastIn && least >= middle)
            return; // beyond
        const double flattest = std::clamp(way.y() != 0 ? -a.y() / way.y() : 0, first, last);
        double depth = thickness();
        if (isTube()) // how far from the mouths' planes it goes
            depth = std::min(depth, -above(a + flattest * way));
        else
            depth = std::min(depth, -std::min(ends[0].y(), ends[1].y()));
        if (!isFirstIn && !isLastIn)
            depth = std::min(depth, curved_.radius() - least);
        else if (isFirstIn && isLastIn && first == 0 && last == 1)
            return;
        const double slope = std::abs(way.y()) / way.norm();
        bool isBeyond = isFirstIn != isLastIn || !isFirstIn;
        for (const auto& [s, place] : {std::pair(first, ends[0]), {last, ends[1]}})
            if (s == 0 || s == 1) {
                if (isFirstIn != isLastIn)
                    depth = std::min(depth, std::max(-above(place), 0.0));
            } else if (const double beyond = across(place) - curved_.inner; beyond > 0) {
                depth = std::min(depth, beyond * slope);
                isBeyond = true;
            }
        if (!isBeyond || !(depth > 0))
            return;
        const Vector& out = isFirstIn ? ends[1] : ends[0];
        Vector normal = -out;
        if (isTube())
            normal.y() = 0;
        if (depth < thickness())
            normal = Vector(0, isTube() && out.y() < 0 ? -1 : 1, 0);
        keep(from, to, out, -depth, normal.normalized(), true);
    }

    void atCircle(std::size_t from, std::size_t to, double end, double radius) {
        const Vector raise = end * curved_.half() * Vector::UnitY();
        const Vector a = own_[from] - raise, way = own_[to] - own_[from];
        for (const double s : geometry::nearestToCircle(a, way, radius))
            take(from, to, own_[from] + s * way, end, radius);
    }
    void setAngle(const Vector& along, const Vector& radial, double radius) {
        found_.back().sine = along.normalized().cross(radial.cross(Vector(Vector::UnitY()))).norm();
        found_.back().radius = radius;
    }
    // Keeps the place `at`, where an edge comes nearest to a circle. The wall pushes it along the
    // hollow's axis, outwards, or across the axis, away from the wall, or between the two.
    void take(std::size_t from, std::size_t to, const Vector& at, double end, double radius) {
        const double out = radius == curved_.inner ? -1 : 1, rho = std::hypot(at.x(), at.z());
        if (!(rho > 0))
            return;
        const Vector radial(at.x() / rho, 0, at.z() / rho), up = end * Vector::UnitY();
        double over = end * at.y() - curved_.half(), beside = out * (rho - radius);
        const double distance = std::hypot(over, beside);
        const Vector along = own_[to] - own_[from];
        constexpr double near = 1e-7; // of the radius: there the edge itself has the normal
        constexpr double slack = 1e-6;
        if (distance > near * radius) {
            const double least = std::min(over, beside), most = std::max(over, beside);
            const bool isClear = least >= -slack * distance;
            const bool isWithin = most <= slack * distance && distance < thickness();
            if (!isClear && !isWithin)
                return;
            const double sign = isClear ? 1 : -1;
            keep(from, to, at, sign * distance,
                 sign / distance * (over * up + beside * out * radial));
            setAngle(along, radial, radius);
            return;
        }
        Vector normal = along.cross(radial.cross(Vector::UnitY())).normalized();
        double lift = normal.dot(up), push = normal.dot(out * radial);
        if (lift + push < 0) {
            normal = -normal;
            lift = -lift;
            push = -push;
        }
        if (lift < -slack || push < -slack)
            return;
        keep(from, to, at, over * lift + beside * push, normal);
        setAngle(along, radial, radius);
    }

    const Posed& other_;
    const Posed& wall_;
    bool isFirst_;
    const geometry::Curved& curved_;
    std::vector<Vector> own_; // vertices in the hollow's own axes
    std::vector<EdgeAtWall> found_;
};

bool isInHollow(const Posed& other, std::size_t vertex, const Posed& wall) {
    const geometry::Curved& curved = *wall.part->curved;
    const Vector own =
        curved.frame.transpose() * (turnedInto(wall, other.world(vertex)) - curved.center);
    return curved.kind == geometry::Curved::Kind::tube
               ? std::abs(own.y()) < curved.half() && std::hypot(own.x(), own.z()) < curved.inner
               : own.y() < 0 && own.norm() < curved.inner;
}

// The hull separates a shape that is no sphere where that is outside of it, or only just within its
// wall. Deep in the hull its own depth would be vague.
std::optional<Separation> fromOutside(const Posed& first, const Posed& second) {
    const bool isFirst = !first.part->isHollow();
    const Posed &other = isFirst ? first : second, &wall = isFirst ? second : first;
    if (other.part->isSphere())
        return std::nullopt;
    for (std::size_t v = 0; v < other.part->core.vertices.size(); ++v)
        if (isInHollow(other, v, wall))
            return std::nullopt;
    const Separation hull = separateCurved(first, second);
    const double thickness = wall.part->curved->radius() - wall.part->curved->inner;
    if (hull.gap <= -thickness / 2 ||
        isOverMouth(wall, other, isFirst ? hull.normal : Vector(-hull.normal)))
        return std::nullopt;
    return hull;
}

} // namespace

Separation separateHollow(const Posed& first, const Posed& second) {
    if (const auto outside = fromOutside(first, second))
        return *outside;
    const bool isFirst = !first.part->isHollow();
    const Posed &other = isFirst ? first : second, &wall = isFirst ? second : first;
    Separation least = ofBall(other, 0, wall, isFirst);
    for (std::size_t v = 1; v < other.part->core.vertices.size(); ++v)
        if (Separation one = ofBall(other, v, wall, isFirst); one.gap < least.gap)
            least = std::move(one);
    for (EdgeAtWall& edge : EdgesAtWall(other, wall, isFirst).find())
        if (edge.separation.gap < least.gap)
            least = std::move(edge.separation);
    least.isInside = least.isInside || !other.part->isSphere();
    return least;
}

std::vector<BallAtWall> ballsAtWall(const Posed& first, const Posed& second, double tolerance) {
    std::vector<BallAtWall> found;
    if (fromOutside(first, second))
        return found;
    const bool isFirst = !first.part->isHollow();
    const Posed &other = isFirst ? first : second, &wall = isFirst ? second : first;
    for (std::size_t v = 0; v < other.part->core.vertices.size(); ++v)
        if (Separation one = ofBall(other, v, wall, isFirst); std::abs(one.gap) <= tolerance)
            found.push_back({v, std::move(one)});
    for (EdgeAtWall& edge : EdgesAtWall(other, wall, isFirst).find())
        if (!edge.isThrough && std::abs(edge.separation.gap) <= tolerance)
            found.push_back({std::nullopt, std::move(edge.separation)});
    return found;
}

double roomInHollow(const PartPair& pair) {
    const bool isFirst = !pair.first.part->isHollow(); // the ball
    const Part &ball = *(isFirst ? pair.first : pair.second).part,
               &wall = *(isFirst ? pair.second : pair.first).part;
    return wall.curved->inner - ball.radius;
}

namespace {

// How long an edge stays clear of a circle. The gap is along the common normal of the two, which
// turns as the place where they are nearest goes along both: with V the speed of the edge's ends,
// w that of its turning, r the circle's radius and f the angle between the two, the gap's second
// derivative is above -(a + 4 V^2 / (r sin^2 f) + 4 V w / sin f) until that place has gone r/4.
class EdgePassage {
public:
    EdgePassage(const HollowQuestion& question, const PartMotion& other, const PartMotion& wall,
                const EdgeAtWall& edge, const Passage& from, const Passage& to)
        : question_(question), other_(other), wall_(wall), edge_(edge), from_(from), to_(to) {
        gap_ = countedGap(question, edge.separation.gap);
    }

    [[nodiscard]] double clear() const {
        const double speed = speedWithin(question_.window);
        return std::max(clearAtSpeed(gap_, speed, question_.window), alongNormal());
    }

private:
    [[nodiscard]] double speedWithin(double window) const {
        return std::max(from_.speedWithin(window), to_.speedWithin(window));
    }
    [[nodiscard]] double alongNormal() const {
        constexpr double least = 0.01; // sine
        if (wall_.turns() || edge_.sine < least)
            return 0;
        double window = question_.window;
        const double speed = speedWithin(window);
        if (speed > 0)
            window = std::min(window, edge_.radius * edge_.sine / (4 * speed));
        const double turning =
            other_.turns()
                ? turnBounds(other_.piece, question_.t, question_.t + window).angularSpeed
                : 0;
        Polynomial gap;
        gap.count = 3;
        gap.terms[0] = gap_;
        gap.terms[1] = -contactOf(question_.pair, question_.t, edge_.separation).closingSpeed;
        gap.terms[2] =
            -(std::max(from_.accelerationWithin(window), to_.accelerationWithin(window)) +
              4 * speed * (speed / (edge_.radius * edge_.sine) + turning) / edge_.sine) /
            2;
        if (!std::isfinite(gap.terms[1] + gap.terms[2]))
            return 0;
        const double root = rootOf(gap, window, gap_ == 0);
        return window < question_.window ? std::min(root, window) : root;
    }

    const HollowQuestion& question_;
    const PartMotion& other_;
    const PartMotion& wall_;
    const EdgeAtWall& edge_;
    const Passage& from_;
    const Passage& to_;
    double gap_ = 0; // 0: it touches
};

} // namespace

double clearFor(const HollowQuestion& question) {
    const PartPair& pair = question.pair;
    const bool isFirst = !pair.first.part->isHollow();
    const PartMotion &other = isFirst ? pair.first : pair.second,
                     &wall = isFirst ? pair.second : pair.first;
    double clear = 2 * question.window;
    std::vector<Passage> ends;
    for (std::size_t v = 0; v < other.part->core.vertices.size() && clear > 0; ++v) {
        ends.emplace_back(question, v);
        clear = std::min(clear, ends.back().clear());
    }
    if (!(clear > 0) || ends.size() < 2)
        return clear;
    const Vector origin = pair.originAt(question.t);
    const Posed posed = other.posedAt(question.t, origin),
                hollow = wall.posedAt(question.t, origin);
    for (const EdgeAtWall& edge : EdgesAtWall(posed, hollow, isFirst).find())
        clear = std::min(
            clear,
            EdgePassage(question, other, wall, edge, ends[edge.from], ends[edge.to]).clear());
    return clear;
}

} // namespace collision
