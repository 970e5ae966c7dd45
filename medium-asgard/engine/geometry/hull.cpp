#include "geometry/hull.h"

#include "geometry/predicates.h"
#include "geometry/quickhull.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
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
    Regions(const std::vector<Vector>& points, const Triangulation& hull, double tolerance)
        : points_(points), triangles_(hull.triangles), across_(hull.across), tolerance_(tolerance),
          region_(hull.triangles.size(), none) {
        std::vector<std::pair<double, std::size_t>> order; // the largest first
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            order.emplace_back(-areaVector(t).squaredNorm(), t);
        std::ranges::sort(order);
        for (const auto& [area, t] : order)
            if (region_[t] == none)
                grow(t, seeds_.size());
    }

    // The border of each region as one loop; empty when some region's border is not one loop.
    [[nodiscard]] std::vector<Loop> polygons() const {
        std::vector<BorderEdge> edges;
        for (std::size_t t = 0; t < triangles_.size(); ++t)
            for (std::size_t i = 0; i < 3; ++i)
                if (region_[t] != region_[across_[t][i]])
                    edges.push_back({region_[t], triangles_[t][i], triangles_[t][(i + 1) % 3]});
        std::ranges::sort(edges, {}, &BorderEdge::place);
        std::vector<Loop> result;
        for (std::size_t first = 0; first < edges.size();) {
            std::size_t end = first;
            while (end < edges.size() && edges[end].region == edges[first].region)
                ++end;
            std::vector<std::size_t> loop = loopOf(std::span(edges).subspan(first, end - first));
            if (loop.size() < 3 || edges[first].region != result.size())
                return {};
            result.push_back({std::move(loop), triangles_[seeds_[result.size()]]});
            first = end;
        }
        return result.size() == seeds_.size() ? result : std::vector<Loop>();
    }

private:
    struct BorderEdge {
        std::size_t region, from, to;
        [[nodiscard]] std::pair<std::size_t, std::size_t> place() const { return {region, from}; }
    };

    // Of one region's border, in order of where its edges begin; empty: it is not one loop.
    static std::vector<std::size_t> loopOf(std::span<const BorderEdge> border) {
        if (std::ranges::adjacent_find(border, {}, &BorderEdge::from) != border.end())
            return {};
        std::vector<std::size_t> loop;
        std::size_t v = border.front().from;
        do {
            const auto edge = std::ranges::lower_bound(border, v, {}, &BorderEdge::from);
            if (edge == border.end() || edge->from != v || loop.size() == border.size())
                return {};
            loop.push_back(v);
            v = edge->to;
        } while (v != border.front().from);
        return loop.size() == border.size() ? loop : std::vector<std::size_t>();
    }

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
            for (const std::size_t n : across_[t])
                if (region_[n] == none && std::ranges::all_of(triangles_[n], flat)) {
                    region_[n] = region;
                    front.push_back(n);
                }
        }
    }

    const std::vector<Vector>& points_;
    const std::vector<Triangle>& triangles_;
    const std::vector<std::array<std::size_t, 3>>& across_;
    double tolerance_;
    std::vector<std::size_t> region_;
    std::vector<std::size_t> seeds_; // of each region: its largest triangle
};

// A vertex where only two faces meet lies on an edge and is no corner.
void dropStraightCorners(std::size_t points, std::vector<Loop>& loops) {
    std::vector<int> faces(points);
    for (const Loop& loop : loops)
        for (std::size_t v : loop.vertices)
            ++faces[v];
    for (Loop& loop : loops)
        std::erase_if(loop.vertices, [&](std::size_t v) { return faces[v] < 3; });
}

// `points`: the author's own, of which the loops' vertices are indices into `sources`.
Hull assemble(const std::vector<Vector>& points, const std::vector<std::size_t>& sources,
              const std::vector<Loop>& loops) {
    std::vector<std::size_t> renumbered(sources.size(), none);
    for (const Loop& loop : loops)
        for (std::size_t v : loop.vertices)
            renumbered[v] = 0;
    Hull hull;
    std::vector<Vector> vertices;
    for (std::size_t old = 0; old < renumbered.size(); ++old) {
        if (renumbered[old] == none)
            continue;
        renumbered[old] = vertices.size();
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

std::variant<Hull, HullRefusal> convexHull(const std::vector<Vector>& points,
                                           const std::function<void()>& meanwhile) {
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

    const Triangulation hull = quickhull(chosen, start.corners, meanwhile);
    const double size = (chosen[start.corners[1]] - chosen[start.corners[0]]).norm();
    // Grid coordinates are below 1 and known to 2^-53 there: no plane is known better than that.
    const double tolerance = std::max(flatness * size, 0x1p-51);
    auto loops = Regions(chosen, hull, tolerance).polygons();
    dropStraightCorners(chosen.size(), loops);
    if (isSimple(loops))
        if (Hull made = assemble(points, sources, loops); !made.polyhedron.vertices.empty())
            return made;
    // Merging failed to give proper polygons; the triangles themselves always close.
    loops.clear();
    for (const Triangle& t : hull.triangles)
        loops.push_back({{t.begin(), t.end()}, t});
    return assemble(points, sources, loops);
}

} // namespace geometry
