// Rolling resistance: a moment across the normal that grows with the rolling of two bodies on each other up to a limit
// (Iwashita & Oda 1998; parameters as in YADE's CohFrictMat).
#pragma once

#include <algorithm>

namespace grus::physics {

/// Of a contact.
struct RollingResistance {
    double stiffness = 0; ///< moment per angle over the shear stiffness, alpha R1 R2 [m2]
    double arm = 0;       ///< largest moment over the normal force, eta R [m]
};

/// A body of `radius` [m] with the rolling stiffness `alpha` [-] and the rolling friction `eta` [-].
struct RollingBody {
    double alpha, eta, radius;
};

/// The harmonic mean of both alpha, 0 when one has none, and the smaller of both eta R.
inline RollingResistance rollingResistance(const RollingBody& a, const RollingBody& b) {
    const double sum = a.alpha + b.alpha;
    const double mean = sum > 0 ? 2 * a.alpha * b.alpha / sum : 0;
    return {mean * a.radius * b.radius, std::min(a.eta * a.radius, b.eta * b.radius)};
}

}
