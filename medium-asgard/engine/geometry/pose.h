// Places and attitudes in space.
//
// Lengths are the author's own coherent unit, angles radians. A pose maps coordinates of a body's
// frame to world coordinates: world = attitude * local + position.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace geometry {

using Vector = Eigen::Vector3d;
using Matrix = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond; // unit length wherever it means an attitude; body to world

struct Pose {
    Vector position = Vector::Zero();
    Quaternion attitude = Quaternion::Identity();

    [[nodiscard]] Vector toWorld(const Vector& local) const { return attitude * local + position; }
    [[nodiscard]] Vector toLocal(const Vector& world) const {
        return attitude.conjugate() * (world - position);
    }
};

// The rotation by |v| radians about v, right-handed. The zero vector is no rotation.
[[nodiscard]] Quaternion fromRotationVector(const Vector& v);

// The inverse; the angle lies in 0..pi.
[[nodiscard]] Vector toRotationVector(const Quaternion& q);

} // namespace geometry
