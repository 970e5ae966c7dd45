#include "meshes/ears.h"

#include <algorithm>
#include <numeric>

namespace meshes {

namespace {

using Point = Eigen::Vector2d;

// LIMIT: concave polygons with more corners are fans; the time for ears grows with their square.
constexpr std::size_t mostCut = 400;

double turn(const Point& a, const Point& b, const Point& c) {
    return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

std::vector<Point> flat(const std::vector<Vector>& vertices,
                        std::span<const std::uint32_t> corners) {
    Vector normal = Vector::Zero(); // Newell's
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += (vertices[corners[i]] - vertices[corners[0]])
                      .cross(vertices[corners[(i + 1) % corners.size()]] - vertices[corners[0]]);
    const Vector u = normal.unitOrthogonal();
    const Vector v = normal.normalized().cross(u);
    std::vector<Point> points;
    for (const std::uint32_t c : corners)
        points.emplace_back(u.dot(vertices[c]), v.dot(vertices[c]));
    return points;
}

// Whether the corner at `i` of the rest can be cut off: it is convex and no other lies in it.
bool isEar(const std::vector<Point>& points, const std::vector<std::size_t>& rest, std::size_t i) {
    const std::size_t count = rest.size();
    const Point &a = points[rest[(i + count - 1) % count]], &b = points[rest[i]],
                &c = points[rest[(i + 1) % count]];
    if (turn(a, b, c) <= 0)
        return false;
    return std::ranges::none_of(rest, [&](std::size_t other) {
        const Point& p = points[other];
        return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
               turn(c, a, p) >= 0;
    });
}

bool isConvex(const std::vector<Point>& points) {
    for (std::size_t i = 0; i < points.size(); ++i)
        if (turn(points[i], points[(i + 1) % points.size()], points[(i + 2) % points.size()]) < 0)
            return false;
    return true;
}

// The corners that are left, and which of them can be cut off. Where one is cut off only its
// neighbours may have become ears, or none any more: a polygon that does not cross itself takes two
// looks for each. One that does may have others; all are looked at again then, a few times.
class Ears {
public:
    Ears(const std::vector<Point>& points, std::vector<std::size_t>& rest,
         const std::function<bool()>& goOn)
        : points_(points), rest_(rest), goOn_(goOn), is_(rest.size()) {
        lookAtAll();
    }
    [[nodiscard]] bool ended() const { return ended_; }

    // The first one, by its place in the rest; the second corner, as of a fan, where there is none.
    std::size_t next() {
        auto found = std::ranges::find(is_, true);
        if (found == is_.end() && looks_ < mostLooks) {
            lookAtAll();
            found = std::ranges::find(is_, true);
        }
        return found == is_.end() ? 1 : static_cast<std::size_t>(found - is_.begin());
    }
    void cut(std::size_t ear) {
        rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
        is_.erase(is_.begin() + static_cast<std::ptrdiff_t>(ear));
        const std::size_t count = rest_.size();
        look((ear + count - 1) % count);
        look(ear % count);
    }

private:
    static constexpr int mostLooks = 8;

    void look(std::size_t i) {
        ended_ = ended_ || (goOn_ && !goOn_());
        is_[i] = !ended_ && isEar(points_, rest_, i);
    }
    void lookAtAll() {
        ++looks_;
        for (std::size_t i = 0; i < rest_.size() && !ended_; ++i)
            look(i);
    }

    const std::vector<Point>& points_;
    std::vector<std::size_t>& rest_;
    const std::function<bool()>& goOn_;
    std::vector<bool> is_;
    int looks_ = 0;
    bool ended_ = false;
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> trianglesOf(const std::vector<Vector>& vertices,
                                                      std::span<const std::uint32_t> corners,
                                                      const std::function<bool()>& goOn) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::size_t> rest(corners.size());
    std::iota(rest.begin(), rest.end(), 0U);
    const auto add = [&](std::size_t before, std::size_t at, std::size_t after) {
        triangles.push_back({corners[before], corners[at], corners[after]});
    };
    const std::vector<Point> points = flat(vertices, corners);
    if (corners.size() > 3 && corners.size() <= mostCut && !isConvex(points)) {
        Ears ears(points, rest, goOn);
        while (rest.size() > 3 && !ears.ended()) {
            const std::size_t ear = ears.next(), count = rest.size();
            add(rest[(ear + count - 1) % count], rest[ear], rest[(ear + 1) % count]);
            ears.cut(ear);
        }
        if (ears.ended())
            return {};
    }
    for (std::size_t i = 1; i + 1 < rest.size(); ++i) // a fan; of three left, what they are
        add(rest[0], rest[i], rest[i + 1]);
    return triangles;
}

} // namespace meshes
