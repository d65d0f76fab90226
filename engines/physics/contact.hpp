// Linear contact with Coulomb friction (Cundall & Strack 1979). Compression is positive.
#pragma once

#include <algorithm>
#include <cmath>

#include <physics/vector.hpp>

namespace grus::physics {

/// Normal force [N] of a contact without tension; `overlap` [m] positive in compression.
inline double contactNormal(double kn, double overlap) { return overlap > 0 ? kn * overlap : 0; }

/// Elastic energy [J] of a spring of stiffness `k` that carries `force`; 0 for a missing spring.
inline double springEnergy(double force, double k) { return k > 0 ? force * force / (2 * k) : 0; }

/// Limits the shear force to `limit` [N] in place; returns the work [J] done by sliding, with `ks` [N/m]. `before` [N] is
/// the shear force of the last step: the mean of old and new force, times the slip, is what leapfrog does in a step, so
/// the energy balance also holds while the limit changes (and when the contact opens and the limit drops to 0).
inline double slide(Vec3& shear, double limit, double ks, double before) {
    const double trial = shear.norm();
    if (trial <= limit) return 0;
    shear *= limit / trial;
    return ks > 0 ? (trial - limit) / ks * (before + limit) / 2 : 0;
}

}
