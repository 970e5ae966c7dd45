#include "complementarity/at_centre.h"

#include <algorithm>

namespace complementarity {

AtCentre::AtCentre(const Law& disc, const Vector& forces)
    : centre(centreOf(disc, forces)),
      force(forcesAt(centre, forces.segment(disc.first, disc.rows))),
      byRows(Matrix::Identity(disc.rows, disc.rows)),
      moves(Matrix::Zero(disc.rows - 1, disc.normal < 0 ? 0 : disc.normals)),
      byNormals(Matrix::Zero(disc.rows, moves.cols())) {
    const Index last = disc.rows - 1;
    byRows.row(last).head(last) = -centre.transpose();
    if (disc.levers.size() == 0)
        return;
    const double pressed = forces.segment(disc.normal, disc.normals).sum();
    if (pressed > 0)
        moves = (disc.levers.colwise() - centre) / pressed;
    byNormals.row(last) = -forces.segment(disc.first, last).transpose() * moves;
}

Vector forceOf(const Law& slip, const Vector& forces) {
    const Vector centre = centreOf(slip, forces);
    return forcesFrom(centre, -radiusOf(slip, forces) * directionAt(centre, slip));
}

Matrix changesOf(const Law& slip, const Vector& forces) {
    Matrix changes = Matrix::Zero(slip.rows, slip.normal < 0 ? 0 : slip.normals);
    if (slip.normal < 0 ||
        slip.radius + slip.coefficient * forces.segment(slip.normal, slip.normals).sum() < 0)
        return changes;
    const AtCentre at(slip, forces);
    const double radius = radiusOf(slip, forces);
    const Vector velocity = ratesAt(at.centre, slip.velocity) + slip.beside;
    const double speed = std::max(velocity.norm(), 1e-300);
    const Vector direction = velocity / speed, ahead = -radius * direction;
    const Index last = slip.rows - 1;
    for (Index n = 0; n < slip.normals; ++n) {
        Vector moved = Vector::Zero(slip.rows); // of the velocity
        moved.head(last) = slip.velocity[last] * at.moves.col(n);
        const Vector turned = (moved - direction.dot(moved) * direction) / speed;
        changes.col(n) = forcesFrom(at.centre, -slip.coefficient * direction - radius * turned);
        changes(last, n) += at.moves.col(n).dot(ahead.head(last));
    }
    return changes;
}

} // namespace complementarity
