#include "collision/stationary_normal.h"

#include <algorithm>
#include <cmath>

namespace collision {
namespace {

using Kind = Feature::Kind;
using Flat = Eigen::Vector2d;

constexpr double parallel = 1e-9; // sines of angles between axes
constexpr double blurred = 1e-9;  // of the size: a difference of two points that is mostly rounding
constexpr double nothing = 1e-14; // of the size: one that is nothing else
constexpr int mostSteps = 60;
constexpr double longestStep = 0.5; // radians

struct Condition { // n.axis = sine
    Vector axis;
    double sine = 0;
};

// Value, gradient and second derivative of a support function that is homogeneous in n.
struct Support {
    double value = 0;
    Vector gradient = Vector::Zero();
    Matrix second = Matrix::Zero();
};

bool isLinear(const Feature& f) {
    return f.kind == Kind::point || f.kind == Kind::segment || f.kind == Kind::cone;
}

void addSupport(const Feature& f, const Vector& n, Support& sum) {
    sum.value += f.place.dot(n);
    sum.gradient += f.place;
    if (f.kind == Kind::circle) {
        const Vector across = n - f.axis * f.axis.dot(n);
        const double length = across.norm();
        if (!(length > 0))
            return;
        const Vector e = across / length;
        sum.value += f.radius * length;
        sum.gradient += f.radius * e;
        sum.second += f.radius / length *
                      (Matrix::Identity() - f.axis * f.axis.transpose() - e * e.transpose());
    } else if (f.kind == Kind::ellipsoid) {
        const Vector scaled = f.axes.transpose() * n;
        const double length = scaled.norm();
        const Vector point = f.axes * scaled / length;
        sum.value += length;
        sum.gradient += point;
        sum.second += (f.axes * f.axes.transpose() - point * point.transpose()) / length;
    }
}

class Pieces {
public:
    Pieces(const Feature& first, const Feature& second, double size)
        : first_(first), second_(second), size_(size) {
        for (const Feature* f : {&first, &second})
            if (f->kind == Kind::segment || f->kind == Kind::cone)
                conditions_.push_back({f->axis, f->sine});
    }

    [[nodiscard]] std::vector<StationaryNormal> find(const Vector& near) {
        if (conditions_.size() == 2) {
            const Vector cross = conditions_[0].axis.cross(conditions_[1].axis);
            if (cross.norm() > parallel)
                return alongBoth(cross);
            const double sign = conditions_[0].axis.dot(conditions_[1].axis) > 0 ? 1 : -1;
            if (std::abs(conditions_[0].sine - sign * conditions_[1].sine) > parallel)
                return {}; // no normal is common
            conditions_.pop_back();
        }
        if (isLinear(first_) && isLinear(second_))
            return ofPoints(first_.place + second_.place, near);
        if (conditions_.empty() && isPointOnCircle(first_, second_))
            return nearestOnCircle(near);
        return {{newton(near), false}};
    }

private:
    static bool isPointOnCircle(const Feature& a, const Feature& b) {
        return (a.kind == Kind::point && b.kind == Kind::circle) ||
               (a.kind == Kind::circle && b.kind == Kind::point);
    }

    // Both conditions leave two unit vectors.
    [[nodiscard]] std::vector<StationaryNormal> alongBoth(const Vector& cross) const {
        const Vector &u = conditions_[0].axis, &v = conditions_[1].axis;
        const double s = conditions_[0].sine, r = conditions_[1].sine, c = u.dot(v);
        const double square = cross.squaredNorm(); // 1 - c^2
        const double a = (s - c * r) / square, b = (r - c * s) / square;
        const double rest = 1 - a * s - b * r;
        if (rest < 0)
            return {};
        const Vector within = a * u + b * v, out = std::sqrt(rest / square) * cross;
        return {{(within + out).normalized(), false}, {(within - out).normalized(), false}};
    }

    // H = p.n, least against p.
    [[nodiscard]] std::vector<StationaryNormal> ofPoints(const Vector& p,
                                                         const Vector& near) const {
        if (conditions_.empty())
            return {against(p, near)};
        const auto& [u, s] = conditions_[0];
        StationaryNormal found = against(p - u * u.dot(p), near);
        Vector e = found.normal - u * u.dot(found.normal);
        if (!(e.norm() > nothing))
            e = u.unitOrthogonal();
        found.normal = s * u + std::sqrt(1 - s * s) * e.normalized();
        return {found};
    }

    // Of a difference that is rounding, any direction that is known to part them.
    [[nodiscard]] StationaryNormal against(const Vector& p, const Vector& near) const {
        const double length = p.norm();
        if (!(length > nothing * size_))
            return {near, true};
        return {-p / length, length < blurred * size_};
    }

    // Along the line from the point to the nearest one of the circle, and across the circle there.
    [[nodiscard]] std::vector<StationaryNormal> nearestOnCircle(const Vector& near) const {
        const Feature& circle = first_.kind == Kind::circle ? first_ : second_;
        const Vector p = first_.place + second_.place;
        const Vector across = p - circle.axis * circle.axis.dot(p);
        const double length = across.norm();
        if (!(length > nothing * size_))
            return {}; // on the axis: all are as near
        const Vector tangent = circle.axis.cross(across / length);
        StationaryNormal found = against(p - circle.radius / length * across, near);
        found.normal = (found.normal - tangent * tangent.dot(found.normal)).normalized();
        return {found};
    }

    [[nodiscard]] Support supportAt(const Vector& n) const {
        Support sum;
        addSupport(first_, n, sum);
        addSupport(second_, n, sum);
        return sum;
    }

    // Onto the sphere, and onto the circle of the condition.
    [[nodiscard]] Vector retracted(const Vector& n) const {
        if (conditions_.empty())
            return n.normalized();
        const auto& [u, s] = conditions_[0];
        Vector e = n - u * u.dot(n);
        if (!(e.norm() > 1e-12))
            e = u.unitOrthogonal();
        return s * u + std::sqrt(1 - s * s) * e.normalized();
    }

    // The way in which n is to turn.
    [[nodiscard]] Vector stepAt(const Vector& n, const Support& h) const {
        if (!conditions_.empty()) {
            const auto& [u, s] = conditions_[0];
            const Vector e = (n - u * u.dot(n)).normalized(), t = u.cross(e);
            const double bend = t.dot(h.second * t) - h.gradient.dot(e) / std::sqrt(1 - s * s);
            const double least = 1e-12 * size_;
            return -t.dot(h.gradient) / std::max(std::abs(bend), least) * t;
        }
        Eigen::Matrix<double, 3, 2> basis;
        basis.col(0) = n.unitOrthogonal();
        basis.col(1) = n.cross(basis.col(0));
        const Flat slope = basis.transpose() * h.gradient;
        Eigen::Matrix2d bend = basis.transpose() * h.second * basis;
        bend -= h.gradient.dot(n) * Eigen::Matrix2d::Identity();
        // Where H is not convex its slope still leads down.
        const double mean = bend.trace() / 2;
        const double apart = std::hypot((bend(0, 0) - bend(1, 1)) / 2, bend(0, 1));
        const double lowest = mean - apart;
        if (lowest < 1e-12 * size_)
            bend += (1e-12 * size_ + 2 * std::abs(lowest)) * Eigen::Matrix2d::Identity();
        return basis * Flat(-bend.inverse() * slope);
    }

    [[nodiscard]] Vector newton(const Vector& near) const {
        Vector n = retracted(near);
        Support now = supportAt(n);
        const double rounding = 1e-15 * size_;
        for (int k = 0; k < mostSteps; ++k) {
            Vector step = stepAt(n, now);
            const double length = step.norm();
            if (length > longestStep)
                step *= longestStep / length;
            Vector next = retracted(n + step);
            Support then = supportAt(next);
            for (int halvings = 0; then.value > now.value + rounding && halvings < 30; ++halvings) {
                step /= 2;
                next = retracted(n + step);
                then = supportAt(next);
            }
            n = next;
            now = then;
            if (length < 1e-15)
                break;
            // Quadratic convergence: the next step would be its square.
            if (length < 1e-9 && k > 1)
                break;
        }
        return n;
    }

    const Feature &first_, &second_;
    double size_;
    std::vector<Condition> conditions_;
};

} // namespace

Feature reflected(Feature feature) {
    feature.place = -feature.place;
    feature.axis = -feature.axis;
    return feature;
}

std::vector<StationaryNormal> stationaryNormals(const Feature& first, const Feature& second,
                                                const Vector& near, double size) {
    return Pieces(first, second, size).find(near);
}

} // namespace collision
