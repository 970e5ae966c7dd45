#include "geometry/hull.h"

#include "geometry/predicates.h"
#include "geometry/quickhull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

namespace geometry {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

bool before(const Vector& a, const Vector& b) {
    return std::tie(a.x(), a.y(), a.z()) < std::tie(b.x(), b.y(), b.z());
}

// Indices of the distinct points, the first of equal ones, ordered by place.
std::vector<std::size_t> distinct(const std::vector<Vector>& points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return before(points[a], points[b]); });
    order.erase(std::unique(order.begin(), order.end(),
                            [&](std::size_t a, std::size_t b) { return points[a] == points[b]; }),
                order.end());
    return order;
}

template <typename Measure>
std::size_t furthest(const std::vector<Vector>& points, const Measure& measure) {
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < points.size(); ++i)
        if (const double d = measure(points[i]); d > most) {
            most = d;
            best = i;
        }
    return best;
}

struct Start {
    std::array<std::size_t, 4> corners{};
    std::optional<HullRefusal> refusal;
};

// Four points far apart: two ends, then the furthest from their line, then from the plane.
Start findStart(const std::vector<Vector>& points) {
    Start start;
    // By name, not by a structured binding, which clang 14 lets no lambda read.
    const std::size_t a = 0; // the first by place is a corner of the hull
    auto& b = start.corners[1];
    auto& c = start.corners[2];
    auto& d = start.corners[3];
    b = furthest(points, [&](const Vector& p) { return (p - points[a]).norm(); });
    const double size = (points[b] - points[a]).norm();
    const Vector line = (points[b] - points[a]) / size;
    const auto fromLine = [&](const Vector& p) { return (p - points[a]).cross(line).norm(); };
    c = furthest(points, fromLine);
    if (fromLine(points[c]) <= smallestThickness * size) {
        start.refusal = HullRefusal{"its points lie on one line, which bounds no volume"};
        return start;
    }
    const Vector normal = (points[b] - points[a]).cross(points[c] - points[a]).normalized();
    const auto fromPlane = [&](const Vector& p) { return std::abs(normal.dot(p - points[a])); };
    d = furthest(points, fromPlane);
    if (fromPlane(points[d]) <= smallestThickness * size ||
        orientation(points[a], points[b], points[c], points[d]) == 0)
        start.refusal = HullRefusal{"its points lie in one plane, which bounds no volume"};
    return start;
}

struct Loop {
    std::vector<std::size_t> vertices;
    Triangle plane{}; // whose plane it lies in
};

// Joins triangles into regions that are flat within the tolerance, largest triangles first.
class Regions {
public:
    Regions(const std::vector<Vector>& points, const std::vector<Triangle>& triangles,
            double tolerance)
        : points_(points), triangles_(triangles), tolerance_(tolerance),
          region_(triangles.size(), none) {
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                owner_[{triangles[t][i], triangles[t][(i + 1) % 3]}] = t;
        std::vector<std::size_t> order(triangles.size());
        std::iota(order.begin(), order.end(), 0u);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            return areaVector(a).squaredNorm() > areaVector(b).squaredNorm();
        });
        for (std::size_t t : order)
            if (region_[t] == none)
                grow(t, seeds_.size());
    }

    // The border of each region as one loop; empty when some region's border is not one loop.
    [[nodiscard]] std::vector<Loop> polygons() const {
        std::vector<std::map<std::size_t, std::size_t>> next(seeds_.size());
        for (const auto& [edge, t] : owner_) {
            const std::size_t twin = owner_.at({edge.second, edge.first});
            if (region_[t] != region_[twin] &&
                !next[region_[t]].insert({edge.first, edge.second}).second)
                return {};
        }
        std::vector<Loop> result;
        for (const auto& border : next) {
            std::vector<std::size_t> loop;
            for (std::size_t v = border.empty() ? none : border.begin()->first;
                 v != none && (loop.empty() || v != loop.front()); v = border.at(v))
                loop.push_back(v);
            if (loop.size() < 3 || loop.size() != border.size())
                return {};
            result.push_back({std::move(loop), triangles_[seeds_[result.size()]]});
        }
        return result;
    }

private:
    [[nodiscard]] Vector areaVector(std::size_t t) const {
        const auto& [a, b, c] = triangles_[t];
        return (points_[b] - points_[a]).cross(points_[c] - points_[a]);
    }

    void grow(std::size_t seed, std::size_t region) {
        seeds_.push_back(seed);
        const Vector normal = areaVector(seed).normalized();
        const double offset = normal.dot(points_[triangles_[seed][0]]);
        const auto flat = [&](std::size_t v) {
            return std::abs(normal.dot(points_[v]) - offset) <= tolerance_;
        };
        std::vector<std::size_t> front{seed};
        region_[seed] = region;
        while (!front.empty()) {
            const std::size_t t = front.back();
            front.pop_back();
            for (std::size_t i = 0; i < 3; ++i) {
                const std::size_t n = owner_.at({triangles_[t][(i + 1) % 3], triangles_[t][i]});
                const Triangle& corners = triangles_[n];
                if (region_[n] == none && std::all_of(corners.begin(), corners.end(), flat)) {
                    region_[n] = region;
                    front.push_back(n);
                }
            }
        }
    }

    const std::vector<Vector>& points_;
    const std::vector<Triangle>& triangles_;
    double tolerance_;
    std::vector<std::size_t> region_;
    std::vector<std::size_t> seeds_; // of each region: its largest triangle
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> owner_;
};

// A vertex where only two faces meet lies on an edge and is no corner.
void dropStraightCorners(std::vector<Loop>& loops) {
    std::map<std::size_t, int> faces;
    for (const Loop& loop : loops)
        for (std::size_t v : loop.vertices)
            ++faces[v];
    for (Loop& loop : loops)
        std::erase_if(loop.vertices, [&](std::size_t v) { return faces[v] < 3; });
}

// `points`: the author's own, of which the loops' vertices are indices into `sources`.
Hull assemble(const std::vector<Vector>& points, const std::vector<std::size_t>& sources,
              const std::vector<Loop>& loops) {
    std::map<std::size_t, std::size_t> renumbered;
    for (const Loop& loop : loops)
        for (std::size_t v : loop.vertices)
            renumbered.insert({v, 0});
    Hull hull;
    std::vector<Vector> vertices;
    for (auto& [old, now] : renumbered) {
        now = vertices.size();
        vertices.push_back(points[sources[old]]);
        hull.sources.push_back(sources[old]);
    }
    std::vector<Polygon> polygons;
    for (const Loop& loop : loops) {
        const auto place = [&](std::size_t i) { return points[sources[loop.plane[i]]]; };
        Polygon polygon{{}, std::array<Vector, 3>{place(0), place(1), place(2)}};
        for (std::size_t v : loop.vertices)
            polygon.vertices.push_back(renumbered[v]);
        polygons.push_back(std::move(polygon));
    }
    hull.polyhedron = fromPolygons(std::move(vertices), polygons);
    return hull;
}

bool isSimple(const std::vector<Loop>& loops) {
    return loops.size() >= 4 && std::all_of(loops.begin(), loops.end(), [](const Loop& loop) {
               return loop.vertices.size() > 2;
           });
}

std::optional<HullRefusal> unusable(const std::vector<Vector>& points) {
    if (points.size() > mostHullPoints)
        return HullRefusal{"it has more than " + std::to_string(mostHullPoints) + " points"};
    double largest = 0;
    for (const Vector& p : points) {
        if (!p.allFinite())
            return HullRefusal{"one of its points is not finite"};
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
    // Volumes and inertias are cubes and fifth powers of lengths.
    if (largest > 1e60 || (largest > 0 && largest < 1e-60))
        return HullRefusal{"its points are not between 1e-60 and 1e60 in size"};
    return std::nullopt;
}

} // namespace

std::variant<Hull, HullRefusal> convexHull(const std::vector<Vector>& points) {
    if (auto refusal = unusable(points))
        return *refusal;
    const std::vector<Vector> grid = toGrid(points);
    const std::vector<std::size_t> sources = distinct(grid);
    if (sources.size() < 4)
        return HullRefusal{"it has fewer than four different points"};
    std::vector<Vector> chosen;
    for (std::size_t i : sources)
        chosen.push_back(grid[i]);
    const Start start = findStart(chosen);
    if (start.refusal)
        return *start.refusal;

    const std::vector<Triangle> triangles = quickhull(chosen, start.corners);
    const double size = (chosen[start.corners[1]] - chosen[start.corners[0]]).norm();
    // Grid coordinates are below 1 and known to 2^-53 there: no plane is known better than that.
    const double tolerance = std::max(flatness * size, 0x1p-51);
    auto loops = Regions(chosen, triangles, tolerance).polygons();
    dropStraightCorners(loops);
    if (isSimple(loops))
        if (Hull hull = assemble(points, sources, loops); !hull.polyhedron.vertices.empty())
            return hull;
    // Merging failed to give proper polygons; the triangles themselves always close.
    loops.clear();
    for (const Triangle& t : triangles)
        loops.push_back({{t.begin(), t.end()}, t});
    return assemble(points, sources, loops);
}

} // namespace geometry
