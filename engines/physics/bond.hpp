// Contact bond and parallel bond (Potyondy & Cundall 2004; moment contribution after Potyondy 2011).
// Forces act on particle 2 of a pair, normals point from 1 to 2, compression is positive.
#pragma once

#include <algorithm>
#include <cmath>

#include <physics/contact.hpp>
#include <physics/section.hpp>
#include <physics/vector.hpp>

namespace grus::physics {

enum class Breakage { None = 0, Tension = 1, Shear = 2 };

/// What a parallel bond carries.
struct BondLoad {
    double normal = 0;           ///< force along the normal [N], tension negative
    Vec3 shear = Vec3::Zero();   ///< force across the normal [N]
    Vec3 bending = Vec3::Zero(); ///< moment across the normal [N m]
    double twist = 0;            ///< moment about the normal [N m]
};

/// Stiffnesses of a whole bond section.
struct BondStiffness {
    double normal = 0;  ///< [N/m]
    double shear = 0;   ///< [N/m]
    double bending = 0; ///< [N m/rad]
    double twist = 0;   ///< [N m/rad]
};

/// Limits of a bond: stresses [Pa] for a parallel bond, forces [N] for a contact bond.
struct BondStrength {
    double tensile = 0; ///< largest tension
    double shear = 0;   ///< shear strength without normal load (the cohesion, when friction is given)
    double tanPhi = 0;  ///< tangent of the friction angle of the bond; 0: constant shear strength
};

/// Largest tension and largest shear at the rim of a bond, or the two forces of a contact bond.
struct BondStress {
    double tension = 0; ///< tension positive
    double shear = 0;
    double normal = 0; ///< mean normal stress, compression positive
};

/// Stiffnesses from those of the section, normal and shear [N/m] (Potyondy & Cundall 2004).
inline BondStiffness bondStiffness(double kn, double ks, const Section& s) {
    const double perArea = 1 / s.area;
    return {kn, ks, kn * s.inertia * perArea, ks * s.polar * perArea};
}

/// Adds a step of relative motion. `stretch` is the total change of the overlap since birth [m]; the others are
/// increments: `slip` of particle 2 against 1 across the normal [m], `rotation` of 1 against 2 [rad].
inline void deform(BondLoad& load, const BondStiffness& k, double stretch, const Vec3& slip, const Vec3& rotation,
                   const Vec3& normal) {
    load.normal = k.normal * stretch;
    load.shear -= k.shear * slip;
    load.bending += k.bending * across(rotation, normal);
    load.twist += k.twist * rotation.dot(normal);
}

/// Shear strength under the mean normal stress `normal` (compression positive), Mohr-Coulomb, never below zero.
inline double shearStrength(const BondStrength& strength, double normal) {
    return std::max(0.0, strength.shear + normal * strength.tanPhi);
}

/// Mode in which a bond fails under `stress`; when both limits are met, the one exceeded by the larger share.
inline Breakage failure(const BondStress& stress, const BondStrength& strength) {
    const double limit = shearStrength(strength, stress.normal);
    const bool tension = stress.tension >= strength.tensile;
    const bool shear = stress.shear >= limit;
    if (tension && shear)
        return stress.shear * strength.tensile > stress.tension * limit ? Breakage::Shear : Breakage::Tension;
    return tension ? Breakage::Tension : shear ? Breakage::Shear : Breakage::None;
}

/// What turns the load of a bond into stresses: the rim stress of a force of 1 N and of moments of 1 N m.
struct RimFactors {
    double force = 1;   ///< [1/m2]
    double bending = 0; ///< [1/m3]
    double twist = 0;   ///< [1/m3]
};

inline RimFactors rimFactors(const Section& s, double radius, double beta) {
    return {1 / s.area, beta * radius / s.inertia, s.polar > 0 ? beta * radius / s.polar : 0};
}

/// Stresses at the rim of a parallel bond.
inline BondStress rimStress(const BondLoad& load, const RimFactors& f) {
    const double mean = load.normal * f.force;
    return {-mean + f.bending * load.bending.norm(), f.force * load.shear.norm() + f.twist * std::abs(load.twist),
            mean};
}

/// The same of a bond of radius `radius`; `beta` in [0, 1] weighs the moments.
inline BondStress rimStress(const BondLoad& load, const Section& s, double radius, double beta) {
    return rimStress(load, rimFactors(s, radius, beta));
}

/// False when failure() is None for sure; without a root, for loops over many bonds.
inline bool mayFail(const BondLoad& load, const RimFactors& f, const BondStrength& strength) {
    constexpr double margin = 1 + 1e-12; // for what squares round otherwise than roots
    const double mean = load.normal * f.force;
    const double bending = strength.tensile + mean; // stress that bending has still free
    const double shear = shearStrength(strength, mean) - f.twist * std::abs(load.twist);
    const bool torn = f.bending * f.bending * load.bending.squaredNorm() * margin >= bending * std::abs(bending);
    const bool sheared = f.force * f.force * load.shear.squaredNorm() * margin >= shear * std::abs(shear);
    return torn || sheared;
}

/// Elastic energy [J] stored in a parallel bond.
inline double bondEnergy(const BondLoad& load, const BondStiffness& k) {
    return springEnergy(load.normal, k.normal) + springEnergy(load.shear.norm(), k.shear) +
           springEnergy(load.bending.norm(), k.bending) + springEnergy(load.twist, k.twist);
}

/// Energy [J] released by a parallel bond that broke in the step from `before` to `trial`.
inline double releasedEnergy(const BondLoad& before, const BondLoad& trial, const BondStiffness& k) {
    const Vec3 none = Vec3::Zero();
    return lostEnergy(before.normal, trial.normal, 0, k.normal) + lostEnergy(before.shear, trial.shear, none, k.shear) +
           lostEnergy(before.bending, trial.bending, none, k.bending) +
           lostEnergy(before.twist, trial.twist, 0, k.twist);
}

}
