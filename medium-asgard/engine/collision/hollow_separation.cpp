#include "collision/hollow_separation.h"

#include "collision/curved_separation.h"
#include "collision/polynomial.h"
#include "collision/spheres.h"

#include <algorithm>
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
        const double own = nearest_.distance - ball_.part->radius;
        if (!question.isLeaving || own > question.pair.unnoticedDepth(question.t))
            gap_ = std::max({own, question.gap, 0.0});
    }

    [[nodiscard]] double clear() {
        const double speed = speedWithin(question_.window);
        double clear = 0;
        if (gap_ > 0)
            clear = speed > 0 ? gap_ / speed : 2 * question_.window;
        if (!wall_.turns())
            clear = std::max(clear, alongNormal(speed));
        return clear;
    }

private:
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

// The other part lies on the lid of the hollow, and nothing of it on the wall beside.
bool isOverLid(const Posed& wall, const Posed& other, const Vector& normal) {
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
            axis.cross(from).norm() >= curved.inner)
            return false;
    }
    return true;
}

Separation ofBall(const Posed& ball, std::size_t vertex, const Posed& wall, bool isFirst) {
    const Vector centre = ball.world(vertex);
    const HollowNearest nearest = geometry::nearestOf(*wall.part->curved, turnedInto(wall, centre));
    const Vector normal = wall.rotation * nearest.normal;
    Separation result;
    result.coreDistance = std::max(nearest.distance, 0.0);
    result.gap = nearest.distance - ball.part->radius;
    result.normal = isFirst ? normal : Vector(-normal);
    result.isInside = nearest.isInside();
    result.touch = centre - (ball.part->radius + result.gap / 2) * normal;
    return result;
}

// The hull separates a shape that is no sphere where that is outside of it, or only just within its
// wall.
std::optional<Separation> fromOutside(const Posed& first, const Posed& second) {
    const bool isFirst = !first.part->isHollow();
    const Posed &other = isFirst ? first : second, &wall = isFirst ? second : first;
    if (other.part->isSphere())
        return std::nullopt;
    const Separation hull = separateCurved(first, second);
    const double thickness = wall.part->curved->radius() - wall.part->curved->inner;
    if (hull.gap <= -thickness / 2 ||
        isOverLid(wall, other, isFirst ? hull.normal : Vector(-hull.normal)))
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
    return found;
}

double roomInHollow(const PartPair& pair) {
    const bool isFirst = !pair.first.part->isHollow(); // the ball
    const Part &ball = *(isFirst ? pair.first : pair.second).part,
               &wall = *(isFirst ? pair.second : pair.first).part;
    return wall.curved->inner - ball.radius;
}

double clearFor(const HollowQuestion& question) {
    const Part& other =
        *(question.pair.first.part->isHollow() ? question.pair.second : question.pair.first).part;
    double clear = 2 * question.window;
    for (std::size_t v = 0; v < other.core.vertices.size() && clear > 0; ++v)
        clear = std::min(clear, Passage(question, v).clear());
    return clear;
}

} // namespace collision
