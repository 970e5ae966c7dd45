#include "meshes/hulls.h"

#include "meshes/convex_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meshes {

namespace {

// LIMIT: of more points than `atOnce` that all are vertices of their hull, the furthest in `rounds`
// directions are taken.
constexpr std::size_t atOnce = 20'000, rounds = 2000;

// A spiral from pole to pole: as even as it needs to be.
Vector direction(std::size_t i, std::size_t of) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(of);
    const double angle = std::numbers::pi * (3 - std::sqrt(5.0)) * static_cast<double>(i);
    const double r = std::sqrt(1 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
}

} // namespace

std::vector<Vector> hullPoints(const std::vector<Vector>& points) {
    if (points.size() > atOnce) { // the hull of hulls is the hull
        std::vector<Vector> outer;
        const std::size_t rows = (points.size() + atOnce - 1) / atOnce;
        for (std::size_t row = 0; row < rows; ++row) { // from all over, lest they lie in a plane
            std::vector<Vector> some;
            for (std::size_t i = row; i < points.size(); i += rows)
                some.push_back(points[i]);
            const std::vector<Vector> hull = hullPoints(some);
            const std::vector<Vector> kept = hull.empty() ? extremes(some, rounds) : hull;
            outer.insert(outer.end(), kept.begin(), kept.end());
        }
        return hullPoints(outer.size() > atOnce ? extremes(outer, rounds) : outer);
    }
    const auto made = geometry::convexHull(points);
    const auto* hull = std::get_if<geometry::Hull>(&made);
    return hull ? hull->polyhedron.vertices : std::vector<Vector>();
}

double volumeOf(const geometry::Polyhedron& polyhedron) {
    double six = 0;
    for (const geometry::Face& face : polyhedron.faces) {
        const Vector a = polyhedron.vertices[face.vertices[0]] - polyhedron.vertices[0];
        for (std::size_t k = 2; k < face.vertices.size(); ++k)
            six +=
                a.dot((polyhedron.vertices[face.vertices[k - 1]] - polyhedron.vertices[0])
                          .cross(polyhedron.vertices[face.vertices[k]] - polyhedron.vertices[0]));
    }
    return six / 6;
}

double hullVolume(const std::vector<Vector>& points) {
    const auto made = geometry::convexHull(points);
    const auto* hull = std::get_if<geometry::Hull>(&made);
    return hull ? volumeOf(hull->polyhedron) : 0;
}

std::vector<Vector> extremes(const std::vector<Vector>& points, std::size_t directions) {
    if (points.size() <= directions)
        return points;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < directions; ++i) {
        const Vector d = direction(i, directions);
        std::size_t best = 0;
        double far = d.dot(points[0]);
        for (std::size_t k = 1; k < points.size(); ++k)
            if (const double x = d.dot(points[k]); x > far) {
                far = x;
                best = k;
            }
        found.push_back(best);
    }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<Vector> result;
    result.reserve(found.size());
    for (const std::size_t k : found)
        result.push_back(points[k]);
    return result;
}

std::vector<Vector> fewerPoints(const std::vector<Vector>& points, std::size_t most) {
    std::vector<Vector> all = hullPoints(points);
    if (all.size() <= most || most < 4)
        return all;
    // Two ends of the longest side of the box, then always the one that is missed by most.
    std::vector<Vector> taken;
    for (int k = 0; k < 3; ++k) {
        const auto [low, high] =
            std::ranges::minmax_element(all, {}, [k](const Vector& p) { return p[k]; });
        for (const auto end : {low, high})
            if (std::ranges::find(taken, *end) == taken.end() && taken.size() + 1 < most)
                taken.push_back(*end);
    }
    while (taken.size() < most) {
        const auto made = geometry::convexHull(taken);
        const auto* hull = std::get_if<geometry::Hull>(&made);
        const Vector* furthest = nullptr;
        double far = 0;
        for (const Vector& p : all) {
            double out = hull ? 0 : (p - taken[0]).norm() + 1e-300;
            if (hull)
                for (const geometry::Face& face : hull->polyhedron.faces)
                    out = std::max(out, face.normal.dot(p) - face.offset);
            else if (std::ranges::find(taken, p) != taken.end())
                out = 0;
            if (out > far) {
                far = out;
                furthest = &p;
            }
        }
        if (!furthest)
            break;
        taken.push_back(*furthest);
    }
    return taken;
}

} // namespace meshes
