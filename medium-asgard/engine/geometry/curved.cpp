#include "geometry/curved.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace geometry {
namespace {

using Stretch = std::optional<std::pair<double, double>>; // of a line
constexpr double infinity = std::numeric_limits<double>::infinity();

// Along the part of d across y, r long; zero where d is along y.
Vector onCircle(const Vector& d, double radius) {
    const double across = std::hypot(d.x(), d.z());
    return across > 0 ? Vector(radius * d.x() / across, 0, radius * d.z() / across)
                      : Vector(Vector::Zero());
}

// The farthest point of an ellipsoid from q is x = -a^2 q / (t - a^2) with t > max a^2 and
//     f(t) = sum (a q / (t - a^2))^2 = 1,
// which falls: Newton's method from the left never goes beyond the root. Where q is on the plane
// across the longest axis, the root may be missing: then the end of that axis is it, all but.
double farthestOf(const Vector& axes, const Vector& q) {
    const Vector square = axes.cwiseProduct(axes);
    const double longest = square.maxCoeff();
    if (q.norm() <= 1e-300)
        return axes.maxCoeff();
    double t = longest;
    for (int i = 0; i < 3; ++i)
        t = std::max(t, square[i] + axes[i] * std::abs(q[i]));
    for (int k = 0; k < 100; ++k) {
        double value = -1, slope = 0;
        for (int i = 0; i < 3; ++i)
            if (q[i] != 0) {
                const double part = axes[i] * q[i] / (t - square[i]);
                value += part * part;
                slope -= 2 * part * part / (t - square[i]);
            }
        const double next = t - value / slope;
        if (!(next > t))
            break;
        t = next;
    }
    Vector x = Vector::Zero();
    double rest = 1; // of the sum of squares, for the axis that q says nothing about
    Eigen::Index free = -1;
    for (int i = 0; i < 3; ++i) {
        if (q[i] == 0 && square[i] == longest) {
            free = i;
        } else if (q[i] != 0) {
            x[i] = -square[i] * q[i] / (t - square[i]);
            rest -= x[i] * x[i] / square[i];
        }
    }
    if (free >= 0 && rest > 0)
        x[free] = axes[free] * std::sqrt(rest);
    return (x - q).norm();
}

Stretch common(const Stretch& a, const Stretch& b) {
    if (!a || !b)
        return std::nullopt;
    const std::pair both(std::max(a->first, b->first), std::min(a->second, b->second));
    return both.first <= both.second ? Stretch(both) : std::nullopt;
}

// Where low <= o + s d <= high.
Stretch between(double o, double d, double low, double high) {
    if (d == 0)
        return o >= low && o <= high ? Stretch({-infinity, infinity}) : std::nullopt;
    const double a = (low - o) / d, b = (high - o) / d;
    return std::pair(std::min(a, b), std::max(a, b));
}

// Where a s^2 + 2 b s + c <= 0, for a > 0.
Stretch below(double a, double b, double c) {
    const double square = b * b - a * c;
    if (square < 0)
        return std::nullopt;
    const double q = -(b + std::copysign(std::sqrt(square), b));
    const double one = q / a, other = q != 0 ? c / q : one;
    return std::pair(std::min(one, other), std::max(one, other));
}

// Within the ball of radius 1, from the point of the line that is nearest to its centre: nothing
// cancels far away.
Stretch inBall(const Vector& o, const Vector& d) {
    const double a = d.squaredNorm();
    if (a == 0)
        return o.squaredNorm() <= 1 ? Stretch({-infinity, infinity}) : std::nullopt;
    const double nearest = -o.dot(d) / a;
    const double room = 1 - (o + nearest * d).squaredNorm();
    if (room < 0)
        return std::nullopt;
    const double half = std::sqrt(room / a);
    return std::pair(nearest - half, nearest + half);
}

// x^2 + z^2 <= (r (half - y) / (2 half))^2 for y <= half: of both nappes the lower.
Stretch inCone(const Vector& o, const Vector& d, double radius, double half) {
    const double k = radius / (2 * half), below_ = half - o.y();
    const double a = d.x() * d.x() + d.z() * d.z() - k * k * d.y() * d.y();
    const double b = o.x() * d.x() + o.z() * d.z() + k * k * below_ * d.y();
    const double c = o.x() * o.x() + o.z() * o.z() - k * k * below_ * below_;
    const Stretch height = between(o.y(), d.y(), -half, half);
    if (!height)
        return std::nullopt;
    if (a > 0)
        return common(below(a, b, c), height);
    // Outside between the roots: the lower nappe is what is below the apex.
    const double square = b * b - a * c;
    if (a == 0 || square < 0)
        return a == 0 && b != 0 ? common(b > 0 ? Stretch({-infinity, -c / (2 * b)})
                                               : Stretch({-c / (2 * b), infinity}),
                                         height)
                                : height;
    const double root = std::sqrt(square);
    const double one = std::min((-b + root) / a, (-b - root) / a);
    const double other = std::max((-b + root) / a, (-b - root) / a);
    const Stretch before = common(Stretch({-infinity, one}), height);
    const Stretch after = common(Stretch({other, infinity}), height);
    return d.y() > 0 ? before : after;
}

} // namespace

Vector supportPoint(const Curved& curved, const Vector& direction) {
    const Vector d = curved.frame.transpose() * direction;
    const double half = curved.half();
    Vector own = Vector::Zero();
    switch (curved.kind) {
    case Curved::Kind::cylinder:
    case Curved::Kind::tube:
        own = onCircle(d, curved.radius());
        own.y() = std::copysign(half, d.y());
        break;
    case Curved::Kind::bowl:
        own = d.y() < 0 ? Vector(curved.radius() / d.norm() * d) : onCircle(d, curved.radius());
        break;
    case Curved::Kind::cone:
        if (half * d.y() >= curved.radius() * std::hypot(d.x(), d.z()) - half * d.y()) {
            own.y() = half;
        } else {
            own = onCircle(d, curved.radius());
            own.y() = -half;
        }
        break;
    case Curved::Kind::ellipsoid: {
        const Vector scaled = curved.sizes.cwiseProduct(d);
        if (const double length = scaled.norm(); length > 0)
            own = curved.sizes.cwiseProduct(scaled) / length;
        break;
    }
    case Curved::Kind::plane:
        break;
    }
    return curved.center + curved.frame * own;
}

double radiusAbout(const Curved& curved, const Vector& center) {
    const Vector q = curved.frame.transpose() * (center - curved.center);
    const double across = std::hypot(q.x(), q.z()) + curved.radius(), half = curved.half();
    switch (curved.kind) {
    case Curved::Kind::cylinder:
    case Curved::Kind::tube:
        return std::hypot(across, std::abs(q.y()) + half);
    case Curved::Kind::bowl:
        return q.y() > 0 ? q.norm() + curved.radius() : std::hypot(across, q.y());
    case Curved::Kind::cone:
        return std::max(std::hypot(across, q.y() + half), (q - Vector(0, half, 0)).norm());
    case Curved::Kind::ellipsoid:
        return farthestOf(curved.sizes, q);
    case Curved::Kind::plane:
        break;
    }
    return q.norm();
}

std::optional<std::pair<double, double>> insideAlong(const Curved& curved, const Vector& origin,
                                                     const Vector& direction) {
    const Vector o = curved.frame.transpose() * (origin - curved.center);
    const Vector d = curved.frame.transpose() * direction;
    const double half = curved.half(), radius = curved.radius();
    switch (curved.kind) {
    case Curved::Kind::bowl:
        return common(inBall(o / radius, d / radius), between(o.y(), d.y(), -infinity, 0));
    case Curved::Kind::cylinder:
    case Curved::Kind::tube:
        return common(inBall(Vector(o.x(), 0, o.z()) / radius, Vector(d.x(), 0, d.z()) / radius),
                      between(o.y(), d.y(), -half, half));
    case Curved::Kind::cone:
        return inCone(o, d, radius, half);
    case Curved::Kind::ellipsoid:
        return inBall(o.cwiseQuotient(curved.sizes), d.cwiseQuotient(curved.sizes));
    case Curved::Kind::plane:
        break;
    }
    if (d.y() == 0)
        return o.y() <= 0 ? Stretch({-infinity, infinity}) : std::nullopt;
    const double s = -o.y() / d.y();
    return d.y() > 0 ? Stretch({-infinity, s}) : Stretch({s, infinity});
}

Vector normalAt(const Curved& curved, const Vector& point) {
    const Vector p = curved.frame.transpose() * (point - curved.center);
    const double half = curved.half(), radius = curved.radius();
    const double across = std::hypot(p.x(), p.z());
    Vector own = Vector::UnitY();
    switch (curved.kind) {
    case Curved::Kind::cylinder:
        if (across / radius > std::abs(p.y()) / std::max(half, 1e-300))
            own = Vector(p.x(), 0, p.z()) / across;
        else
            own.y() = std::copysign(1, p.y());
        break;
    case Curved::Kind::cone: {
        // The nearer of the base and the lateral surface.
        const Vector slope = Vector(2 * half, radius, 0).normalized();
        const double lateral = std::abs(slope.x() * across + slope.y() * (p.y() - half));
        if (p.y() + half < lateral)
            own.y() = -1;
        else if (across > 0)
            own = Vector(slope.x() * p.x() / across, slope.y(), slope.x() * p.z() / across);
        break;
    }
    case Curved::Kind::ellipsoid:
        own = p.cwiseQuotient(curved.sizes).cwiseQuotient(curved.sizes).normalized();
        break;
    case Curved::Kind::tube:
    case Curved::Kind::bowl:
    case Curved::Kind::plane:
        break;
    }
    return curved.frame * own;
}

} // namespace geometry
