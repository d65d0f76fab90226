// What a contact may have beyond linear springs and Coulomb friction, each by itself or together: Hertz-Mindlin
// stiffness, yielding asperities, rolling resistance. Without branches, so that loops over contacts vectorise.
#pragma once

#include <physics/contact.hpp>
#include <physics/hertz.hpp>
#include <physics/hysteresis.hpp>
#include <physics/rolling.hpp>

namespace grus::physics {

/// All off by default. A Hertz contact has no linear springs beside it.
struct ContactOptions {
    HertzStiffness hertz;
    double unloadingRatio = 1; ///< stiffness of unloading over that of loading [-]
    RollingResistance rolling;

    bool any() const { return hertz.normal > 0 || unloadingRatio > 1 || rolling.stiffness > 0; }
};

/// Normal force [N] and what asperities have taken in this step [J].
struct NormalStep {
    double force, lost, largest;
};

/// A step from the overlap `last` to `overlap` [m]; `largest` overlap before it.
inline NormalStep stepNormal(const Hysteresis& h, const HertzStiffness& hertz, double last, double overlap,
                             double largest) {
    const double yielded = std::max(largest, overlap);
    const double before = hystereticNormal(h, last, largest), trial = hystereticNormal(h, overlap, largest);
    const double after = hystereticNormal(h, overlap, yielded);
    return {after + hertzNormal(hertz, overlap), lostEnergy(before, trial, after, h.stiffness), yielded};
}

/// Shear stiffness [N/m] of an increment at `overlap` [m].
inline double shearStiffness(double ks, const HertzStiffness& h, double overlap) {
    return ks + h.shear * rootOverlap(overlap);
}

/// A spring across the normal whose force or moment has a limit, and the energy that leaves it in a step [J].
struct LimitedStep {
    Vec3 after;
    double lost;
};

/// A step from `before` that would end at `trial`, while half the compliance goes from `from` to `to`. Work of the step
/// less the change of the stored energy, as lostEnergy(): what a spring that gets softer under its load gains without
/// work counts as negative loss.
inline LimitedStep stepLimited(const Vec3& before, const Vec3& trial, double limit, double from, double to) {
    const Vec3 after = slide(trial, limit);
    return {after, (before + after).dot(trial - after) * to + before.squaredNorm() * (from - to)};
}

}
