#include "collision/separation.h"

#include "collision/curved_separation.h"
#include "collision/hollow_separation.h"
#include "collision/nearest_feature.h"
#include "collision/simplex.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace collision {

namespace {

constexpr double nearness = 1e-7; // of the parts' size: closer than this, axes decide
constexpr double parallel = 1e-9, allButParallel = 1e-4; // sines of the angles between edges

double extent(const Posed& p) {
    const auto& vertices = p.part->core.vertices;
    double furthest = 0;
    for (const Vector& v : vertices)
        furthest = std::max(furthest, (v - vertices[0]).squaredNorm());
    return std::sqrt(furthest) + p.part->radius;
}

// Minkowski difference first - second, by its support points.
class Difference {
public:
    Difference(const Posed& first, const Posed& second) : first_(first), second_(second) {}

    SimplexPoint furthest(const Vector& direction) {
        a_ = first_.support(direction, a_);
        b_ = second_.support(-direction, b_);
        return at(a_, b_);
    }
    [[nodiscard]] SimplexPoint at(std::size_t a, std::size_t b) const {
        return {first_.world(a) - second_.world(b), a, b};
    }

private:
    const Posed& first_;
    const Posed& second_;
    std::size_t a_ = 0, b_ = 0;
};

struct Closest {
    Vector vector = Vector::Zero(); // from second to first; zero: they overlap
    double bound = 0;               // the gap along it, a lower bound of the distance
    std::size_t iterations = 0;

    [[nodiscard]] bool converged(double size) const {
        return vector.norm() - bound <= 1e-9 * vector.norm() + 1e-14 * size;
    }
};

Closest descend(const Posed& first, const Posed& second, double size, WarmStart& warm) {
    Difference difference(first, second);
    Simplex simplex;
    for (std::size_t i = 0; i < warm.count; ++i)
        if (warm.pairs[i].first < first.part->core.vertices.size() &&
            warm.pairs[i].second < second.part->core.vertices.size())
            simplex.add(difference.at(warm.pairs[i].first, warm.pairs[i].second));
    if (simplex.count == 0)
        simplex.add(difference.at(0, 0));
    Vector v = simplex.reduce();

    Closest result;
    for (; result.iterations < 64; ++result.iterations) {
        if (simplex.holdsOrigin || v.norm() <= 1e-15 * size)
            break;
        const SimplexPoint w = difference.furthest(-v);
        if (v.squaredNorm() - v.dot(w.place) <= 1e-15 * v.squaredNorm() || simplex.has(w))
            break;
        Simplex larger = simplex;
        larger.add(w);
        const Vector next = larger.reduce();
        if (!larger.holdsOrigin && next.squaredNorm() >= v.squaredNorm())
            break; // rounding: no nearer point is known
        simplex = larger;
        v = next;
    }
    warm.count = simplex.count;
    for (std::size_t i = 0; i < simplex.count; ++i)
        warm.pairs[i] = {simplex.points[i].a, simplex.points[i].b};
    if (simplex.holdsOrigin || v.norm() <= 1e-15 * size)
        return result;
    result.vector = v;
    result.bound = v.normalized().dot(difference.furthest(-v).place);
    return result;
}

// A start that has become a sliver as the parts moved can end in a wrong place: then from anew.
Closest closestPoints(const Posed& first, const Posed& second, double size, WarmStart& warm) {
    const bool wasWarm = warm.count > 0;
    Closest result = descend(first, second, size, warm);
    if (wasWarm && !result.converged(size)) {
        const std::size_t before = result.iterations;
        warm.count = 0;
        result = descend(first, second, size, warm);
        result.iterations += before;
    }
    return result;
}

void take(Separation& best, double gap, const Vector& normal, double advantage) {
    if (gap > best.gap + advantage) {
        best.gap = gap;
        best.normal = normal;
    }
}

// Of `owner`, the face that looks most along `outward`, if it does so closely.
void tryFace(const Posed& owner, const Posed& other, const Vector& outward, double sign,
             Separation& best) {
    const Vector local = owner.rotation.transpose() * outward;
    const geometry::Face* face = nullptr;
    double most = 1 - 1e-8;
    for (const geometry::Face& f : owner.part->core.faces)
        if (const double d = f.normal.dot(local); d > most) {
            most = d;
            face = &f;
        }
    if (!face)
        return;
    const Vector normal = owner.rotation * face->normal;
    const double plane = face->offset + normal.dot(owner.offset);
    const double gap = normal.dot(other.world(other.support(-normal))) - plane;
    // A face's normal has less rounding than the line between points: it wins when as good.
    take(best, gap, sign * normal, -1e-9 * std::abs(best.gap));
}

// visit(gap, normal from second to first)
template <typename Visit>
void forEachFace(const Posed& owner, const Posed& other, double sign, Visit&& visit) {
    for (const geometry::Face& f : owner.part->core.faces) {
        const Vector normal = owner.rotation * f.normal;
        const double plane = f.offset + normal.dot(owner.offset);
        visit(normal.dot(other.world(other.support(-normal))) - plane, Vector(sign * normal));
    }
}

struct WorldEdge {
    Vector from, along, left, right; // ends and the normals of its two faces
};

std::vector<WorldEdge> worldEdges(const Posed& p) {
    std::vector<WorldEdge> result;
    const geometry::Polyhedron& core = p.part->core;
    for (const geometry::Edge& e : core.edges) {
        const Vector from = p.world(e.from);
        result.push_back({from, p.world(e.to) - from, p.rotation * core.faces[e.left].normal,
                          p.rotation * core.faces[e.right].normal});
    }
    return result;
}

// Two edges make a face of the Minkowski difference when their arcs of normals cross on the sphere.
bool faceEachOther(const WorldEdge& a, const WorldEdge& b) {
    const Vector c = -b.left, d = -b.right;
    const Vector arcA = a.left.cross(a.right), arcB = c.cross(d);
    const double ca = c.dot(arcA), da = d.dot(arcA);
    const double ab = a.left.dot(arcB), bb = a.right.dot(arcB);
    return ca * da < 0 && ab * bb < 0 && ca * bb > 0;
}

double gapAlong(const Posed& first, const Posed& second, const Vector& normal) {
    return normal.dot(first.world(first.support(-normal)) - second.world(second.support(normal)));
}

// The common perpendicular of edges that are all but parallel is lost in rounding: what is told is
// the gap along the axis that was found, and that is one.
template <typename Visit>
void forEachPairOfEdges(const Posed& first, const Posed& second, Visit&& visit) {
    const std::vector<WorldEdge> edges = worldEdges(second);
    for (const WorldEdge& a : worldEdges(first))
        for (const WorldEdge& b : edges) {
            if (!faceEachOther(a, b))
                continue;
            Vector normal = a.along.cross(b.along);
            const double length = normal.norm();
            if (length <= parallel * a.along.norm() * b.along.norm())
                continue; // a face's normal says as much
            normal /= length;
            if (normal.dot(a.left + a.right) > 0) // from second to first is into first
                normal = -normal;
            const bool isSure = length > allButParallel * a.along.norm() * b.along.norm();
            visit(isSure ? normal.dot(a.from - b.from) : gapAlong(first, second, normal), normal);
        }
}

// A sphere and a polyhedron that all but touch: from the feature itself, without the rounding of
// the line between closest points.
void refineRound(const Posed& first, const Posed& second, double size, Separation& best) {
    constexpr double close = 1e-3; // of the radius
    constexpr double border = 8 * std::numeric_limits<double>::epsilon();
    const bool isFirst = first.part->isSphere();
    const double radius = (isFirst ? first : second).part->radius;
    if (isFirst == second.part->isSphere() || std::abs(best.gap) > close * radius)
        return;
    const Posed &ball = isFirst ? first : second, &polyhedron = isFirst ? second : first;
    const double coordinates = size + (first.offset - second.offset).norm();
    const NearestFeature feature = nearestFeature(polyhedron, ball.world(0), border * coordinates);
    best.gap = feature.distance - radius;
    best.normal = isFirst ? feature.normal : Vector(-feature.normal);
}

} // namespace

std::vector<Separation> axesOfTouch(const Posed& first, const Posed& second, double depth) {
    std::vector<Separation> axes;
    const auto keep = [&](double gap, const Vector& normal) {
        if (gap >= -depth)
            axes.push_back({.gap = gap, .normal = normal});
    };
    forEachFace(first, second, -1, keep);
    forEachFace(second, first, 1, keep);
    forEachPairOfEdges(first, second, keep);
    return axes;
}

Separation separateByAxes(const Posed& first, const Posed& second) {
    Separation best;
    best.gap = -std::numeric_limits<double>::infinity();
    const auto tryFace = [&](double gap, const Vector& normal) { take(best, gap, normal, 0); };
    forEachFace(first, second, -1, tryFace);
    forEachFace(second, first, 1, tryFace);
    const double advantage = 1e-13 * (extent(first) + extent(second));
    forEachPairOfEdges(first, second, [&](double gap, const Vector& normal) {
        take(best, gap, normal, advantage);
    });
    if (best.gap == -std::numeric_limits<double>::infinity())
        best.gap = 0; // two points at one place: any line
    best.gap -= first.part->radius + second.part->radius;
    return best;
}

Separation separate(const Posed& first, const Posed& second, WarmStart& warm) {
    if (isHollowPair(*first.part, *second.part))
        return separateHollow(first, second);
    if (isCurvedPair(*first.part, *second.part))
        return separateCurved(first, second);
    const double size = extent(first) + extent(second);
    const Closest closest = closestPoints(first, second, size, warm);
    const double radii = first.part->radius + second.part->radius;
    Separation best;
    const double distance = closest.vector.norm();
    const bool pointLike = first.part->isSphere() && second.part->isSphere();
    const bool far = distance > nearness * size && closest.converged(size);
    if (far || (pointLike && distance > 0)) {
        best.gap = closest.bound;
        best.normal = closest.vector / distance;
        tryFace(first, second, -best.normal, -1, best);
        tryFace(second, first, best.normal, 1, best);
        best.gap -= radii;
    } else {
        best = separateByAxes(first, second);
        if (distance > 0 && closest.bound - radii > best.gap + 1e-12 * size) {
            best.gap = closest.bound - radii;
            best.normal = closest.vector / distance;
        }
    }
    refineRound(first, second, size, best);
    best.coreDistance = distance;
    best.iterations = closest.iterations;
    return best;
}

} // namespace collision
