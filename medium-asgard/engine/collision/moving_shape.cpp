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

// Taylor coefficients about s0.
std::vector<Eigen::Vector4d> shiftedTo(std::vector<Eigen::Vector4d> c, double s0) {
    for (std::size_t i = 0; i + 1 < c.size(); ++i)
        for (std::size_t k = c.size() - 1; k-- > i;)
            c[k] += s0 * c[k + 1];
    return c;
}

// sum of |c_k| k^(order) R^(k-order): a bound on the derivative of that order for |s| <= R about
// s0, by the triangle inequality.
double derivativeBound(const std::vector<Eigen::Vector4d>& c, double s0, double radius, int order) {
    const std::vector<Eigen::Vector4d> shifted = shiftedTo(c, s0);
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

// w = P / N with P = 2 vec(q' q*), N = |q|^2, so that
//     |n x w|  <= |n x P| / N      |n x w'| <= |n x P'| / N + |n x P| |N'| / N^2
// The coefficients of n x P vanish where all turning is about n: no bound of |w| is in them.
TurnBounds turnBoundsAcross(const MotionPiece& piece, const Vector& axis, double from, double to) {
    if (piece.attitude.size() == 1)
        return {};
    const double half = (to - from) / 2;
    const double s0 = ((from + to) / 2 - piece.from) / piece.scale, radius = half / piece.scale;
    const std::vector<Eigen::Vector4d> c = shiftedTo(piece.attitude, s0);
    double across = 0, rate = 0, power = 1; // of n x P, n x P'; of the radius
    for (std::size_t k = 0; k + 1 < 2 * c.size() - 1; ++k, power *= radius) {
        Vector p = Vector::Zero(); // of s^k: all (i + 1) c_(i+1) c_j* with i + j = k
        for (std::size_t i = k < c.size() ? 0 : k - c.size() + 1; i + 1 < c.size() && i <= k; ++i)
            p += 2 * static_cast<double>(i + 1) *
                 (toQuaternion(c[i + 1]) * toQuaternion(c[k - i]).conjugate()).vec();
        const double size = axis.cross(p).norm() / piece.scale;
        across += size * power;
        if (k > 0)
            rate += static_cast<double>(k) * size * power / half;
    }
    const double first = derivativeBound(piece.attitude, s0, radius, 1) / piece.scale;
    const double middle = c[0].norm(), least = middle - first * half;
    if (least < 0.25)
        return {HUGE_VAL, HUGE_VAL};
    const double square = least * least;
    return {across / square,
            rate / square + across * 2 * (middle + first * half) * first / (square * square)};
}

Pose poseAt(const MovingShape& moving, double t) {
    const MotionPiece& piece = moving.pieceAt(t);
    const Quaternion attitude = attitudeAt(piece, t);
    return {positionAt(piece, t) - attitude * moving.pivot(), attitude};
}

} // namespace collision
