#include "collision/spheres.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

// Coefficients of (t - from)^k of one coordinate of the pivot's path.
Polynomial shifted(const MotionPiece& piece, int coordinate, double from) {
    Polynomial p;
    p.count = piece.position.size();
    for (std::size_t k = 0; k < p.count; ++k)
        p.terms[k] = piece.position[k][coordinate];
    const double s0 = (from - piece.from) / piece.scale;
    for (std::size_t i = 0; s0 != 0 && i + 1 < p.count; ++i)
        for (std::size_t k = p.count - 1; k-- > i;)
            p.terms[k] += s0 * p.terms[k + 1];
    double power = 1;
    for (std::size_t k = 0; k < p.count; ++k, power *= piece.scale)
        p.terms[k] /= power;
    return p;
}

double distanceAt(const RelativePath& path, double s) {
    return Vector(path[0].value(s), path[1].value(s), path[2].value(s)).norm();
}

} // namespace

RelativePath relativePath(const MotionPiece& first, const MotionPiece& second, double from) {
    RelativePath path;
    for (int c = 0; c < 3; ++c) {
        Polynomial a = shifted(first, c, from);
        const Polynomial b = shifted(second, c, from);
        a.count = std::max(a.count, b.count);
        for (std::size_t k = 0; k < b.count; ++k)
            a.terms[k] -= b.terms[k];
        while (a.count > 1 && a.terms[a.count - 1] == 0)
            --a.count;
        path[static_cast<std::size_t>(c)] = a;
    }
    return path;
}

Polynomial squaredDistance(const RelativePath& path, double radius) {
    Polynomial sum;
    for (const Polynomial& p : path) {
        sum.count = std::max(sum.count, 2 * p.count - 1);
        for (std::size_t i = 0; i < p.count; ++i)
            for (std::size_t j = 0; j < p.count; ++j)
                sum.terms[i + j] += p.terms[i] * p.terms[j];
    }
    const double distance = distanceAt(path, 0);
    sum.terms[0] = (distance - radius) * (distance + radius);
    return sum;
}

namespace {

// Where the spheres, which touch now and do not approach, meet again: the root at 0 is divided out.
std::optional<SphereHit> meetAgain(Polynomial g, double length, double speedOff, double distance) {
    const bool neutral = g.count < 2 || std::abs(g.terms[1]) <= 2 * distance * speedOff;
    const std::size_t roots = neutral ? 2 : 1;
    if (g.count <= roots)
        return std::nullopt;
    Polynomial rest;
    rest.count = g.count - roots;
    for (std::size_t k = 0; k < rest.count; ++k)
        rest.terms[k] = g.terms[k + roots];
    const auto s = firstDescent(rest, length);
    if (!s)
        return std::nullopt;
    return SphereHit{*s, neutral && *s == 0};
}

// Where they meet after the overlap in which they are now has ended. `g` is negative now.
std::optional<SphereHit> meetAfterParting(RelativePath path, Polynomial g, double radius,
                                          double length) {
    for (double& term : g.terms)
        term = -term;
    const auto apart = firstDescent(g, length);
    if (!apart)
        return std::nullopt;
    for (Polynomial& p : path)
        for (std::size_t i = 0; i + 1 < p.count; ++i)
            for (std::size_t k = p.count - 1; k-- > i;)
                p.terms[k] += *apart * p.terms[k + 1];
    auto hit = meetAgain(squaredDistance(path, radius), length - *apart, 0, radius);
    if (hit)
        hit->after += *apart;
    return hit;
}

constexpr double deepOverlap = 1e-7; // of the radius: more than round-off of any scene's numbers

} // namespace

SphereEncounter spheresMeet(const RelativePath& path, double radius, double length, double roundOff,
                            double speedOff) {
    SphereEncounter result;
    Polynomial g = squaredDistance(path, radius);
    const double distance = distanceAt(path, 0);
    const double gap = distance - radius;
    if (gap > roundOff) {
        const auto accurate = [&](double s) {
            const double d = distanceAt(path, s);
            return (d - radius) * (d + radius);
        };
        if (const auto s = firstDescent(g, length, accurate))
            result.hit = SphereHit{*s, false};
        return result;
    }
    const double opening = g.count > 1 ? g.terms[1] / (2 * std::max(distance, radius)) : 0;
    const bool isDeep = gap < -std::max(deepOverlap * radius, roundOff);
    if (isDeep)
        result.overlap = -gap;
    if (isDeep || (gap < -100 * roundOff && opening > speedOff))
        result.hit = meetAfterParting(path, g, radius, length);
    else if (opening < -speedOff)
        result.hit = SphereHit{0, false};
    else
        result.hit = meetAgain(g, length, speedOff, distance);
    return result;
}

} // namespace collision
