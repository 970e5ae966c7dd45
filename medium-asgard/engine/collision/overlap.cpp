#include "collision/overlap.h"

#include "collision/separation.h"

#include <algorithm>

namespace collision {

std::vector<std::pair<std::size_t, std::size_t>> overlappingParts(const geometry::Shape& shape) {
    std::vector<std::pair<std::size_t, std::size_t>> result;
    for (std::size_t i = 0; i < shape.parts.size(); ++i)
        for (std::size_t j = i + 1; j < shape.parts.size(); ++j) {
            const geometry::Part &a = shape.parts[i], &b = shape.parts[j];
            if (a.isPlane() || b.isPlane()) // without volume
                continue;
            const Vector origin = a.core.vertices[0];
            const double size = std::min(geometry::radiusAbout(a, a.core.vertices[0]),
                                         geometry::radiusAbout(b, b.core.vertices[0]));
            WarmStart cold;
            const Separation s = separate({&a, Matrix::Identity(), -origin},
                                          {&b, Matrix::Identity(), -origin}, cold);
            if (s.gap < -1e-9 * size)
                result.emplace_back(i, j);
        }
    return result;
}

} // namespace collision
