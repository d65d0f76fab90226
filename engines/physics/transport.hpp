// Carries a vector stored with a contact along with the contact's motion.
#pragma once

#include <cmath>

#include <physics/vector.hpp>

namespace grus::physics {

/// Turns `v` by the smallest rotation that brings the unit vector `from` onto the unit vector `to`.
/// Exact for any angle below pi, so that lengths (and energies) do not creep over many turns.
inline Vec3 turn(const Vec3& v, const Vec3& from, const Vec3& to) {
    const Vec3 axis = from.cross(to); // length = sine of the angle
    const double cosine = from.dot(to);
    return v * cosine + axis.cross(v) + axis * (axis.dot(v) / (1 + cosine));
}

/// Turns `v` by `angle` [rad] about the unit vector `n`.
inline Vec3 spin(const Vec3& v, const Vec3& n, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return v * c + n.cross(v) * s + n * (n.dot(v) * (1 - c));
}

/// Vector in the contact plane after the contact normal went from `before` to `after` and the pair rolled by the
/// mean angle `roll` [rad] about it. What rounding leaves along the new normal is dropped.
inline Vec3 transport(const Vec3& v, const Vec3& before, const Vec3& after, double roll) {
    return across(spin(turn(v, before, after), after, roll), after);
}

}
