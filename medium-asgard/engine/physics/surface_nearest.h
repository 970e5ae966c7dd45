// The formulas of surface_gap.h, for numbers and for expressions.
#pragma once

#include "physics/node_vector.h"
#include "physics/surface_piece.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace physics::surfaces {

// An expression that is written as a number is; `owner` has its numbers (numberOf()).
struct Term {
    Graph* graph = nullptr;
    Node node, owner;
};
inline Term like(Term a, Node node) { return {a.graph, node, a.owner}; }
inline Term operator+(Term a, Term b) { return like(a, a.graph->add(a.node, b.node)); }
inline Term operator-(Term a, Term b) { return like(a, a.graph->subtract(a.node, b.node)); }
inline Term operator*(Term a, Term b) { return like(a, a.graph->multiply(a.node, b.node)); }
inline Term operator/(Term a, Term b) { return like(a, a.graph->divide(a.node, b.node)); }
inline Term sqrt(Term a) { return like(a, a.graph->apply(Op::sqrt, a.node)); }
inline Term like(Term a, double value) { return like(a, numberOf(*a.graph, value, a.owner)); }
inline double like(double, double value) { return value; }

template <class S> struct Triple { S x, y, z; };
inline Triple<Term> like(Term a, const Vector& v) {
    const NodeVector of = numbersOf(*a.graph, v, a.owner);
    return {like(a, of[0]), like(a, of[1]), like(a, of[2])};
}
template <class S> Triple<S> like(const S& a, const Vector& v) {
    return {like(a, v.x()), like(a, v.y()), like(a, v.z())};
}
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
        const Triple<S> local = like(centre.x, v);
        return {dot(rotation[0], local), dot(rotation[1], local), dot(rotation[2], local)};
    }
};

template <class S> struct Nearest {
    S gap;
    Triple<S> normal, contact, place;
    S steady; // of curves with feet, else 1
    // From the centres of the body and of the support to the contact: exact however far these are
    // from the origin.
    std::array<Triple<S>, 2> arms = {};
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

template <class S> Triple<S> unit(const Triple<S>& a) { return a / lengthOf(a); }

// Of two curves: a line or a circle, and a circle. Each step of Newton's method for the points that
// are nearest to each other begins at those of the step before, the first where `branch` says
// (surface_gap.h); a point moves along its tangent and from there back onto its circle. Of a line
// the nearest point to any other is known.
constexpr int stepsFromFeet = 4, stepsFromSphere = 2;

template <class S> struct Circle {
    Triple<S> axis;
    S radius;
    Triple<S> out; // from the centre to the point, a unit vector

    Circle(const SurfacePiece& piece, const Place<S>& owner)
        : axis(owner.toWorld(piece.axis)), radius(owner.number(piece.radius)),
          out(owner.toWorld(piece.foot)) {}
    [[nodiscard]] Triple<S> tangent() const { return cross(axis, out); }
    void move(const S& angle) { out = unit(out + angle * tangent()); }
    void turnTo(const Triple<S>& point) { out = unit(point - dot(axis, point) * axis); }
};

template <class S> struct Crossing { // of two curves
    Triple<S> apart;                 // from the second's point to the first's
    Triple<S> first, second;         // the tangents there
    Triple<S> offset;                // of the first's point, from its place
    S steady;                        // surface_gap.h
};

// The root of what is below 0 beyond where a curve leaves a sphere: there next to 0, so that a step
// that goes too far has a value too.
template <class S> S rootOf(const S& sine) {
    using std::sqrt;
    constexpr double least = 0.01 * leastSteady;
    return sqrt((sine + sqrt(sine * sine + like(sine, least * least))) / like(sine, 2));
}

// The first circle leaves the sphere about the second; `d` from the second's centre to the first's.
// Gives the square of the sine of the angle at which it does.
template <class S>
S beginOnSphere(Circle<S>& first, Circle<S>& second, const Triple<S>& d, double branch) {
    const Triple<S> to = like(first.radius, -1) * d, across = cross(first.axis, to);
    const S square = second.radius * second.radius, wide = dot(across, across);
    const S way =
        (first.radius * first.radius + dot(to, to) - square) / (like(square, 2) * first.radius);
    const S sine = (wide - way * way) / square;
    first.out = (way * cross(across, first.axis) +
                 like(sine, branch) * second.radius * rootOf(sine) * across) /
                wide;
    second.turnTo(first.radius * first.out - to);
    return sine;
}

// `d` from the circle's centre to the line's place.
template <class S>
Crossing<S> crossingOf(const Triple<S>& line, Circle<S> circle, const Triple<S>& d) {
    for (int i = 0;; ++i) {
        const Triple<S> from = d - circle.radius * circle.out, tangent = circle.tangent();
        const Triple<S> apart = from - dot(line, from) * line;
        const S across = dot(line, tangent), bends = dot(apart, circle.out) / circle.radius;
        const S steady = like(across, 1) - across * across + bends;
        if (i == stepsFromFeet)
            return {apart, line, tangent, apart + circle.radius * circle.out - d, steady};
        circle.move(dot(apart, tangent) / circle.radius / steady);
    }
}

// `d` from the second's centre to the first's.
template <class S>
Crossing<S> crossingOf(Circle<S> first, Circle<S> second, const Triple<S>& d, double branch) {
    std::optional<S> sine;
    if (branch != 0)
        sine = beginOnSphere(first, second, d, branch);
    for (int i = 0;; ++i) {
        const Triple<S> offset = first.radius * first.out;
        const Triple<S> apart = d + offset - second.radius * second.out;
        const Triple<S> along = first.tangent(), other = second.tangent();
        // How far the points move, with the rates of their distance's half square.
        const S one = dot(apart, along), two = dot(apart, other), both = dot(along, other);
        const S ofFirst = like(both, 1) - dot(apart, first.out) / first.radius;
        const S ofSecond = like(both, 1) + dot(apart, second.out) / second.radius;
        const S steady = ofFirst * ofSecond - both * both;
        if (i == (sine ? stepsFromSphere : stepsFromFeet))
            return {apart, along, other, offset, sine.value_or(steady)};
        first.move((two * both - one * ofSecond) / steady / first.radius);
        second.move((two * ofFirst - one * both) / steady / second.radius);
    }
}

// From b to a; `d` from b's place to a's. a's kind does not come after b's, and a is not hollow.
// Places: from a's place.
template <class S>
Nearest<S> between(const SurfacePiece& a, const Place<S>& ofA, const SurfacePiece& b,
                   const Place<S>& ofB, const Triple<S>& d, const SurfaceGap& gap) {
    using Kind = SurfacePiece::Kind;
    const Triple<S> none = ofA.toWorld(Vector::Zero());
    if (b.kind == Kind::plane) {
        const Triple<S> n = ofB.toWorld(b.axis);
        const Extent<S> extent = lowest(a, ofA, n);
        return {dot(n, d) - extent.reach, n, extent.offset,
                a.kind == Kind::point ? none : extent.offset, ofA.number(1)};
    }
    const S radius = ofA.number(a.radius);
    const auto round = [&](const Triple<S>& way, const S& length, double both) {
        const bool isWithin = both < 0; // a in the hollow of b
        const Triple<S> n = (isWithin ? ofA.number(-1) * way : way) / length;
        const S apart = isWithin ? ofA.number(-both) - length : length - ofA.number(both);
        return Nearest<S>{apart, n, ofA.number(-a.radius) * n, none, ofA.number(1)};
    };
    if (b.kind == Kind::point)
        return round(d, lengthOf(d), a.radius + b.radius);
    if (b.kind == Kind::circle && a.kind != Kind::point) {
        const Circle<S> circle(b, ofB);
        const Crossing<S> found = a.kind == Kind::line
                                      ? crossingOf(ofA.toWorld(a.axis), circle, d)
                                      : crossingOf(Circle<S>(a, ofA), circle, d, gap.branch);
        if (a.kind == Kind::line && a.radius > 0) {
            const S length = lengthOf(found.apart);
            const Triple<S> n = found.apart / length, on = found.offset - found.apart;
            return {length - radius, n, on, on, found.steady};
        }
        const Triple<S> n = unit(gap.isFlipped ? cross(found.second, found.first)
                                               : cross(found.first, found.second));
        return {dot(n, found.apart), n, found.offset, found.offset, found.steady};
    }
    const Triple<S> axis = ofB.toWorld(b.axis);
    const Triple<S> across = d - dot(axis, d) * axis;
    if (a.kind == Kind::line) {
        const Triple<S> own = ofA.toWorld(a.axis);
        const Triple<S> common = gap.isFlipped ? cross(axis, own) : cross(own, axis);
        const Triple<S> n = common / lengthOf(common);
        const S both = dot(own, axis);
        const S way = (both * dot(axis, d) - dot(own, d)) / dot(common, common);
        const Triple<S> on = way * own - radius * n;
        return {dot(n, d) - ofA.number(a.radius + b.radius), n, on, on, ofA.number(1)};
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
    return {dot(n, d) - radius, n, ofA.number(-a.radius) * n, none, ofA.number(1)};
}

template <class S>
Nearest<S> nearestOf(const SurfaceGap& gap, const Place<S>& body, const Place<S>& support) {
    const bool isSwapped = gap.body.kind > gap.support.kind ||
                           (gap.body.kind == gap.support.kind && gap.body.radius < 0);
    const auto& [first, second] =
        isSwapped ? std::pair(&gap.support, &gap.body) : std::pair(&gap.body, &gap.support);
    const Place<S>&a = isSwapped ? support : body, &b = isSwapped ? body : support;
    const Triple<S> place = a.toWorld(first->place);
    const Triple<S> apart = a.centre - b.centre;
    const Triple<S> d = apart + (place - b.toWorld(second->place));
    Nearest<S> found = between(*first, a, *second, b, d, gap);
    const Triple<S> at = a.centre + place, own = place + found.contact;
    found.arms[isSwapped ? 1 : 0] = own;
    found.arms[isSwapped ? 0 : 1] = apart + own;
    found.contact = at + found.contact;
    found.place = at + found.place;
    if (isSwapped)
        found.normal = a.number(-1) * found.normal;
    return found;
}

} // namespace physics::surfaces
