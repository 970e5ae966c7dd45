#include "collision/moving_shape.h"

#include <algorithm>
#include <cmath>

namespace collision {

namespace {

template <typename Value> Value evaluate(const std::vector<Value>& c, double s) {
    Value sum = c.back();
    for (std::size_t k = c.size() - 1; k-- > 0;)
        sum = sum * s + c[k];
    return sum;
}

template <typename Value> Value derivative(const std::vector<Value>& c, double s) {
    Value sum = Value::Zero();
    for (std::size_t k = c.size(); k-- > 1;)
        sum = sum * s + static_cast<double>(k) * c[k];
    return sum;
}

Quaternion toQuaternion(const Eigen::Vector4d& wxyz) {
    return {wxyz[0], wxyz[1], wxyz[2], wxyz[3]};
}

// sum of |c_k| k^(order) R^(k-order): a bound on the derivative of that order for |s| <= R about
// s0.
double derivativeBound(const std::vector<Eigen::Vector4d>& c, double s0, double radius, int order) {
    // Taylor coefficients about s0, then the triangle inequality.
    std::vector<Eigen::Vector4d> shifted(c);
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        for (std::size_t k = c.size() - 1; k-- > i;)
            shifted[k] += s0 * shifted[k + 1];
    double bound = 0;
    for (std::size_t k = static_cast<std::size_t>(order); k < c.size(); ++k) {
        double factor = 1;
        for (int j = 0; j < order; ++j)
            factor *= static_cast<double>(k - static_cast<std::size_t>(j));
        bound += factor * shifted[k].norm() *
                 std::pow(radius, static_cast<double>(k) - static_cast<double>(order));
    }
    return bound;
}

} // namespace

Vector positionAt(const MotionPiece& piece, double t) {
    return evaluate(piece.position, (t - piece.from) / piece.scale);
}

Quaternion attitudeAt(const MotionPiece& piece, double t) {
    if (piece.attitude.size() == 1)
        return toQuaternion(piece.attitude[0]); // as it is: unit already
    return toQuaternion(evaluate(piece.attitude, (t - piece.from) / piece.scale)).normalized();
}

Velocity velocityAt(const MotionPiece& piece, double t) {
    const double s = (t - piece.from) / piece.scale;
    Velocity v;
    v.linear = derivative(piece.position, s) / piece.scale;
    if (piece.attitude.size() > 1) {
        // w = 2 vec(q' q*) / |q|^2, where q need not have unit length.
        const Quaternion q = toQuaternion(evaluate(piece.attitude, s));
        const Quaternion dq = toQuaternion(derivative(piece.attitude, s) / piece.scale);
        v.angular = 2 * (dq * q.conjugate()).vec() / q.squaredNorm();
    }
    return v;
}

// With |q'| <= Q1, |q''| <= Q2 and |q| >= m:  |w| <= 2 Q1/m,  |w'| <= 2 Q2/m + (2 Q1/m)^2.
TurnBounds turnBounds(const MotionPiece& piece, double from, double to) {
    if (piece.attitude.size() == 1)
        return {};
    const double middle = (from + to) / 2, half = (to - from) / 2;
    const double s0 = (middle - piece.from) / piece.scale, radius = half / piece.scale;
    const double first = derivativeBound(piece.attitude, s0, radius, 1) / piece.scale;
    const double second =
        derivativeBound(piece.attitude, s0, radius, 2) / (piece.scale * piece.scale);
    const double least = evaluate(piece.attitude, s0).norm() - first * half;
    if (least < 0.25) // too long a stretch to say anything: no bound
        return {HUGE_VAL, HUGE_VAL};
    const double speed = 2 * first / least;
    return {speed, 2 * second / least + speed * speed};
}

Pose poseAt(const MovingShape& moving, double t) {
    const MotionPiece& piece = moving.pieceAt(t);
    const Quaternion attitude = attitudeAt(piece, t);
    return {positionAt(piece, t) - attitude * moving.pivot(), attitude};
}

} // namespace collision
