#include "geometry/outline.h"

#include <algorithm>
#include <cmath>

namespace geometry {

double depthInside(const std::vector<Vector>& outline, const Vector& normal, const Vector& point) {
    double least = HUGE_VAL;
    Vector middle = Vector::Zero();
    for (const Vector& p : outline)
        middle += p / static_cast<double>(outline.size());
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector& a = outline[i];
        const Vector edge = outline[(i + 1) % outline.size()] - a;
        Vector inward = normal.cross(edge).normalized();
        if (inward.dot(middle - a) < 0)
            inward = -inward;
        least = std::min(least, inward.dot(point - a));
    }
    return least;
}

// The depth is concave along each edge: its maximum is found by thirds.
double besideOutline(const std::vector<Vector>& feature, const std::vector<Vector>& outline,
                     const Vector& normal) {
    constexpr int cuts = 40;
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i < feature.size(); ++i) {
        const Vector &a = feature[i], &b = feature[(i + 1) % feature.size()];
        const auto depthAt = [&](double s) {
            return depthInside(outline, normal, Vector(a + s * (b - a)));
        };
        double low = 0, high = 1;
        for (int k = 0; k < cuts; ++k) {
            const double third = (high - low) / 3;
            if (depthAt(low + third) < depthAt(high - third))
                low += third;
            else
                high -= third;
        }
        most = std::max({most, depthAt(0), depthAt(1), depthAt((low + high) / 2)});
    }
    return std::max(0.0, -most);
}

} // namespace geometry
