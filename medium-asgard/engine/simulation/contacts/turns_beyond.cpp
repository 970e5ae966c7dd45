#include "contacts/turns_beyond.h"

#include <algorithm>
#include <array>

namespace simulation {
namespace {

// How far along the inward normal of a side's plane, in one piece from t on:
//     in + rate s + bend s^2
struct Inward {
    double in = 0, rate = 0, bend = 0;

    void add(double along, const solution::Piece& piece, double t) {
        const auto& c = piece.coefficients;
        const double s = (t - piece.origin) / piece.scale;
        in += along * piece.value(t);
        if (c.size() > 1)
            rate += along * (c[1] + (c.size() > 2 ? 2 * c[2] * s : 0)) / piece.scale;
        if (c.size() > 2)
            bend += along * c[2] / (piece.scale * piece.scale);
    }
};

} // namespace

void addTurnsBeyond(const BearingFace& bearing, const BodyPath& path, collision::Interval during,
                    std::vector<double>& times) {
    const geometry::Polyhedron& core = bearing.part.core;
    const geometry::Pose& support = bearing.record.start;
    const auto face = std::ranges::max_element(core.faces, {}, [&](const geometry::Face& f) {
        return f.normal.dot(bearing.footing.constraints[0].normal);
    });
    for (double t = during.from; t < during.to;) {
        std::array<solution::Piece, 3> pieces;
        double end = during.to;
        for (std::size_t k = 0; k < 3; ++k) {
            pieces[k] = path.histories.piece(path.first + k, t);
            end = pieces[k].until > t ? std::min(end, pieces[k].until) : end;
        }
        const bool isParabola = std::ranges::all_of(
            pieces, [](const solution::Piece& p) { return p.coefficients.size() <= 3; });
        for (std::size_t i = 0; isParabola && i < face->vertices.size(); ++i) {
            const Vector& a = core.vertices[face->vertices[i]];
            const Vector& b = core.vertices[face->vertices[(i + 1) % face->vertices.size()]];
            const Vector n = support.attitude * face->normal.cross(b - a).normalized();
            Inward way;
            for (std::size_t k = 0; k < 3; ++k)
                way.add(n[static_cast<Eigen::Index>(k)], pieces[k], t);
            way.in -= n.dot(support.position + support.attitude * (a - bearing.record.centroid));
            const double turn = way.bend > 0 ? -way.rate / (2 * way.bend) : 0;
            if (turn > 0 && t + turn < end && way.in + way.rate * turn / 2 < 0)
                times.push_back(t + turn);
        }
        t = end;
    }
}

} // namespace simulation
