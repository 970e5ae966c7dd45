#include "geometry/outline.h"

#include <algorithm>
#include <cmath>

namespace geometry {
namespace {

struct Line { // of an edge of the outline, and the way to the inside
    Vector on, inward;
    [[nodiscard]] double depth(const Vector& point) const { return inward.dot(point - on); }
};

Vector middleOf(const std::vector<Vector>& vertices) {
    Vector middle = Vector::Zero();
    for (const Vector& vertex : vertices)
        middle += vertex / static_cast<double>(vertices.size());
    return middle;
}

std::vector<Line> linesOf(const std::vector<Vector>& outline, const Vector& normal) {
    const Vector middle = middleOf(outline);
    std::vector<Line> lines;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vector& a = outline[i];
        const Vector edge = outline[(i + 1) % outline.size()] - a;
        Line line{a, normal.cross(edge).normalized()};
        if (line.depth(middle) < 0)
            line.inward = -line.inward;
        lines.push_back(line);
    }
    return lines;
}

double depthIn(const std::vector<Line>& lines, const Vector& point) {
    double least = HUGE_VAL;
    for (const Line& line : lines)
        least = std::min(least, line.depth(point));
    return least;
}

// The most between a and b. The depth below each line is linear there: the least of all is most at
// an end, or where two of them are as deep.
double deepest(const std::vector<Line>& lines, const Vector& a, const Vector& b) {
    double most = std::max(depthIn(lines, a), depthIn(lines, b));
    for (std::size_t i = 0; i < lines.size(); ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const double atA = lines[i].depth(a) - lines[k].depth(a),
                         atB = lines[i].depth(b) - lines[k].depth(b);
            if ((atA < 0) != (atB < 0))
                most = std::max(most, depthIn(lines, Vector(a + atA / (atA - atB) * (b - a))));
        }
    return most;
}

} // namespace

double depthInside(const std::vector<Vector>& outline, const Vector& normal, const Vector& point) {
    return depthIn(linesOf(outline, normal), point);
}

// A face that holds the middle of the outline is over it. Any other feature comes nearest with its
// border: the depth has no other summit.
double besideOutline(const std::vector<Vector>& feature, const std::vector<Vector>& outline,
                     const Vector& normal) {
    if (feature.size() > 2 && depthInside(feature, normal, middleOf(outline)) >= 0)
        return 0;
    const std::vector<Line> lines = linesOf(outline, normal);
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i < feature.size(); ++i)
        most = std::max(most, deepest(lines, feature[i], feature[(i + 1) % feature.size()]));
    return std::max(0.0, -most);
}

} // namespace geometry
