#include "geometry/hollow.h"

#include <algorithm>
#include <cmath>

namespace geometry {
namespace {

using Piece = HollowNearest::Piece;

// A point in its half plane: how far from the axis, which way, how high.
struct Section {
    double rho = 0, height = 0;
    Vector radial = Vector::UnitX(); // own axes; any on the axis itself
    explicit Section(const Vector& own)
        : rho(std::hypot(own.x(), own.z())), height(own.y()),
          radial(rho > 0 ? Vector(own.x() / rho, 0, own.z() / rho) : Vector(Vector::UnitX())) {}
};

// From the circle of that radius at height 0.
HollowNearest fromCircle(Piece piece, const Section& at, double radius, double above) {
    const Vector way = (at.rho - radius) * at.radial + above * Vector::UnitY();
    HollowNearest nearest{.piece = piece, .distance = way.norm(), .across = at.rho, .above = above};
    if (nearest.distance > 0)
        nearest.normal = way / nearest.distance;
    return nearest;
}

// A point above the plane of an end, with y up.
HollowNearest beyondEnd(const Curved& hollow, const Section& at, double above) {
    if (at.rho < hollow.inner)
        return fromCircle(Piece::rim, at, hollow.inner, above);
    if (at.rho > hollow.radius())
        return fromCircle(Piece::edge, at, hollow.radius(), above);
    return {.piece = Piece::end, .distance = above, .across = at.rho, .above = above};
}

// The wall nearest to a point between the ends, `across` from the axis or centre and that way from
// it: the inside, the outside, or in the wall the one with the least depth.
HollowNearest betweenEnds(const Curved& hollow, double across, const Vector& way, double above) {
    const double in = hollow.inner - across, out = across - hollow.radius();
    HollowNearest nearest{.distance = out, .normal = way, .across = across, .above = above};
    if (in >= out) {
        nearest.piece = Piece::hollow;
        nearest.distance = in;
        nearest.normal = -way;
    }
    if (nearest.distance <= 0 && above > nearest.distance) {
        nearest.piece = Piece::end;
        nearest.distance = above;
        nearest.normal = Vector::UnitY();
    }
    return nearest;
}

} // namespace

HollowNearest nearestOf(const Curved& hollow, const Vector& point) {
    Vector own = hollow.frame.transpose() * (point - hollow.center);
    const bool isBelow = hollow.kind == Curved::Kind::tube && own.y() < 0;
    if (isBelow)
        own.y() = -own.y();
    const Section at(own);
    const double above = own.y() - hollow.half();
    HollowNearest nearest;
    if (above > 0) {
        nearest = beyondEnd(hollow, at, above);
    } else if (hollow.kind == Curved::Kind::tube) {
        nearest = betweenEnds(hollow, at.rho, at.radial, above);
    } else {
        const double across = own.norm();
        nearest = betweenEnds(hollow, across,
                              across > 0 ? Vector(own / across) : Vector(-Vector::UnitY()), above);
    }
    if (isBelow) {
        nearest.normal.y() = -nearest.normal.y();
        nearest.end = -1;
    }
    nearest.normal = hollow.frame * nearest.normal;
    return nearest;
}

// Half the square of the distance has the derivative (1 - r/rho) q(s) + y(s) y', with q = rho rho'.
std::vector<double> nearestToCircle(const Vector& a, const Vector& way, double radius) {
    const auto rising = [&](double s) {
        const Vector at = a + s * way;
        const double rho = std::hypot(at.x(), at.z());
        const double beside = rho > 0 ? 1 - radius / rho : 0;
        return beside * (at.x() * way.x() + at.z() * way.z()) + at.y() * way.y();
    };
    constexpr int stretches = 16;
    std::vector<double> found;
    double from = 0, before = rising(0);
    for (int i = 1; i <= stretches; ++i) {
        const double to = static_cast<double>(i) / stretches, now = rising(to);
        if (before < 0 && now >= 0) {
            double low = from, high = to;
            for (double middle = (low + high) / 2; low < middle && middle < high;
                 middle = (low + high) / 2)
                (rising(middle) < 0 ? low : high) = middle;
            found.push_back(high);
        }
        from = to;
        before = now;
    }
    return found;
}

} // namespace geometry
