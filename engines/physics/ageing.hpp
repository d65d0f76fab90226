// Static fatigue: how a loaded bond ages and when it fails, by the power law (Charles 1958), which takes strength, or
// by stress corrosion (Potyondy 2007), which takes cement. Everything counts from now: `left` is the share of the
// strength or diameter of now that is still there, 1 now and falling, under forces and moments that stay.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <physics/bond.hpp>

namespace grus::physics {

/// Stress over strength in one mode: force / left^order + moment / left^(order + 1).
struct StressRatio {
    double force = 0, moment = 0; ///< the parts now [-]
    int order = 1;                ///< 1: strength ages, or the diameter of a strip; 2: the diameter of a round section

    double at(double left) const {
        const double area = order == 2 ? left * left : left;
        return (force + moment / left) / area;
    }

    /// What is left when the stress reaches the strength; 1 when it does so now, 0 when it never does.
    double leftAtFailure() const {
        if (!(force + moment < 1))
            return 1;
        if (moment == 0 && force <= 0)
            return 0;
        // left^(order + 1) - force left - moment is convex: Newton's method comes down to the root and stops there.
        double left = 1;
        for (;;) {
            const double power = order == 2 ? left * left : left;
            const double next = left - (left * power - force * left - moment) / ((order + 1) * power - force);
            if (!(next < left))
                return left;
            left = next;
        }
    }
};

/// Both modes of failure. In shear it is the stress beyond the bond's friction over the cohesion, so that both ratios
/// reach 1 where failure() says so.
struct StressRatios {
    StressRatio tension, shear;

    double leftAtFailure() const { return std::max(tension.leftAtFailure(), shear.leftAtFailure()); }
    Breakage mode() const {
        return shear.leftAtFailure() > tension.leftAtFailure() ? Breakage::Shear : Breakage::Tension;
    }
};

/// Stress that has to be carried by cohesion.
inline double beyondFriction(const BondStress& stress, const BondStrength& strength) {
    return stress.shear - stress.normal * strength.tanPhi;
}

namespace detail {

/// Ratio to a strength that may be zero.
inline double over(double stress, double strength) {
    if (strength > 0)
        return stress / strength;
    return stress >= 0 ? std::numeric_limits<double>::infinity() : 0;
}

}

/// Ratios of a bond whose strengths age, both by the same share.
inline StressRatios ratiosOfStrength(const BondStress& stress, const BondStrength& strength) {
    return {{detail::over(stress.tension, strength.tensile), 0, 1},
            {detail::over(beyondFriction(stress, strength), strength.shear), 0, 1}};
}

/// Ratios of a parallel bond whose diameter ages, from the stress at its rim and the part of it that is due to forces
/// (rimStress with beta = 0).
inline StressRatios ratiosOfDiameter(const BondStress& rim, const BondStress& forces, const BondStrength& strength,
                                     int order) {
    const double tension = detail::over(forces.tension, strength.tensile);
    const double shear = detail::over(beyondFriction(forces, strength), strength.shear);
    const auto moment = [](double part, double limit) { return limit > 0 ? part / limit : 0; };
    return {{tension, moment(rim.tension - forces.tension, strength.tensile), order},
            {shear, moment(rim.shear - forces.shear, strength.shear), order}};
}

/// Which stress ages a bond: its peak tension (Potyondy 2007), or tension or shear, whichever is the larger share of
/// its strength.
enum class AgeingStress { Tension, Larger };

/// The stress that ages the bond now [Pa, or N of a contact bond].
inline double ageingStress(const BondStress& stress, const BondStrength& strength, AgeingStress which) {
    const StressRatios now = ratiosOfStrength(stress, strength);
    const bool shear = which == AgeingStress::Larger && now.shear.force > now.tension.force;
    return shear ? beyondFriction(stress, strength) : stress.tension;
}

/// The ratio that sets the rate of ageing.
inline double ageingRatio(const StressRatios& ratios, AgeingStress which, double left) {
    const double tension = ratios.tension.at(left);
    return which == AgeingStress::Larger ? std::max(tension, ratios.shear.at(left)) : tension;
}

/// Whether a bond ages under this stress; never in compression.
inline bool ages(double stress, double threshold) { return stress > 0 && stress >= threshold; }

/// d(strength)/dt = -(humidity strength_0 / time) ratio^exponent, with strength_0 that of the unaged bond.
struct PowerLaw {
    double exponent = 0; ///< n [-]
    double time = 0;     ///< t0 [s]
    double humidity = 1; ///< relative humidity, to which the rate is proportional, 0 to 1 [-]
};

/// Time [s] until `left` of the present strength is left, which is the share `intact` of the unaged one; `ratio` is
/// that of now.
inline double timeUntil(const PowerLaw& law, double intact, double ratio, double left) {
    const double power = law.exponent + 1;
    return law.time * intact / (power * law.humidity) * std::pow(ratio, -law.exponent) *
           -std::expm1(power * std::log(left));
}

/// What is left after `time` [s], which must not be beyond failure.
inline double leftAfter(const PowerLaw& law, double intact, double ratio, double time) {
    const double power = law.exponent + 1;
    const double spent = power * law.humidity * time / (law.time * intact) * std::pow(ratio, law.exponent);
    return std::exp(std::log1p(-std::min(spent, 1.0)) / power);
}

/// d(diameter)/dt = -humidity beta1 exp(beta2 ratio).
struct StressCorrosion {
    double beta1 = 0;    ///< [m/s]
    double beta2 = 0;    ///< [-]
    double humidity = 1; ///< relative humidity, to which the rate is proportional, 0 to 1 [-]
};

namespace detail {

/// Time [s] in which the diameter falls from `from` to `to` of its present value, to a relative 1e-12.
inline double corrosionTime(const StressCorrosion& law, double diameter, const StressRatios& ratios, AgeingStress which,
                            double from, double to) {
    if (!(from > to))
        return 0;
    // Over the unit interval: Boost compares an error without the length of the interval with a limit that contains it.
    const auto slowness = [&](double part) {
        return std::exp(-law.beta2 * ageingRatio(ratios, which, from - part * (from - to)));
    };
    using boost::math::quadrature::gauss_kronrod;
    const double mean = gauss_kronrod<double, 31>::integrate(slowness, 0.0, 1.0, 15, 1e-12);
    return diameter / (law.humidity * law.beta1) * (from - to) * mean;
}

}

/// Time [s] until `left` of the present `diameter` [m] is left.
inline double timeUntil(const StressCorrosion& law, double diameter, const StressRatios& ratios, AgeingStress which,
                        double left) {
    return detail::corrosionTime(law, diameter, ratios, which, 1, left);
}

/// What is left of the present `diameter` [m] after `time` [s], which must not be beyond failure.
inline double leftAfter(const StressCorrosion& law, double diameter, const StressRatios& ratios, AgeingStress which,
                        double time) {
    // The rate grows as the diameter falls, so each step at the rate of its beginning ends short of the time asked for.
    double left = 1, remaining = time;
    while (remaining > 1e-14 * time) {
        const double rate =
            law.humidity * law.beta1 / diameter * std::exp(law.beta2 * ageingRatio(ratios, which, left));
        const double next = left - remaining * rate;
        if (!(next < left))
            break;
        remaining -= detail::corrosionTime(law, diameter, ratios, which, left, next);
        left = next;
    }
    return left;
}

/// Section of a bond whose diameter falls to the share `left`.
inline Section thinned(const Section& s, double left, int order) {
    const double area = std::pow(left, order), inertia = area * left * left;
    return {s.area * area, s.inertia * inertia, s.polar * inertia};
}

/// What a bond carries once its diameter has fallen to the share `left` while it was held in place: the cement that is
/// gone takes its stresses with it.
inline BondLoad thinned(const BondLoad& load, double left, int order) {
    const double area = std::pow(left, order), inertia = area * left * left;
    return {load.normal * area, load.shear * area, load.bending * inertia, load.twist * inertia};
}

/// Strengths after wetting (Oldecop & Alonso 2001), by the softening `factor` [-].
inline BondStrength softened(const BondStrength& strength, double factor) {
    return {strength.tensile * factor, strength.shear * factor, strength.tanPhi};
}

}
