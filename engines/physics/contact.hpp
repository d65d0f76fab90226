// Linear contact with Coulomb friction (Cundall & Strack 1979). Compression is positive.
#pragma once

#include <algorithm>
#include <cmath>

#include <physics/vector.hpp>

namespace grus::physics {

/// Normal force [N] of a contact without tension; `overlap` [m] positive in compression.
inline double contactNormal(double kn, double overlap) { return overlap > 0 ? kn * overlap : 0; }

/// Energy [J] of a spring over the square of its force: 1 / (2 k) [m/N]; 0 for a missing spring.
inline double halfCompliance(double k) { return k > 0 ? 0.5 / k : 0; }

/// Elastic energy [J] of a spring of stiffness `k` that carries `force`; 0 for a missing spring.
inline double springEnergy(double force, double k) { return force * force * halfCompliance(k); }

/// Energy [J] that leaves a spring of stiffness `k` when a step would take its force from `before` to `trial` but the
/// force ends at `after`: by sliding, or because a bond breaks. Leapfrog moves the bodies against the mean of the
/// forces at both ends of the step, so this is that work less the change of the stored energy, and the balance closes
/// exactly in each step.
inline double lostEnergy(double before, double trial, double after, double k) {
    return (before + after) * (trial - after) * halfCompliance(k);
}

inline double lostEnergy(const Vec3& before, const Vec3& trial, const Vec3& after, double k) {
    return (before + after).dot(trial - after) * halfCompliance(k);
}

/// Factor that limits a shear force of the square `square` [N2] to `limit` [N].
inline double slideFactor(double square, double limit) {
    return square > limit * limit ? limit / std::sqrt(square) : 1;
}

/// The shear force [N], limited to `limit` [N].
inline Vec3 slide(const Vec3& trial, double limit) { return trial * slideFactor(trial.squaredNorm(), limit); }

}
