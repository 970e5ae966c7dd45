#include "collision/curved_separation.h"

#include "collision/feature.h"
#include "collision/simplex.h"
#include "collision/stationary_normal.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace collision {
namespace {

// Of the way to the centre: how much smaller parts are made, one after another, until they part.
constexpr std::array shrinkings = {0.0, 1e-6, 1e-4, 2e-3, 0.02, 0.1, 0.4, 0.9};
constexpr double enough = 0.02;     // a sharp point keeps its place where they are shrunk little,
                                    // what is round needs few steps where they are shrunk by this
constexpr double apart = 1e-8;      // of the size: nearer than this, the line is blurred
constexpr double surely = 1e-3;     // of the size: farther than this, one line is enough
constexpr double roughly = 1e-6;    // of the squared distance
constexpr double nearAlong = 0.05;  // of the size: pieces that may bear
constexpr double advantage = 1e-15; // of the size: as good
constexpr int mostSupports = 48, mostRounds = 3;

Vector centreOf(const Part& part) {
    if (part.curved)
        return part.curved->center;
    Vector sum = Vector::Zero();
    for (const Vector& v : part.core.vertices)
        sum += v - part.core.vertices[0];
    return part.core.vertices[0] + sum / static_cast<double>(part.core.vertices.size());
}

class Search {
public:
    Search(const Posed& first, const Posed& second)
        : first_(first), second_(second), centre_(worldCentre(first) - worldCentre(second)),
          size_(geometry::radiusAbout(*first.part, centreOf(*first.part)) +
                geometry::radiusAbout(*second.part, centreOf(*second.part))) {}

    Separation find() {
        best_.gap = -HUGE_VAL;
        const std::vector<Rough> seeds = roughNormals();
        for (const auto& [normal, depth] : seeds)
            tryAll(normal, depth);
        const Rough& last = seeds.back();
        Vector near = last.normal;
        for (int round = 1; round < mostRounds; ++round) {
            if ((best_.normal - near).norm() < nearAlong)
                break;
            near = best_.normal;
            tryAll(near, last.depth);
        }
        best_.coreDistance = std::max(best_.gap, 0.0);
        best_.gap -= first_.part->radius + second_.part->radius;
        return best_;
    }

private:
    static Vector worldCentre(const Posed& posed) {
        return posed.rotation * centreOf(*posed.part) + posed.offset;
    }

    // The point of the difference of both that lies furthest along a direction.
    [[nodiscard]] Vector furthest(const Vector& direction) const {
        return first_.furthest(direction) - second_.furthest(-direction);
    }

    [[nodiscard]] double gapAlong(const Vector& n) const { return n.dot(furthest(-n)); }

    // Of the difference, shrunk towards its centre.
    [[nodiscard]] std::optional<Vector> nearestOf(double shrinking) {
        const auto at = [&](const Vector& direction, std::size_t id) {
            return SimplexPoint{centre_ + (1 - shrinking) * (furthest(direction) - centre_), id,
                                id};
        };
        Simplex simplex;
        simplex.add(at(centre_.norm() > 0 ? Vector(-centre_) : Vector(Vector::UnitY()), 0));
        Vector v = simplex.reduce();
        for (std::size_t i = 1; i < mostSupports; ++i, ++best_.iterations) {
            if (simplex.holdsOrigin || v.norm() <= apart * size_)
                return std::nullopt;
            const SimplexPoint w = at(-v, i);
            if (v.squaredNorm() - v.dot(w.place) <= roughly * v.squaredNorm())
                break;
            Simplex larger = simplex;
            larger.add(w);
            const Vector next = larger.reduce();
            if (!larger.holdsOrigin && next.squaredNorm() >= v.squaredNorm())
                break;
            simplex = larger;
            v = next;
        }
        return v;
    }

    // Where to look: how far from the furthest extent what bears may be grows with the shrinking.
    struct Rough {
        Vector normal;
        double depth;
    };
    [[nodiscard]] std::vector<Rough> roughNormals() {
        std::vector<Rough> found;
        for (const double shrinking : shrinkings) {
            if (!found.empty() && shrinking < enough)
                continue;
            const auto v = nearestOf(shrinking);
            if (!v)
                continue;
            found.push_back({v->normalized(), (nearAlong + shrinking) * size_});
            if (shrinking >= enough || (shrinking == 0 && v->norm() > surely * size_))
                break;
        }
        if (found.empty())
            found.push_back(
                {centre_.norm() > 0 ? Vector(centre_.normalized()) : Vector(Vector::UnitY()),
                 size_});
        return found;
    }

    void take(const Vector& normal, bool isBlurred) {
        const double gap = gapAlong(normal);
        if (!(gap > best_.gap + advantage * size_))
            return;
        best_.gap = gap;
        best_.normal = normal;
        best_.isBlurred = isBlurred;
    }

    [[nodiscard]] static std::vector<Feature> featuresOf(const Posed& posed,
                                                         const Vector& direction, double depth) {
        std::vector<Feature> features;
        for (Feature& feature :
             featuresAlong(*posed.part, posed.rotation.transpose() * direction, depth))
            features.push_back(placed(std::move(feature), posed));
        return features;
    }

    void tryAll(const Vector& near, double depth) {
        std::vector<Feature> ofFirst = featuresOf(first_, -near, depth);
        std::vector<Feature> ofSecond = featuresOf(second_, near, depth);
        const auto isFace = [](const Feature& f) { return f.kind == Feature::Kind::face; };
        for (const Feature& f : ofSecond)
            if (isFace(f))
                take(f.axis, false);
        for (const Feature& f : ofFirst)
            if (isFace(f))
                take(-f.axis, false);
        std::erase_if(ofFirst, isFace);
        std::erase_if(ofSecond, isFace);
        for (const Feature& a : ofFirst) {
            const Feature mirrored = reflected(a);
            for (const Feature& b : ofSecond)
                for (const auto& [normal, isBlurred] : stationaryNormals(mirrored, b, near, size_))
                    take(normal, isBlurred);
        }
        take(near, true); // where sharp points have passed each other
    }

    const Posed& first_;
    const Posed& second_;
    Vector centre_; // from the second's to the first's
    double size_;
    Separation best_;
};

// Along the half space's own normal.
Separation fromPlane(const Posed& plane, const Posed& other) {
    Separation result;
    result.normal = plane.rotation * plane.part->curved->axis();
    const Vector origin = plane.rotation * plane.part->curved->center + plane.offset;
    result.coreDistance = result.normal.dot(other.furthest(-result.normal) - origin);
    result.gap = result.coreDistance - other.part->radius;
    return result;
}

} // namespace

Separation separateCurved(const Posed& first, const Posed& second) {
    if (second.part->isPlane())
        return fromPlane(second, first);
    if (first.part->isPlane()) {
        Separation result = fromPlane(first, second);
        result.normal = -result.normal;
        return result;
    }
    return Search(first, second).find();
}

} // namespace collision
