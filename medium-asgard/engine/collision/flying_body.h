// A body in free flight under constant acceleration and constant spin. For tests.
#pragma once

#include "collision/moving_shape.h"

#include <cmath>

namespace collision {

class FlyingBody : public MovingShape {
public:
    geometry::Shape form;
    double since = 0; // the state below is of this time
    Vector position = Vector::Zero(), velocity = Vector::Zero(), acceleration = Vector::Zero();
    Quaternion attitude = Quaternion::Identity();
    Vector spin = Vector::Zero();

    [[nodiscard]] const geometry::Shape& shape() const override { return form; }
    [[nodiscard]] Vector pivot() const override { return Vector::Zero(); }
    [[nodiscard]] const MotionPiece& pieceAt(double t) const override {
        const double speed = spin.norm();
        double from = since, until = HUGE_VAL;
        if (speed > 0) { // half a radian each
            const double length = 0.5 / speed;
            double k = std::floor((t - since) / length);
            while (since + (k + 1) * length <= t)
                ++k;
            from = since + k * length;
            until = since + (k + 1) * length;
        }
        piece_.from = from;
        piece_.until = until;
        const double s = from - since;
        piece_.position = {position + velocity * s + acceleration * (s * s / 2)};
        if (velocity != Vector::Zero() || acceleration != Vector::Zero()) {
            piece_.position.emplace_back(velocity + acceleration * s);
            piece_.position.emplace_back(acceleration / 2);
        }
        setAttitude(speed, from, until);
        return piece_;
    }
    // The state at t becomes the present one.
    void moveTo(double t) {
        const double s = t - since;
        position += velocity * s + acceleration * (s * s / 2);
        velocity += acceleration * s;
        attitude = (geometry::fromRotationVector(spin * s) * attitude).normalized();
        since = t;
    }

private:
    // exp(w s / 2) q, by powers of s about the middle of the piece, moved to its start: exact to
    // 1e-14.
    void setAttitude(double speed, double from, double until) const {
        const auto wxyz = [](const Quaternion& q) {
            return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
        };
        if (speed == 0) {
            piece_.attitude = {wxyz(attitude)};
            return;
        }
        const double middle = (from + until) / 2;
        const Quaternion q = geometry::fromRotationVector(spin * (middle - since)) * attitude;
        const Vector axis = spin / speed;
        const Quaternion turned = Quaternion(0, axis.x(), axis.y(), axis.z()) * q;
        piece_.attitude.assign(maximumDegree + 1, Eigen::Vector4d::Zero());
        double factor = 1; // (w/2)^k / k!
        for (std::size_t k = 0; k <= maximumDegree; ++k) {
            const double sign = k % 4 < 2 ? 1 : -1;
            piece_.attitude[k] = sign * factor * wxyz(k % 2 ? turned : q);
            factor *= speed / 2 / static_cast<double>(k + 1);
        }
        for (std::size_t i = 0; i < maximumDegree; ++i)
            for (std::size_t k = maximumDegree; k-- > i;)
                piece_.attitude[k] += (from - middle) * piece_.attitude[k + 1];
    }

    mutable MotionPiece piece_;
};

[[nodiscard]] inline FlyingBody flyingSphere(double radius, const Vector& position,
                                             const Vector& velocity = Vector::Zero()) {
    FlyingBody body;
    body.form.parts.push_back(geometry::spherePart(radius));
    body.position = position;
    body.velocity = velocity;
    return body;
}

[[nodiscard]] inline FlyingBody flyingBox(const Vector& edges, const Vector& position,
                                          const Vector& velocity = Vector::Zero()) {
    FlyingBody body;
    body.form.parts.push_back(geometry::polyhedronPart(geometry::box(edges)));
    body.position = position;
    body.velocity = velocity;
    return body;
}

} // namespace collision
