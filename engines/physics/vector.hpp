// Vectors of the physics functions: the very types that YADE uses, so that nothing is converted on the way in or out.
#pragma once

#include <Eigen/Core>

namespace grus::physics {

using Vec3 = Eigen::Matrix<double, 3, 1>;
using Mat3 = Eigen::Matrix<double, 3, 3>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

/// a x b, without Eigen's geometry module.
[[gnu::always_inline]] inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// Part of `v` across the unit vector `n`.
inline Vec3 across(const Vec3& v, const Vec3& n) { return v - n * n.dot(v); }

/// Matrix that turns a cross product into a matrix product: skew(a) * b = a x b.
inline Mat3 skew(const Vec3& a) {
    Mat3 m;
    m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return m;
}

}
