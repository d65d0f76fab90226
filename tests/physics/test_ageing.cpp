#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <physics/ageing.hpp>

using namespace grus::physics;

namespace {

constexpr double hour = 3600;

/// Time in which `state` falls from 1 to `end` at `rate(state)`, by Simpson's rule over many equal parts.
template <class Rate> double integral(Rate rate, double end) {
    const int n = 200000;
    const double h = (1 - end) / n;
    double sum = 0;
    for (int i = 0; i <= n; ++i)
        sum += (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) / rate(end + i * h);
    return sum * h / 3;
}

/// What is left after `time` at `rate(state)`, by the classical Runge-Kutta method.
template <class Rate> double integrated(Rate rate, double time, int steps = 20000) {
    double y = 1;
    const double h = time / steps;
    for (int i = 0; i < steps; ++i) {
        const double a = rate(y), b = rate(y - h / 2 * a), c = rate(y - h / 2 * b), d = rate(y - h * c);
        y -= h / 6 * (a + 2 * b + 2 * c + d);
    }
    return y;
}

const PowerLaw glass{18, 50, 1};
const StressCorrosion granite{5e-15, 35, 1};

/// A bond that is pulled and bent, with its ratios as a function of the diameter.
struct CorrodingBond {
    double radius, thickness; // thickness 0: round
    BondLoad load;
    BondStrength strength{3e6, 5e6, 0.3};

    int order() const { return thickness > 0 ? 1 : 2; }
    double diameter() const { return 2 * radius; }
    BondStress stress(double left, double beta = 1) const {
        return rimStress(load, bondSection(left * radius, thickness), left * radius, beta);
    }
    StressRatios ratios() const { return ratiosOfDiameter(stress(1), stress(1, 0), strength, order()); }
};

CorrodingBond bentBond(double thickness) {
    CorrodingBond bond{1e-3, thickness, {}};
    const Section s = bondSection(bond.radius, thickness);
    bond.load.normal = -0.8e6 * s.area;
    bond.load.shear = Vec3(0, 0.6e6 * s.area, 0);
    bond.load.bending = Vec3(0, 0, 0.9e6 * s.inertia / bond.radius);
    bond.load.twist = 0.5e6 * s.polar / bond.radius;
    return bond;
}

}

TEST(PowerLaw, TimeToFailureIsTheIntegralOfTheLaw) {
    for (double ratio : {0.3, 0.6, 0.9, 0.99}) {
        const auto rate = [&](double strength) { return std::pow(ratio / strength, glass.exponent) / glass.time; };
        const double found = timeUntil(glass, 1, ratio, ratio);
        EXPECT_NEAR(found / integral(rate, ratio), 1, 1e-9);
        // The closed form of the whole life.
        const double n = glass.exponent;
        EXPECT_NEAR(found, glass.time / (n + 1) * std::pow(ratio, -n) * (1 - std::pow(ratio, n + 1)), 1e-11 * found);
    }
}

TEST(PowerLaw, AdvancesExactly) {
    const double ratio = 0.7, life = timeUntil(glass, 1, ratio, ratio);
    const auto rate = [&](double strength) { return std::pow(ratio / strength, glass.exponent) / glass.time; };
    for (double share : {1e-6, 0.3, 0.9}) {
        const double left = leftAfter(glass, 1, ratio, share * life);
        EXPECT_NEAR(left, integrated(rate, share * life), 1e-10);
        EXPECT_NEAR(timeUntil(glass, 1, ratio, left) / (share * life), 1, share < 1e-3 ? 1e-6 : 1e-12);
    }
    EXPECT_NEAR(leftAfter(glass, 1, ratio, life), ratio, 1e-12);
}

TEST(PowerLaw, PartsOfALifeAddUp) {
    // The bond looked at again in mid-life: its ratio and the share of its first strength are those of that moment.
    const double ratio = 0.5, life = timeUntil(glass, 1, ratio, ratio);
    const double left = leftAfter(glass, 1, ratio, 0.4 * life), now = ratio / left;
    EXPECT_NEAR(timeUntil(glass, left, now, now), 0.6 * life, 1e-11 * life);
}

TEST(PowerLaw, WeakLoadsLastForeverAndFullLoadsNoTime) {
    EXPECT_EQ(timeUntil({60, 1}, 1, 1e-8, 1e-8), std::numeric_limits<double>::infinity());
    EXPECT_EQ(leftAfter({60, 1}, 1, 1e-8, 1e9), 1);
    EXPECT_EQ(timeUntil(glass, 1, 1, 1), 0);
}

TEST(PowerLaw, BundleSharesItsLoadAsTheKnownCascade) {
    // Strengths c under one force: with k of N left the stress on each is F/k, and the consumption (stress time power)
    // at which the next one fails has a closed form.
    std::vector<double> c{1.0, 1.1, 1.2, 1.35, 1.5};
    const double n = glass.exponent, force = 2.6;
    std::vector<double> expected, found;
    double clock = 0, consumption = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const double stress = force / (c.size() - i);
        const double fatal =
            (std::pow(c[i], n + 1) - std::pow(stress, n + 1)) * glass.time / ((n + 1) * c[i]); // weakest first
        if (fatal > consumption) {
            clock += (fatal - consumption) / std::pow(stress, n);
            consumption = fatal;
        }
        expected.push_back(clock);
    }
    std::vector<double> intact(c.size(), 1);
    clock = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const double stress = force / (c.size() - i);
        const auto ratio = [&](std::size_t j) { return stress / (c[j] * intact[j]); };
        const double step = ratio(i) < 1 ? timeUntil(glass, intact[i], ratio(i), ratio(i)) : 0;
        for (std::size_t j = i + 1; j < c.size() && step > 0; ++j)
            intact[j] *= leftAfter(glass, intact[j], ratio(j), step);
        found.push_back(clock += step);
    }
    for (std::size_t i = 0; i < c.size(); ++i)
        EXPECT_NEAR(found[i], expected[i], 1e-10 * expected.back());
    EXPECT_GT(found[1], found[0]);                 // one at a time at first
    EXPECT_EQ(found.back(), *(&found.back() - 1)); // and the last ones together
}

TEST(StressCorrosion, TimeToFailureIsTheIntegralOfTheLaw) {
    for (double thickness : {0.0, 0.5})
        for (auto which : {AgeingStress::Tension, AgeingStress::Larger}) {
            const CorrodingBond bond = bentBond(thickness);
            const auto rate = [&](double left) {
                const BondStress s = bond.stress(left);
                const double tension = s.tension / bond.strength.tensile;
                const double shear = (s.shear - s.normal * bond.strength.tanPhi) / bond.strength.shear;
                const double ratio = which == AgeingStress::Larger ? std::max(tension, shear) : tension;
                return granite.beta1 / bond.diameter() * std::exp(granite.beta2 * ratio);
            };
            const double end = bond.ratios().leftAtFailure();
            const double found = timeUntil(granite, bond.diameter(), bond.ratios(), which, end);
            EXPECT_NEAR(found / integral(rate, end), 1, 1e-9);
            for (double share : {0.2, 0.8, 0.99}) {
                const double left = leftAfter(granite, bond.diameter(), bond.ratios(), which, share * found);
                EXPECT_NEAR(left, integrated(rate, share * found), 1e-9);
                EXPECT_NEAR(timeUntil(granite, bond.diameter(), bond.ratios(), which, left) / (share * found), 1,
                            1e-12);
            }
        }
}

TEST(StressCorrosion, KinkWhereShearOvertakesTensionIsIntegratedAsWell) {
    CorrodingBond bond = bentBond(0);
    bond.load.bending *= 0;
    bond.load.shear *= 0;
    bond.load.twist *= 2; // its ratio begins below that of the normal force and grows faster
    const StressRatios r = bond.ratios();
    ASSERT_GT(r.tension.at(1), r.shear.at(1));
    ASSERT_EQ(r.mode(), Breakage::Shear);
    const auto rate = [&](double left) {
        return granite.beta1 / bond.diameter() *
               std::exp(granite.beta2 * std::max(r.tension.at(left), r.shear.at(left)));
    };
    const double end = r.leftAtFailure();
    EXPECT_NEAR(timeUntil(granite, bond.diameter(), r, AgeingStress::Larger, end) / integral(rate, end), 1, 1e-8);
}

TEST(StressCorrosion, PureTensionFailsWhereTheSectionIsUsedUp) {
    CorrodingBond bond{1e-3, 0, {}};
    bond.load.normal = -0.25 * bond.strength.tensile * roundSection(bond.radius).area;
    EXPECT_NEAR(bond.ratios().leftAtFailure(), 0.5, 1e-14);
    bond.thickness = 0.2;
    bond.load.normal = -0.25 * bond.strength.tensile * bondSection(bond.radius, bond.thickness).area;
    EXPECT_NEAR(bond.ratios().leftAtFailure(), 0.25, 1e-14);
}

TEST(StressRatios, ReachOneWhereTheLawBreaksTheBond) {
    for (double thickness : {0.0, 0.5})
        for (double pressure : {-0.8e6, 1.5e6}) {
            CorrodingBond bond = bentBond(thickness);
            bond.load.normal = pressure * bondSection(bond.radius, thickness).area;
            bond.load.shear *= pressure > 0 ? 6 : 1;
            const StressRatios r = bond.ratios();
            const double end = r.leftAtFailure();
            ASSERT_GT(end, 0);
            ASSERT_LT(end, 1);
            EXPECT_EQ(failure(bond.stress(end * (1 + 1e-9)), bond.strength), Breakage::None);
            EXPECT_EQ(failure(bond.stress(end * (1 - 1e-9)), bond.strength), r.mode());
            // The same for the strength that ages.
            const StressRatios s = ratiosOfStrength(bond.stress(1), bond.strength);
            const double left = s.leftAtFailure();
            EXPECT_EQ(failure(bond.stress(1), softened(bond.strength, left * (1 + 1e-9))), Breakage::None);
            EXPECT_EQ(failure(bond.stress(1), softened(bond.strength, left * (1 - 1e-9))), s.mode());
        }
}

TEST(StressRatios, StrengthsOfZeroFailAtOnceUnderAnyLoadTheyMustCarry) {
    EXPECT_EQ(ratiosOfStrength({1, 0, -1}, {0, 5, 0}).leftAtFailure(), 1);
    EXPECT_EQ(ratiosOfStrength({-1, 0.2, 1}, {5, 0, 0.5}).leftAtFailure(), 0); // friction carries the shear
    EXPECT_EQ(ratiosOfStrength({-1, 0.7, 1}, {5, 0, 0.5}).leftAtFailure(), 1);
}

TEST(Ageing, OnlyStressFromTheThresholdOnCounts) {
    EXPECT_FALSE(ages(-1, 0));
    EXPECT_FALSE(ages(0, 0));
    EXPECT_TRUE(ages(1e-9, 0));
    EXPECT_FALSE(ages(0.99, 1));
    EXPECT_TRUE(ages(1, 1));
    const BondStress sheared{0.1, 2, 0};
    EXPECT_EQ(ageingStress(sheared, {1, 3, 0.5}, AgeingStress::Tension), 0.1);
    EXPECT_EQ(ageingStress(sheared, {1, 3, 0.5}, AgeingStress::Larger), 2);
    EXPECT_EQ(ageingStress({0.9, 2, 0}, {1, 3, 0.5}, AgeingStress::Larger), 0.9);
}

TEST(Ageing, HumidityScalesTheRate) {
    const CorrodingBond bond = bentBond(0);
    const PowerLaw dry{glass.exponent, glass.time, 0.25};
    const StressCorrosion dryGranite{granite.beta1, granite.beta2, 0.25};
    EXPECT_NEAR(timeUntil(dry, 1, 0.6, 0.6) / timeUntil(glass, 1, 0.6, 0.6), 4, 1e-12);
    EXPECT_NEAR(leftAfter(dry, 1, 0.6, 4 * hour), leftAfter(glass, 1, 0.6, hour), 1e-14);
    EXPECT_NEAR(leftAfter(dryGranite, bond.diameter(), bond.ratios(), AgeingStress::Tension, 4 * hour),
                leftAfter(granite, bond.diameter(), bond.ratios(), AgeingStress::Tension, hour), 1e-14);
}

TEST(Thinned, TakesWhatTheRemovedCementCarried) {
    for (double thickness : {0.0, 0.5}) {
        const CorrodingBond bond = bentBond(thickness);
        const Section s = bondSection(bond.radius, thickness);
        const double left = 0.8;
        const Section after = thinned(s, left, bond.order()), exact = bondSection(left * bond.radius, thickness);
        EXPECT_NEAR(after.area, exact.area, 1e-15 * s.area);
        EXPECT_NEAR(after.inertia, exact.inertia, 1e-14 * s.inertia);
        EXPECT_NEAR(after.polar, exact.polar, 1e-14 * s.inertia);
        // Held in place, every fibre keeps its stress: forces fall as the stiffnesses do.
        const double kn = 3e9, ks = 2e9, share = after.area / s.area;
        const BondStiffness before = bondStiffness(kn * s.area, ks * s.area, s);
        const BondStiffness now = bondStiffness(kn * s.area * share, ks * s.area * share, after);
        const BondLoad rest = thinned(bond.load, left, bond.order());
        EXPECT_NEAR(rest.normal / now.normal, bond.load.normal / before.normal, 1e-20);
        EXPECT_NEAR(rest.shear.norm() / now.shear, bond.load.shear.norm() / before.shear, 1e-20);
        EXPECT_NEAR(rest.bending.norm() / now.bending, bond.load.bending.norm() / before.bending, 1e-15);
        EXPECT_LT(bondEnergy(rest, now), bondEnergy(bond.load, before));
    }
}
