// Carries a vector stored with a contact along with the contact's motion.
#pragma once

#include <cmath>
#include <limits>

#include <physics/smallangle.hpp>
#include <physics/vector.hpp>

namespace grus::physics {

/// Turns `v`, across the unit vector `from`, by the smallest rotation that brings `from` onto the unit vector `to`.
/// Exact for any angle below pi, so that lengths (and energies) do not creep over many turns; when a body has passed a
/// wall and `to` is -`from`, the vector stays.
inline Vec3 turn(const Vec3& v, const Vec3& from, const Vec3& to) {
    const double share = 1 / (1 + from.dot(to) + std::numeric_limits<double>::min()); // finite for -from, too
    return v - (from + to) * (to.dot(v) * share);
}

/// Turns `v`, across the unit vector `n`, about it by the angle of sine `s` and cosine `c`.
inline Vec3 spin(const Vec3& v, const Vec3& n, double s, double c) { return v * c + cross(n, v) * s; }

/// The same by `angle` [rad].
inline Vec3 spin(const Vec3& v, const Vec3& n, double angle) {
    const bool small = std::abs(angle) < smallAngle;
    return spin(v, n, small ? smallSine(angle) : std::sin(angle), small ? smallCosine(angle) : std::cos(angle));
}

/// Vector in the contact plane after the contact normal went from `before` to `after` and the pair rolled by the
/// mean angle `roll` [rad] about it. What rounding leaves along the new normal is dropped.
inline Vec3 transport(const Vec3& v, const Vec3& before, const Vec3& after, double roll) {
    return across(spin(turn(v, before, after), after, roll), after);
}

/// The same for rolls below `smallAngle`, without a branch.
inline Vec3 transportSmall(const Vec3& v, const Vec3& before, const Vec3& after, double roll) {
    return across(spin(turn(v, before, after), after, smallSine(roll), smallCosine(roll)), after);
}

}
