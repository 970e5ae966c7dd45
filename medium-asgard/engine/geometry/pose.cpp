#include "geometry/pose.h"

#include <cmath>

namespace geometry {

Quaternion fromRotationVector(const Vector& v) {
    const double angle = v.norm();
    // sin(a/2)/a to the last bit where the quotient would be 0/0; the next term is a^2/48.
    const double factor = angle < 1e-8 ? 0.5 : std::sin(angle / 2) / angle;
    const Vector imaginary = factor * v;
    return Quaternion(std::cos(angle / 2), imaginary.x(), imaginary.y(), imaginary.z())
        .normalized();
}

Vector toRotationVector(const Quaternion& q) {
    // q and -q are the same rotation; the one with w >= 0 has the angle in 0..pi.
    const double sign = q.w() < 0 ? -1 : 1;
    const double sine = q.vec().norm();
    if (sine < 1e-8)
        return 2 * sign * q.vec(); // asin(s) = s to the last bit
    return sign * q.vec() / sine * (2 * std::atan2(sine, sign * q.w()));
}

} // namespace geometry
