// Relative motion of two spheres, or of a wall and a sphere, at their contact.
#pragma once

#include <physics/vector.hpp>

namespace grus::physics {

/// Displacement [m] of 2 against 1 across the normal in a step `dt`. Rotations act at the ends of the radii along
/// `normal`, and the velocities are scaled to the same points, so that turning the pair as a whole gives no slip, and
/// a closed path of the two no net slip (Garcia-Rojo, McNamara & Herrmann 2005). `distance` = r1 + r2 - overlap.
inline Vec3 slip(const Vec3& vel1, const Vec3& rate1, double r1, const Vec3& vel2, const Vec3& rate2, double r2,
                 double distance, const Vec3& normal, double dt) {
    const double alpha = (r1 + r2) * (1 / distance);
    const Vec3 velocity = (vel2 - vel1) * alpha + cross(rate2, -r2 * normal) - cross(rate1, r1 * normal);
    return across(velocity, normal) * dt;
}

}
