#include "geometry/hull_trials.h"

#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace geometry {

namespace {

double uniform(std::mt19937_64& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Vector drawVector(std::mt19937_64& random) {
    return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
}

Vector drawPoint(std::mt19937_64& random, int kind) {
    const Vector v = drawVector(random);
    switch (kind) {
    case 0: // on a sphere
        return v.normalized();
    case 1: // on a grid: many in one plane, many equal
        return (v * 2).array().round();
    case 2: // on the faces of a cube
        return v / v.cwiseAbs().maxCoeff();
    case 3: // thin
        return {v.x(), v.y(), 1e-7 * v.z()};
    case 4: // a needle
        return {v.x(), 1e-6 * v.y(), 1e-6 * v.z()};
    case 5: // corners of a cube, with repetitions
        return v.cwiseSign();
    case 6: // a plane and sometimes a point beside it
        return {v.x(), v.y(), v.z() > 0.8 ? v.z() : 0};
    case 7: // within rounding of a plane, refused or flat
        return {v.x(), v.y(), 1e-16 * v.z()};
    case 8: // a grid line and sometimes a point beside it
        return {std::round(9 * v.x()), v.y() > 0.7 ? 1.0 : 0.0, v.z() > 0.7 ? 1.0 : 0.0};
    default:
        return v;
    }
}

double sizeOf(const std::vector<Vector>& points) {
    double size = 0;
    for (const Vector& p : points)
        size = std::max(size, (p - points[0]).norm());
    return size;
}

} // namespace

std::vector<Vector> drawPoints(std::mt19937_64& random) {
    const int kind = static_cast<int>(random() % 12);
    const std::size_t count = 1 + random() % (random() % 8 == 0 ? 120 : 24);
    const Quaternion turn =
        random() % 2 ? Quaternion::Identity() : fromRotationVector(3 * drawVector(random));
    const double scale = random() % 3 ? 1 : std::pow(10, uniform(random, -40, 40));
    const Vector offset = random() % 3 ? Vector(Vector::Zero()) : Vector(1e6 * drawVector(random));
    std::vector<Vector> points;
    for (std::size_t i = 0; i < count; ++i)
        points.emplace_back(scale * (turn * drawPoint(random, kind) + offset));
    return points;
}

namespace {

bool isClosed(const Polyhedron& p) {
    std::set<std::pair<std::size_t, std::size_t>> directed;
    for (const Face& f : p.faces)
        for (std::size_t i = 0; i < f.vertices.size(); ++i)
            if (!directed.insert({f.vertices[i], f.vertices[(i + 1) % f.vertices.size()]}).second)
                return false;
    return std::all_of(directed.begin(), directed.end(),
                       [&](const auto& e) {
                           return directed.contains({e.second, e.first});
                       }) &&
           p.vertices.size() + p.faces.size() == p.edges.size() + 2;
}

// The furthest that any point lies outside of any face's plane.
double worstOutside(const Polyhedron& p, const std::vector<Vector>& points) {
    double worst = 0;
    for (const Face& f : p.faces)
        for (const Vector& x : points)
            worst = std::max(worst, f.normal.dot(x - p.vertices[f.vertices[0]]));
    return worst;
}

// The root mean square distance of the points from the plane that fits them best.
double thickness(const std::vector<Vector>& points) {
    Eigen::MatrixX3d rows(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        rows.row(static_cast<Eigen::Index>(i)) = points[i] - points[0];
    rows.rowwise() -= rows.colwise().mean().eval();
    const double largest = rows.cwiseAbs().maxCoeff();
    if (largest == 0)
        return 0;
    const Eigen::JacobiSVD<Eigen::MatrixX3d> svd(rows / largest);
    return svd.singularValues()[2] * largest / std::sqrt(static_cast<double>(points.size()));
}

} // namespace

std::string faultOf(const std::vector<Vector>& points,
                    const std::variant<Hull, HullRefusal>& result) {
    const double size = sizeOf(points);
    double largest = 0;
    for (const Vector& p : points)
        largest = std::max(largest, p.cwiseAbs().maxCoeff());
    if (const auto* refusal = std::get_if<HullRefusal>(&result)) {
        const bool deserved = points.size() < 4 || largest > 1e60 || largest < 1e-60 ||
                              thickness(points) <= 1e-8 * size;
        return deserved ? "" : "refused a solid: " + refusal->sentence;
    }
    const Polyhedron& p = std::get<Hull>(result).polyhedron;
    if (!isClosed(p))
        return "not closed";
    const double outside = worstOutside(p, points);
    if (outside > 4 * flatness * size + 2e-15 * largest)
        return "a point lies outside by " + std::to_string(1e12 * outside / size) +
               "e-12 of the size";
    return "";
}

} // namespace geometry
