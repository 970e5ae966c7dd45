#include "element_edits/attitude.h"

#include <cmath>

namespace editing {

using geometry::Vector;

Turn turnOf(const Vector& rotationVector, const Vector& like) {
    // The same attitude by the shorter way round.
    const Vector shortest =
        geometry::toRotationVector(geometry::fromRotationVector(rotationVector));
    const double angle = shortest.norm();
    if (angle == 0)
        return {0, like.normalized()};
    Eigen::Index largest = 0;
    shortest.cwiseAbs().maxCoeff(&largest);
    const double along = shortest.dot(like);
    const double sense = (along == 0 ? shortest[largest] : along) < 0 ? -1 : 1;
    return {sense * angle * 180 / M_PI, sense * shortest / angle};
}

Vector rotationVectorOf(const Turn& turn) {
    const double length = turn.axis.norm();
    if (length == 0)
        return Vector::Zero();
    return turn.axis * (turn.degrees * M_PI / 180 / length);
}

} // namespace editing
