#include "collision/part_motion.h"

#include <algorithm>
#include <limits>

namespace collision {

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
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    return 4 * epsilon *
           (first.reach + second.reach + a.cwiseAbs().maxCoeff() + b.cwiseAbs().maxCoeff());
}

double PartPair::speedScale(double t) const {
    const Velocity a = velocityAt(first.piece, t), b = velocityAt(second.piece, t);
    return a.linear.norm() + b.linear.norm() + a.angular.norm() * first.reach +
           b.angular.norm() * second.reach;
}

double PartPair::relativeSpeed(double t) const {
    const Velocity a = velocityAt(first.piece, t), b = velocityAt(second.piece, t);
    return (a.linear - b.linear).norm() + a.angular.norm() * first.reach +
           b.angular.norm() * second.reach;
}

PartPair partPair(const MovingShape& first, std::size_t firstPart, const MovingShape& second,
                  std::size_t secondPart, double t) {
    PartPair pair{partMotion(first, firstPart, t), partMotion(second, secondPart, t)};
    for (const PartMotion* p : {&pair.first, &pair.second})
        pair.cores += geometry::radiusAbout(*p->part, p->part->core.vertices[0]) - p->part->radius;
    return pair;
}

} // namespace collision
