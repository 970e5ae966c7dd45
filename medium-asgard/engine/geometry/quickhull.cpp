#include "geometry/quickhull.h"

#include "geometry/predicates.h"

#include <limits>
#include <utility>

namespace geometry {

namespace {

constexpr std::size_t noIndex = std::numeric_limits<std::size_t>::max();

struct Facet {
    Triangle corners{};
    std::array<std::size_t, 3> across{noIndex, noIndex, noIndex}; // beyond the edge corner i -> i+1
    std::vector<std::size_t> outside;                             // points that see this facet
    bool alive = true;
    std::size_t seenFrom = noIndex; // the point that was last found to see it
};

struct HorizonEdge {
    std::size_t from = 0, to = 0;
    std::size_t beyond = 0; // the facet that stays
};

class Builder {
public:
    Builder(const std::vector<Vector>& points, std::array<std::size_t, 4> first,
            const std::function<void()>& meanwhile)
        : points_(points), meanwhile_(meanwhile) {
        makeTetrahedron(first);
        std::vector<std::size_t> rest;
        for (std::size_t i = 0; i < points.size(); ++i)
            if (i != first[0] && i != first[1] && i != first[2] && i != first[3])
                rest.push_back(i);
        distribute(rest, 0);
    }

    Triangulation run() {
        for (std::size_t f = 0; f < facets_.size(); ++f)
            while (facets_[f].alive && !facets_[f].outside.empty())
                addPoint(f);
        std::vector<std::size_t> places(facets_.size(), noIndex);
        Triangulation result;
        for (std::size_t f = 0; f < facets_.size(); ++f)
            if (facets_[f].alive) {
                places[f] = result.triangles.size();
                result.triangles.push_back(facets_[f].corners);
            }
        for (const Facet& f : facets_)
            if (f.alive)
                result.across.push_back(
                    {places[f.across[0]], places[f.across[1]], places[f.across[2]]});
        result.visits = visits_;
        return result;
    }

private:
    [[nodiscard]] bool sees(std::size_t p, const Facet& f) {
        constexpr std::size_t seldom = 4096;
        if (++visits_ % seldom == 0 && meanwhile_)
            meanwhile_();
        // orientation() is positive where a, b, c look clockwise, which is inside.
        return orientation(points_[f.corners[0]], points_[f.corners[1]], points_[f.corners[2]],
                           points_[p]) > 0;
    }

    void makeTetrahedron(std::array<std::size_t, 4> v) {
        if (orientation(points_[v[0]], points_[v[1]], points_[v[2]], points_[v[3]]) > 0)
            std::swap(v[1], v[2]);
        // Now v[3] lies below the triangle v0 v1 v2.
        const std::array<Triangle, 4> corners{
            Triangle{v[0], v[1], v[2]}, Triangle{v[1], v[0], v[3]}, Triangle{v[2], v[1], v[3]},
            Triangle{v[0], v[2], v[3]}};
        for (const Triangle& t : corners)
            facets_.push_back({t, {noIndex, noIndex, noIndex}, {}, true, noIndex});
        for (std::size_t f = 0; f < 4; ++f)
            for (std::size_t g = 0; g < 4; ++g)
                if (f != g)
                    joinWhereTheyMeet(f, g);
    }

    void joinWhereTheyMeet(std::size_t f, std::size_t g) {
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                if (facets_[f].corners[i] == facets_[g].corners[(j + 1) % 3] &&
                    facets_[f].corners[(i + 1) % 3] == facets_[g].corners[j])
                    facets_[f].across[i] = g;
    }

    // Each point goes to the first facet from `from` on that it sees; one that sees none is inside.
    void distribute(const std::vector<std::size_t>& points, std::size_t from) {
        for (std::size_t p : points)
            for (std::size_t f = from; f < facets_.size(); ++f)
                if (sees(p, facets_[f])) {
                    facets_[f].outside.push_back(p);
                    break;
                }
    }

    // The furthest point is a vertex of the hull (up to rounding, which costs time only).
    [[nodiscard]] std::size_t furthestOutside(const Facet& f) const {
        const Vector& a = points_[f.corners[0]];
        const Vector normal = (points_[f.corners[1]] - a).cross(points_[f.corners[2]] - a);
        std::size_t best = 0;
        double furthest = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < f.outside.size(); ++i)
            if (const double d = normal.dot(points_[f.outside[i]] - a); d > furthest) {
                furthest = d;
                best = i;
            }
        return best;
    }

    void addPoint(std::size_t start) {
        auto& outside = facets_[start].outside;
        const std::size_t which = furthestOutside(facets_[start]);
        const std::size_t p = outside[which];
        outside.erase(outside.begin() + static_cast<std::ptrdiff_t>(which));

        std::vector<std::size_t> visible;
        const std::vector<HorizonEdge> horizon = findHorizon(p, start, visible);
        const std::size_t firstNew = facets_.size();
        makeCone(p, horizon);
        std::vector<std::size_t> orphans;
        for (std::size_t f : visible) {
            facets_[f].alive = false;
            orphans.insert(orphans.end(), facets_[f].outside.begin(), facets_[f].outside.end());
            std::vector<std::size_t>().swap(facets_[f].outside);
        }
        distribute(orphans, firstNew);
    }

    // The facets that p sees are connected, and their border is one simple loop: p pushed a little
    // towards the inside sees the same ones and lies in no facet's plane.
    std::vector<HorizonEdge> findHorizon(std::size_t p, std::size_t start,
                                         std::vector<std::size_t>& visible) {
        std::vector<HorizonEdge> horizon;
        visible.push_back(start);
        facets_[start].seenFrom = p;
        for (std::size_t next = 0; next < visible.size(); ++next) {
            const std::size_t f = visible[next];
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t g = facets_[f].across[i];
                if (facets_[g].seenFrom == p)
                    continue;
                if (sees(p, facets_[g])) {
                    facets_[g].seenFrom = p;
                    visible.push_back(g);
                } else {
                    horizon.push_back({facets_[f].corners[i], facets_[f].corners[(i + 1) % 3], g});
                }
            }
        }
        return horizon;
    }

    void makeCone(std::size_t p, const std::vector<HorizonEdge>& horizon) {
        const std::size_t firstNew = facets_.size();
        startingAt_.resize(points_.size(), noIndex);
        for (std::size_t i = 0; i < horizon.size(); ++i) {
            const HorizonEdge& e = horizon[i];
            facets_.push_back({{e.from, e.to, p}, {e.beyond, noIndex, noIndex}, {}, true, noIndex});
            Facet& beyond = facets_[e.beyond];
            for (std::size_t j = 0; j < 3; ++j)
                if (beyond.corners[j] == e.to && beyond.corners[(j + 1) % 3] == e.from)
                    beyond.across[j] = firstNew + i;
            startingAt_[e.from] = firstNew + i;
        }
        for (std::size_t f = firstNew; f < facets_.size(); ++f) {
            const std::size_t next = startingAt_[facets_[f].corners[1]];
            facets_[f].across[1] = next;
            facets_[next].across[2] = f;
        }
    }

    const std::vector<Vector>& points_;
    const std::function<void()>& meanwhile_;
    std::size_t visits_ = 0;
    std::vector<Facet> facets_;
    std::vector<std::size_t> startingAt_; // of each vertex of the horizon: the new facet
};

} // namespace

Triangulation quickhull(const std::vector<Vector>& points, std::array<std::size_t, 4> first,
                        const std::function<void()>& meanwhile) {
    return Builder(points, first, meanwhile).run();
}

} // namespace geometry
