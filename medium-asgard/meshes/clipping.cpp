#include "meshes/clipping.h"

#include <algorithm>
#include <array>

namespace meshes {

namespace {

using Facet = Piece::Facet;

bool lexicographic(const Vector& a, const Vector& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

// Where the edge passes the plane: the same place, whichever way the edge is looked at.
Vector crossing(const Vector& a, double sa, const Vector& b, double sb) {
    if (lexicographic(b, a))
        return crossing(b, sb, a, sa);
    return a + (sa / (sa - sb)) * (b - a);
}

class Cut {
public:
    Cut(const Plane& plane, double tolerance, Piece& result)
        : plane_(plane), tolerance_(tolerance), result_(result) {}

    void add(const Facet& facet) {
        const std::array<Vector, 3> p = {facet.a, facet.b, facet.c};
        std::array<double, 3> s{};
        int above = 0, on = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            s[k] = plane_.distance(p[k]);
            if (std::abs(s[k]) <= tolerance_)
                s[k] = 0;
            above += s[k] > 0;
            on += s[k] == 0;
        }
        // In the plane: the solid is on the side that the facet looks away from.
        if (on == 3 && (p[1] - p[0]).cross(p[2] - p[0]).dot(plane_.normal) <= 0)
            return;
        if (above == 0)
            take(facet, s);
        else if (above + on < 3)
            clip(facet, p, s);
    }

    // A triangle from the apex to each edge in the plane closes the chain.
    void close() {
        for (const auto& [from, to] : edges_)
            if (const Vector& apex = edges_[0].first; from != apex && to != apex)
                result_.facets.push_back({to, from, apex, true});
    }

private:
    void take(const Facet& facet, const std::array<double, 3>& s) {
        if (s[0] < 0 && s[1] < 0 && s[2] < 0) {
            result_.facets.push_back(facet);
            return;
        }
        const std::array<Vector, 3> p = {facet.a, facet.b, facet.c};
        if (std::ranges::all_of(s, [](double x) { return x == 0; }) ||
            std::ranges::any_of(s, [](double x) { return x < 0; })) {
            result_.facets.push_back(facet);
            for (std::size_t k = 0; k < 3; ++k)
                if (s[k] == 0 && s[(k + 1) % 3] == 0)
                    edges_.emplace_back(p[k], p[(k + 1) % 3]);
        }
    }
    void clip(const Facet& facet, const std::array<Vector, 3>& p, const std::array<double, 3>& s) {
        std::array<Vector, 4> kept;
        std::array<bool, 4> in{}; // the plane
        std::size_t count = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (s[k] <= 0) {
                in[count] = s[k] == 0;
                kept[count++] = p[k];
            }
            if (s[k] * s[next] < 0) {
                in[count] = true;
                kept[count++] = crossing(p[k], s[k], p[next], s[next]);
            }
        }
        for (std::size_t k = 2; k < count; ++k)
            result_.facets.push_back({kept[0], kept[k - 1], kept[k], facet.cap});
        for (std::size_t k = 0; k < count; ++k)
            if (in[k] && in[(k + 1) % count])
                edges_.emplace_back(kept[k], kept[(k + 1) % count]);
    }

    Plane plane_;
    double tolerance_;
    Piece& result_;
    std::vector<std::pair<Vector, Vector>> edges_;
};

// Where the newest cut meets two others, within all, inside the solid.
void addCorners(Piece& piece, const Solid& solid, double tolerance) {
    const Plane& newest = piece.cuts.back();
    for (std::size_t i = 0; i + 1 < piece.cuts.size(); ++i)
        for (std::size_t j = i + 1; j + 1 < piece.cuts.size(); ++j) {
            Eigen::Matrix3d rows;
            rows << newest.normal.transpose(), piece.cuts[i].normal.transpose(),
                piece.cuts[j].normal.transpose();
            if (std::abs(rows.determinant()) < 1e-6)
                continue;
            const Eigen::Matrix3d inverse = rows.inverse();
            const Vector place =
                inverse * Vector(newest.offset, piece.cuts[i].offset, piece.cuts[j].offset);
            const bool within = std::ranges::all_of(
                piece.cuts, [&](const Plane& cut) { return cut.distance(place) <= tolerance; });
            // Asked a little within the piece: the surface itself may pass through the corner.
            const Vector inwards = -1000 * tolerance * (inverse * Vector::Ones());
            if (within && windingNumber(solid.surface, place + inwards) > 0.5)
                piece.corners.push_back(place);
        }
}

} // namespace

double Piece::volume() const {
    if (facets.empty())
        return 0;
    const Vector origin = facets[0].a;
    double six = 0;
    for (const Facet& f : facets)
        six += (f.a - origin).dot((f.b - origin).cross(f.c - origin));
    return six / 6;
}

std::vector<Vector> Piece::points() const {
    std::vector<Vector> all = corners;
    for (const Facet& f : facets)
        if (!f.cap)
            all.insert(all.end(), {f.a, f.b, f.c});
    std::ranges::sort(all, lexicographic);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

Piece pieceOf(const Solid& solid) {
    Piece piece;
    const auto& v = solid.surface.vertices;
    for (const auto& t : solid.surface.triangles)
        piece.facets.push_back({v[t[0]], v[t[1]], v[t[2]]});
    return piece;
}

Piece below(const Piece& piece, const Plane& plane, const Solid& solid, double tolerance) {
    Piece result;
    result.cuts = piece.cuts;
    result.cuts.push_back(plane);
    for (const Vector& corner : piece.corners)
        if (plane.distance(corner) <= tolerance)
            result.corners.push_back(corner);
    Cut cut(plane, tolerance, result);
    for (const Facet& facet : piece.facets)
        cut.add(facet);
    cut.close();
    addCorners(result, solid, tolerance);
    return result;
}

} // namespace meshes
