// Motion of a rigid body over one step of leapfrog, and local damping (Cundall 1987) that takes a share of the force.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <physics/smallangle.hpp>
#include <physics/vector.hpp>

namespace grus::physics {

using Quat = Eigen::Quaternion<double>;

/// Sign of `x`: -1, 0 or 1.
inline double sign(double x) { return (x > 0 ? 1.0 : 0.0) - (x < 0 ? 1.0 : 0.0); }

/// Acceleration, damped against the velocity in the middle of the step.
inline double damped(double acceleration, double velocity, double damping, double dt) {
    return acceleration * (1 - damping * sign(acceleration * (velocity + 0.5 * dt * acceleration)));
}

/// a b, in place: Eigen's product may stay a call.
inline Quat times(const Quat& a, const Quat& b) {
    return Quat(a.w() * b.w() - a.x() * b.x() - a.y() * b.y() - a.z() * b.z(),
                a.w() * b.x() + a.x() * b.w() + a.y() * b.z() - a.z() * b.y(),
                a.w() * b.y() + a.y() * b.w() + a.z() * b.x() - a.x() * b.z(),
                a.w() * b.z() + a.z() * b.w() + a.x() * b.y() - a.y() * b.x());
}

/// q of unit length.
inline Quat unit(const Quat& q) {
    const double scale = 1 / std::sqrt(q.w() * q.w() + q.x() * q.x() + q.y() * q.y() + q.z() * q.z());
    return Quat(q.w() * scale, q.x() * scale, q.y() * scale, q.z() * scale);
}

/// Orientation after a step `dt` with angular velocity `rate` [rad/s], for bodies whose rotation is integrated by it.
/// Exact to round-off while a step turns by less than twice `smallAngle`.
inline Quat turned(const Quat& orientation, const Vec3& rate, double dt) {
    const double half = 0.5 * dt * rate.norm(), share = 0.5 * dt * smallSinc(half);
    return unit(times(Quat(smallCosine(half), share * rate.x(), share * rate.y(), share * rate.z()), orientation));
}

/// Time derivative of an orientation under the angular velocity `rate` in the body's axes.
inline Quat derivative(const Vec3& rate, const Quat& q) {
    return Quat(0.5 * (-q.x() * rate[0] - q.y() * rate[1] - q.z() * rate[2]),
                0.5 * (q.w() * rate[0] - q.z() * rate[1] + q.y() * rate[2]),
                0.5 * (q.z() * rate[0] + q.w() * rate[1] - q.x() * rate[2]),
                0.5 * (-q.y() * rate[0] + q.x() * rate[1] + q.w() * rate[2]));
}

/// `v` turned by `q`, or scaled besides when q is not of unit length.
inline Vec3 rotate(const Quat& q, const Vec3& v) {
    const Vec3 axis(q.x(), q.y(), q.z()), twice = 2 * cross(axis, v);
    return v + q.w() * twice + cross(axis, twice);
}

inline Quat conjugate(const Quat& q) { return Quat(q.w(), -q.x(), -q.y(), -q.z()); }

/// q + s r
inline Quat sum(const Quat& q, double s, const Quat& r) {
    return Quat(q.w() + s * r.w(), q.x() + s * r.x(), q.y() + s * r.y(), q.z() + s * r.z());
}

/// Rotation of a body with three different moments of inertia (Allen & Tildesley 1989, sec. 3.3): a step `dt` under
/// `torque` [N m]. `momentum` [N m s] and `rate` [rad/s] are global and half a step behind; `inertia` [kg m2] is
/// along the body's axes.
inline void turnAspherical(Quat& orientation, Vec3& momentum, Vec3& rate, const Vec3& torque, const Vec3& inertia,
                           double dt) {
    const Quat back = conjugate(orientation);
    const Vec3 now = rotate(back, momentum + dt / 2 * torque).cwiseQuotient(inertia);
    const Quat half = sum(orientation, dt / 2, derivative(now, orientation));
    momentum += dt * torque;
    const Vec3 later = rotate(back, momentum).cwiseQuotient(inertia);
    const Quat next = sum(orientation, dt, derivative(later, half));
    rate = rotate(next, later); // as YADE does, before the length is set right
    orientation = unit(next);
}

}
