#include "collision/part_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace collision {

namespace {

constexpr double unnoticed = 1e-10; // of the smaller part's size: a depth that a step may pass over
constexpr double epsilon = std::numeric_limits<double>::epsilon();

} // namespace

Posed PartMotion::posedAt(double t, const Vector& origin) const {
    const Quaternion attitude = attitudeAt(piece, t);
    Posed posed{part, attitude.toRotationMatrix(), positionAt(piece, t) - origin};
    posed.offset -= posed.rotation * pivot;
    return posed;
}

PartMotion partMotion(const MovingShape& moving, std::size_t part, double t) {
    const Part& p = moving.shape().parts[part];
    const Vector pivot = moving.pivot();
    return {&p, moving.pieceAt(t), pivot, geometry::radiusAbout(p, pivot)};
}

Separation PartPair::separationAt(double t, WarmStart& warm) const {
    const Vector origin = originAt(t);
    return separate(first.posedAt(t, origin), second.posedAt(t, origin), warm);
}

double PartPair::roundOff(double t) const {
    const Vector a = positionAt(first.piece, t), b = positionAt(second.piece, t);
    return 4 * epsilon *
           (first.reach + second.reach + a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

double PartPair::speedScale(double t) const {
    const Velocity a = velocityAt(first.piece, t), b = velocityAt(second.piece, t);
    return a.linear.norm() + b.linear.norm() + a.angular.norm() * first.reach +
           b.angular.norm() * second.reach;
}

double PartPair::leastApproach(double t) const {
    return std::max(approachThreshold, slack) * speedScale(t);
}

double PartPair::smallerSize() const {
    const auto sizeOf = [](const Part& part) {
        if (part.isPlane())
            return HUGE_VAL;
        return geometry::radiusAbout(part, part.core.vertices[0]) + part.radius;
    };
    return std::min(sizeOf(*first.part), sizeOf(*second.part));
}

double PartPair::unnoticedDepth(double t) const {
    return std::max(std::max(unnoticed, slack) * smallerSize(),
                    8 * roundOff(t) + 8 * epsilon * std::abs(t) * relativeSpeed(t));
}

double PartPair::relativeSpeed(double t) const {
    const Velocity a = velocityAt(first.piece, t), b = velocityAt(second.piece, t);
    return (a.linear - b.linear).norm() + a.angular.norm() * first.reach +
           b.angular.norm() * second.reach;
}

PartPair partPair(const MovingShape& first, std::size_t firstPart, const MovingShape& second,
                  std::size_t secondPart, double t, Slack slack) {
    PartPair pair{partMotion(first, firstPart, t), partMotion(second, secondPart, t), slack};
    for (auto [plane, other] : {std::pair(&pair.first, &pair.second), {&pair.second, &pair.first}})
        if (plane->part->isPlane() && plane->turns())
            plane->reach +=
                (positionAt(plane->piece, t) - positionAt(other->piece, t)).norm() + other->reach;
    for (const PartMotion* p : {&pair.first, &pair.second})
        pair.cores += geometry::radiusAbout(*p->part, p->part->core.vertices[0]) - p->part->radius;
    return pair;
}

} // namespace collision
