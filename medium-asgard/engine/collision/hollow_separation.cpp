#include "collision/hollow_separation.h"

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

// The ball and the wall now, and how they move within the window.
class Passage {
public:
    explicit Passage(const HollowQuestion& question)
        : question_(question), isFirst_(question.pair.first.part->isSphere()),
          ball_(isFirst_ ? question.pair.first : question.pair.second),
          wall_(isFirst_ ? question.pair.second : question.pair.first),
          path_(relativePath(ball_.piece, wall_.piece, question.t)) {
        const Posed ball = ball_.posedAt(question.t, positionAt(ball_.piece, question.t));
        const Posed wall = wall_.posedAt(question.t, positionAt(wall_.piece, question.t));
        lever_ = ball.world(0);
        arm_ = positionAt(ball_.piece, question.t) - positionAt(wall_.piece, question.t) + lever_;
        nearest_ = geometry::nearestOf(*wall.part->curved, turnedInto(wall, arm_));
        normal_ = wall.rotation * nearest_.normal;
        axis_ = wall.rotation * wall.part->curved->axis();
    }

    [[nodiscard]] double clear() {
        const double speed = speedWithin(question_.window);
        double clear = 0;
        if (question_.gap > 0)
            clear = speed > 0 ? question_.gap / speed : 2 * question_.window;
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
        gap.terms[0] = question_.isLeaving ? 0 : question_.gap;
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
        const double root = rootOf(gap, window, question_.isLeaving);
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
};

} // namespace

Separation separateHollow(const Posed& first, const Posed& second) {
    const bool isFirst = first.part->isSphere(); // the ball
    const Posed &ball = isFirst ? first : second, &wall = isFirst ? second : first;
    const Vector centre = ball.world(0);
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

double roomInHollow(const PartPair& pair) {
    const bool isFirst = pair.first.part->isSphere(); // the ball
    const Part &ball = *(isFirst ? pair.first : pair.second).part,
               &wall = *(isFirst ? pair.second : pair.first).part;
    return wall.curved->inner - ball.radius;
}

double clearFor(const HollowQuestion& question) { return Passage(question).clear(); }

} // namespace collision
