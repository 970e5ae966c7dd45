#include "collision/separation_trials.h"

#include "geometry/hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {

namespace {

using geometry::Polyhedron;
using geometry::Quaternion;
using Long = Eigen::Matrix<long double, 3, 1>;

double uniform(std::mt19937_64& random, double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
}

Vector drawVector(std::mt19937_64& random) {
    return {uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1)};
}

geometry::Part drawPart(std::mt19937_64& random) {
    switch (random() % 6) {
    case 0:
        return geometry::spherePart(uniform(random, 0.1, 1), drawVector(random));
    case 1:
        return geometry::polyhedronPart(geometry::box(Vector::Ones()));
    case 2: // plate or needle
        return geometry::polyhedronPart(
            geometry::box({uniform(random, 0.5, 2), random() % 2 ? 1.0 : 1e-3,
                           std::pow(10, uniform(random, -4, 0))}));
    case 3: // a large floor
        return geometry::polyhedronPart(geometry::box({2000, 1, 2000}));
    default: {
        std::vector<Vector> points;
        const std::size_t count = 4 + random() % 16;
        for (std::size_t i = 0; i < count; ++i)
            points.push_back(random() % 3 ? drawVector(random).normalized()
                                          : Vector((drawVector(random) * 2).array().round()));
        const auto hull = geometry::convexHull(points);
        if (const auto* h = std::get_if<geometry::Hull>(&hull))
            return geometry::polyhedronPart(h->polyhedron);
        return geometry::polyhedronPart(geometry::box(Vector::Ones()));
    }
    }
}

Matrix drawRotation(std::mt19937_64& random) {
    if (random() % 3 == 0) // axes of the one along axes of the other
        return geometry::fromRotationVector(M_PI / 2 *
                                            Vector::Unit(static_cast<int>(random() % 3)) *
                                            static_cast<double>(random() % 4))
            .toRotationMatrix();
    return geometry::fromRotationVector(3 * drawVector(random)).toRotationMatrix();
}

struct Body {
    std::vector<Long> vertices;
    std::vector<std::pair<Long, Long>> edges;
    std::vector<std::vector<Long>> faces;
    std::vector<Long> normals;
};

Body toWorld(const Posed& p) {
    Body body;
    const Eigen::Matrix<long double, 3, 3> r = p.rotation.cast<long double>();
    const auto place = [&](std::size_t v) {
        return Long(r * p.part->core.vertices[v].cast<long double>() +
                    p.offset.cast<long double>());
    };
    for (std::size_t i = 0; i < p.part->core.vertices.size(); ++i)
        body.vertices.push_back(place(i));
    for (const auto& e : p.part->core.edges)
        body.edges.emplace_back(body.vertices[e.from], body.vertices[e.to]);
    for (const auto& f : p.part->core.faces) {
        std::vector<Long> corners;
        for (std::size_t v : f.vertices)
            corners.push_back(body.vertices[v]);
        body.faces.push_back(corners);
        body.normals.push_back(r * f.normal.cast<long double>());
    }
    return body;
}

long double pointToSegment(const Long& p, const Long& a, const Long& b) {
    const Long d = b - a;
    const long double t = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0L, 1.0L);
    return (p - a - t * d).norm();
}

// Infinity when the foot of the perpendicular is outside the polygon (an edge is nearer then).
long double pointToFace(const Long& p, const std::vector<Long>& face, const Long& normal) {
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Long& a = face[i];
        const Long& b = face[(i + 1) % face.size()];
        if (normal.dot((b - a).cross(p - a)) < 0)
            return std::numeric_limits<long double>::infinity();
    }
    return std::abs(normal.dot(p - face[0]));
}

long double segmentToSegment(const Long& a, const Long& b, const Long& c, const Long& d) {
    long double best = std::min(std::min(pointToSegment(a, c, d), pointToSegment(b, c, d)),
                                std::min(pointToSegment(c, a, b), pointToSegment(d, a, b)));
    const Long u = b - a, v = d - c, w = c - a;
    const long double uu = u.dot(u), vv = v.dot(v), uv = u.dot(v);
    const long double det = uu * vv - uv * uv;
    if (det > 1e-24L * uu * vv) {
        const long double s = (w.dot(u) * vv - w.dot(v) * uv) / det;
        const long double t = (w.dot(u) * uv - w.dot(v) * uu) / det;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
            best = std::min(best, (a + s * u - c - t * v).norm());
    }
    return best;
}

// True when every point of `b`'s polyhedron that could prove separation fails to: some vertex of
// the one is inside the other, or an edge of the one pierces a face of the other.
bool inside(const Long& p, const Body& body) {
    if (body.faces.empty())
        return false;
    for (std::size_t f = 0; f < body.faces.size(); ++f)
        if (body.normals[f].dot(p - body.faces[f][0]) > 0)
            return false;
    return true;
}

bool pierces(const std::pair<Long, Long>& edge, const Body& body) {
    long double enter = 0, leave = 1;
    for (std::size_t f = 0; f < body.faces.size(); ++f) {
        const long double from = body.normals[f].dot(edge.first - body.faces[f][0]);
        const long double to = body.normals[f].dot(edge.second - body.faces[f][0]);
        if (from > 0 && to > 0)
            return false;
        if (from > 0)
            enter = std::max(enter, from / (from - to));
        else if (to > 0)
            leave = std::min(leave, from / (from - to));
    }
    return !body.faces.empty() && enter < leave;
}

bool overlap(const Body& a, const Body& b) {
    const auto in = [](const Body& x, const Body& y) {
        return std::any_of(x.vertices.begin(), x.vertices.end(),
                           [&](const Long& p) { return inside(p, y); }) ||
               std::any_of(x.edges.begin(), x.edges.end(),
                           [&](const auto& e) { return pierces(e, y); });
    };
    return in(a, b) || in(b, a);
}

} // namespace

double bruteForceGap(const Posed& first, const Posed& second) {
    const Body a = toWorld(first), b = toWorld(second);
    if (overlap(a, b))
        return 0;
    long double best = std::numeric_limits<long double>::infinity();
    for (const auto& [x, y] : {std::pair(&a, &b), std::pair(&b, &a)})
        for (const Long& p : x->vertices) {
            for (std::size_t f = 0; f < y->faces.size(); ++f)
                best = std::min(best, pointToFace(p, y->faces[f], y->normals[f]));
            for (const auto& e : y->edges)
                best = std::min(best, pointToSegment(p, e.first, e.second));
            for (const Long& q : y->vertices)
                best = std::min(best, (p - q).norm());
        }
    for (const auto& e : a.edges)
        for (const auto& f : b.edges)
            best = std::min(best, segmentToSegment(e.first, e.second, f.first, f.second));
    return static_cast<double>(best);
}

PosedPair drawPair(std::mt19937_64& random) {
    PosedPair pair{drawPart(random), drawPart(random), {}, {}};
    pair.posedFirst = {&pair.first, drawRotation(random), Vector::Zero()};
    pair.posedSecond = {&pair.second, drawRotation(random), 4 * drawVector(random)};
    const std::size_t kind = random() % 8;
    if (kind == 0)
        pair.posedSecond.offset = drawVector(random).array().round(); // lined up, often touching
    if (kind == 1)
        pair.posedSecond.offset.setZero();
    if (kind >= 5) { // moved along the normal until nearly touching
        WarmStart cold;
        const Separation s = separate(pair.posedFirst, pair.posedSecond, cold);
        const double gap = std::pow(10, uniform(random, -15, -2)) * (random() % 4 ? 1 : -1);
        pair.posedSecond.offset += (s.gap - gap) * s.normal;
    }
    return pair;
}

std::string separationFault(const PosedPair& pair) {
    Posed a = pair.posedFirst, b = pair.posedSecond;
    a.part = &pair.first;
    b.part = &pair.second;
    const double size = geometry::radiusAbout(pair.first, a.part->core.vertices[0]) +
                        geometry::radiusAbout(pair.second, b.part->core.vertices[0]) +
                        (a.offset - b.offset).norm();
    const double radii = a.part->radius + b.part->radius;
    WarmStart warm;
    const Separation s = separate(a, b, warm);
    if (!(std::abs(s.normal.norm() - 1) < 1e-12))
        return "the normal is not a unit vector";
    // Whatever found it, the gap along the normal can be measured.
    const double measured = s.normal.dot(a.world(a.support(-s.normal))) -
                            s.normal.dot(b.world(b.support(s.normal))) - radii;
    if (std::abs(measured - s.gap) > 1e-13 * size)
        return "the gap is not that along the normal, by " +
               std::to_string((measured - s.gap) / size);
    const double true_ = bruteForceGap(a, b);
    const double tolerance = 1e-9 * size;
    if (true_ > tolerance && s.gap + radii > true_ + tolerance)
        return "more apart than they are";
    // Axes prove less than the distance only where that is within their reach.
    if (true_ > 2e-7 * size && s.gap + radii < true_ - tolerance)
        return "less apart than they are: " + std::to_string(s.gap + radii) + " for " +
               std::to_string(true_);
    if (true_ == 0 && s.gap + radii > tolerance)
        return "apart though they overlap by more than rounding";
    if (true_ > tolerance && s.gap + radii <= 0)
        return "overlapping though apart";
    const Separation again = separate(a, b, warm);
    if (std::abs(again.gap - s.gap) > tolerance)
        return "another gap from a warm start";
    return "";
}

} // namespace collision
