#include "meshes/cuts.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace meshes {

namespace {

// In how far planes are one: of the normal, and of the size.
constexpr double same = 1e-4;

class Collected {
public:
    // Offsets are compared as seen from `origin`: from a place of the solid they are of its size,
    // and have digits for what is a small part of it, however far out it lies.
    Collected(double size, Vector origin) : size_(size), origin_(std::move(origin)) {}

    void add(const Vector& normal, const Vector& through, double weight) {
        if (!(normal.norm() > 0.5)) // of a triangle without area
            return;
        Plane plane{normal, normal.dot(through)};
        std::array<long, 4> key{};
        for (int k = 0; k < 3; ++k)
            key[static_cast<std::size_t>(k)] = std::lround(plane.normal[k] / same);
        key[3] = std::lround(normal.dot(through - origin_) / (same * size_));
        if (key < std::array<long, 4>{})
            for (long& x : key)
                x = -x;
        auto& [kept, all] = planes_[key];
        if (all == 0)
            kept = plane;
        all += weight;
    }

    [[nodiscard]] std::vector<Plane> best(std::size_t most) const {
        std::vector<std::pair<Plane, double>> all;
        for (const auto& [key, one] : planes_)
            all.push_back(one);
        std::ranges::stable_sort(all, std::greater(), &std::pair<Plane, double>::second);
        std::vector<Plane> result;
        for (const auto& [plane, weight] : all)
            if (result.size() < most)
                result.push_back(plane);
        return result;
    }

private:
    double size_;
    Vector origin_;
    std::map<std::array<long, 4>, std::pair<Plane, double>> planes_;
};

void addSlices(std::vector<Plane>& cuts, const std::vector<Vector>& points, const Vector& axis,
               int count, double tolerance) {
    double low = axis.dot(points[0]), high = low;
    for (const Vector& p : points) {
        low = std::min(low, axis.dot(p));
        high = std::max(high, axis.dot(p));
    }
    if (high - low > 4 * tolerance)
        for (int i = 1; i < count; ++i)
            cuts.push_back({axis, low + (high - low) * i / count});
}

Eigen::Matrix3d principalAxes(const std::vector<Vector>& points) {
    Vector middle = Vector::Zero();
    for (const Vector& p : points)
        middle += p / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vector& p : points)
        spread += (p - middle) * (p - middle).transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
}

} // namespace

std::vector<Plane> concavePlanes(const Solid& solid, std::size_t most) {
    const auto& v = solid.surface.vertices;
    const double size = extentOf(solid.surface).maxCoeff();
    // The triangle that passes each edge in this direction.
    std::unordered_map<std::uint64_t, std::size_t> passing;
    const auto key = [](std::uint64_t a, std::uint64_t b) { return a << 32U | b; };
    for (std::size_t t = 0; t < solid.surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            passing[key(solid.surface.triangles[t][k], solid.surface.triangles[t][(k + 1) % 3])] =
                t;
    const auto normal = [&](std::size_t t) {
        const auto& c = solid.surface.triangles[t];
        return Vector((v[c[1]] - v[c[0]]).cross(v[c[2]] - v[c[0]]).normalized());
    };
    if (v.empty())
        return {};
    Collected planes(size, v.front());
    for (std::size_t t = 0; t < solid.surface.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = solid.surface.triangles[t][k],
                                b = solid.surface.triangles[t][(k + 1) % 3];
            const auto other = passing.find(key(b, a));
            if (a > b || other == passing.end())
                continue;
            const Vector n1 = normal(t), n2 = normal(other->second);
            const Vector edge = (v[b] - v[a]).normalized();
            // Seen along the edge from a to b, the other face turns towards the first's outside.
            const double bend = n1.cross(n2).dot(edge);
            if (bend >= -1e-3)
                continue;
            const double weight = -bend * (v[b] - v[a]).norm();
            planes.add(n1, v[a], weight);
            planes.add(n2, v[a], weight);
            planes.add(edge.cross(n1 + n2).normalized(), v[a], weight);
        }
    return planes.best(most);
}

std::vector<Plane> cutsOf(const std::vector<Vector>& points, const std::vector<Plane>& concave,
                          double tolerance) {
    std::vector<Plane> cuts;
    const auto divides = [&](const Plane& plane) {
        bool above = false, below = false;
        for (const Vector& p : points) {
            const double s = plane.distance(p);
            above = above || s > tolerance;
            below = below || s < -tolerance;
        }
        return above && below;
    };
    for (const Plane& plane : concave)
        if (divides(plane))
            cuts.push_back(plane);
    for (int k = 0; k < 3; ++k)
        addSlices(cuts, points, Vector::Unit(k), 8, tolerance);
    const Eigen::Matrix3d axes = principalAxes(points);
    for (int k = 0; k < 3; ++k)
        if (axes.col(k).cwiseAbs().maxCoeff() < 0.99) // no world axis
            addSlices(cuts, points, axes.col(k), 4, tolerance);
    return cuts;
}

} // namespace meshes
