#include "collision/broad_phase.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

// The box of the pivot's path: per coordinate, the hull of the Bernstein coefficients would be
// tighter; the triangle inequality about the middle is enough to tell who cannot meet.
geometry::Box pathBounds(const MotionPiece& piece, double from, double to) {
    const double middle = ((from + to) / 2 - piece.from) / piece.scale;
    const double radius = (to - from) / 2 / piece.scale;
    std::vector<Vector> c(piece.position);
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        for (std::size_t k = c.size() - 1; k-- > i;)
            c[k] += middle * c[k + 1];
    Vector spread = Vector::Zero();
    double power = radius;
    for (std::size_t k = 1; k < c.size(); ++k, power *= radius)
        spread += c[k].cwiseAbs() * power;
    return {c[0] - spread, c[0] + spread};
}

void grow(geometry::Box& box, double by) {
    box.min() -= Vector::Constant(by);
    box.max() += Vector::Constant(by);
}

} // namespace

geometry::Box boundsDuring(const MovingShape& moving, double from, double to) {
    geometry::Box box;
    if (std::ranges::any_of(moving.shape().parts, &geometry::Part::isPlane))
        return {Vector::Constant(-everywhere), Vector::Constant(everywhere)};
    const double reach = geometry::radiusAbout(moving.shape(), moving.pivot());
    for (double t = from;;) {
        const MotionPiece& piece = moving.pieceAt(t);
        const double end = piece.until > t ? std::min(piece.until, to) : to;
        if (piece.position.size() == 1 && piece.attitude.size() == 1) {
            // It stands still: its own box, not that of its sphere (floors are wide and thin).
            const Quaternion attitude = attitudeAt(piece, t);
            box.extend(geometry::bounds(moving.shape(),
                                        {piece.position[0] - attitude * moving.pivot(), attitude}));
        } else {
            geometry::Box path = pathBounds(piece, t, end);
            grow(path, reach);
            box.extend(path);
        }
        if (!(end < to))
            break;
        t = end;
    }
    // Rounding of the bounds themselves.
    grow(box, 1e-12 * (box.max().cwiseAbs() + box.min().cwiseAbs()).maxCoeff());
    return box;
}

} // namespace collision
