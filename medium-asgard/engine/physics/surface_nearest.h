// The formulas of surface_gap.h, for numbers and for expressions.
#pragma once

#include "physics/node_vector.h"
#include "physics/surface_gap.h"

#include <array>
#include <cmath>
#include <utility>

namespace physics::surfaces {

// An expression that is written as a number is.
struct Term {
    Graph* graph = nullptr;
    Node node;
};
inline Term operator+(Term a, Term b) { return {a.graph, a.graph->add(a.node, b.node)}; }
inline Term operator-(Term a, Term b) { return {a.graph, a.graph->subtract(a.node, b.node)}; }
inline Term operator*(Term a, Term b) { return {a.graph, a.graph->multiply(a.node, b.node)}; }
inline Term operator/(Term a, Term b) { return {a.graph, a.graph->divide(a.node, b.node)}; }
inline Term sqrt(Term a) { return {a.graph, a.graph->apply(Op::sqrt, a.node)}; }
inline Term like(Term a, double value) { return {a.graph, a.graph->constant(value)}; }
inline double like(double, double value) { return value; }

template <class S> struct Triple { S x, y, z; };
template <class S> Triple<S> operator+(const Triple<S>& a, const Triple<S>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class S> Triple<S> operator-(const Triple<S>& a, const Triple<S>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class S> Triple<S> operator*(S k, const Triple<S>& a) {
    return {k * a.x, k * a.y, k * a.z};
}
template <class S> Triple<S> operator/(const Triple<S>& a, S k) {
    return {a.x / k, a.y / k, a.z / k};
}
template <class S> S dot(const Triple<S>& a, const Triple<S>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S> Triple<S> cross(const Triple<S>& a, const Triple<S>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class S> S lengthOf(const Triple<S>& a) {
    using std::sqrt;
    return sqrt(dot(a, a));
}

template <class S> struct Place { // of a body
    Triple<S> centre;
    std::array<Triple<S>, 3> rotation; // rows

    [[nodiscard]] S number(double value) const { return like(centre.x, value); }
    [[nodiscard]] Triple<S> toWorld(const Vector& v) const {
        const Triple<S> local{number(v.x()), number(v.y()), number(v.z())};
        return {dot(rotation[0], local), dot(rotation[1], local), dot(rotation[2], local)};
    }
};

template <class S> struct Nearest {
    S gap;
    Triple<S> normal, contact, place;
};

// Of one piece below the other's plane: how deep it reaches along -n, and where.
template <class S> struct Extent {
    S reach;
    Triple<S> offset; // from its place
};
template <class S>
Extent<S> lowest(const SurfacePiece& piece, const Place<S>& owner, const Triple<S>& n) {
    using Kind = SurfacePiece::Kind;
    if (piece.kind == Kind::circle) {
        const Triple<S> a = owner.toWorld(piece.axis);
        const Triple<S> tilt = cross(a, n);
        const S across = lengthOf(tilt), radius = owner.number(piece.radius);
        // As a product, exact to rounding however flat the circle lies.
        return {radius * across, (radius / across) * cross(a, tilt)};
    }
    if (piece.kind == Kind::ellipsoid) {
        std::array<Triple<S>, 3> axes{owner.toWorld(piece.axes.col(0)),
                                      owner.toWorld(piece.axes.col(1)),
                                      owner.toWorld(piece.axes.col(2))};
        const Triple<S> along{dot(axes[0], n), dot(axes[1], n), dot(axes[2], n)};
        const S reach = lengthOf(along);
        const Triple<S> sum = along.x * axes[0] + along.y * axes[1] + along.z * axes[2];
        return {reach, owner.number(-1) / reach * sum};
    }
    return {owner.number(piece.radius), owner.number(-piece.radius) * n};
}

// From b to a; `d` from b's place to a's. a's kind does not come after b's, and a is not hollow.
// Places: from a's place.
template <class S>
Nearest<S> between(const SurfacePiece& a, const Place<S>& ofA, const SurfacePiece& b,
                   const Place<S>& ofB, const Triple<S>& d, bool isFlipped) {
    using Kind = SurfacePiece::Kind;
    const Triple<S> none = ofA.toWorld(Vector::Zero());
    if (b.kind == Kind::plane) {
        const Triple<S> n = ofB.toWorld(b.axis);
        const Extent<S> extent = lowest(a, ofA, n);
        return {dot(n, d) - extent.reach, n, extent.offset,
                a.kind == Kind::point ? none : extent.offset};
    }
    const S radius = ofA.number(a.radius);
    const auto round = [&](const Triple<S>& way, const S& length, double both) {
        const bool isWithin = both < 0; // a in the hollow of b
        const Triple<S> n = (isWithin ? ofA.number(-1) * way : way) / length;
        const S gap = isWithin ? ofA.number(-both) - length : length - ofA.number(both);
        return Nearest<S>{gap, n, ofA.number(-a.radius) * n, none};
    };
    if (b.kind == Kind::point)
        return round(d, lengthOf(d), a.radius + b.radius);
    const Triple<S> axis = ofB.toWorld(b.axis);
    const Triple<S> across = d - dot(axis, d) * axis;
    if (a.kind == Kind::line) {
        const Triple<S> own = ofA.toWorld(a.axis);
        const Triple<S> common = isFlipped ? cross(axis, own) : cross(own, axis);
        const Triple<S> n = common / lengthOf(common);
        const S both = dot(own, axis);
        const S way = (both * dot(axis, d) - dot(own, d)) / dot(common, common);
        const Triple<S> on = way * own - radius * n;
        return {dot(n, d) - ofA.number(a.radius + b.radius), n, on, on};
    }
    if (b.kind == Kind::line)
        return round(across, lengthOf(across), a.radius + b.radius);
    if (b.kind == Kind::circle) {
        const Triple<S> foot = (ofA.number(b.radius) / lengthOf(across)) * across;
        return round(d - foot, lengthOf(d - foot), a.radius);
    }
    const double cosine = std::sqrt(1 - b.sine * b.sine);
    const Triple<S> n =
        (ofA.number(cosine) / lengthOf(across)) * across + ofA.number(b.sine) * axis;
    return {dot(n, d) - radius, n, ofA.number(-a.radius) * n, none};
}

template <class S>
Nearest<S> nearestOf(const SurfaceGap& gap, const Place<S>& body, const Place<S>& support) {
    const bool isSwapped = gap.body.kind > gap.support.kind ||
                           (gap.body.kind == gap.support.kind && gap.body.radius < 0);
    const auto& [first, second] =
        isSwapped ? std::pair(&gap.support, &gap.body) : std::pair(&gap.body, &gap.support);
    const Place<S>&a = isSwapped ? support : body, &b = isSwapped ? body : support;
    const Triple<S> place = a.toWorld(first->place);
    const Triple<S> d = (a.centre - b.centre) + (place - b.toWorld(second->place));
    Nearest<S> found = between(*first, a, *second, b, d, gap.isFlipped);
    const Triple<S> at = a.centre + place;
    found.contact = at + found.contact;
    found.place = at + found.place;
    if (isSwapped)
        found.normal = a.number(-1) * found.normal;
    return found;
}

} // namespace physics::surfaces
