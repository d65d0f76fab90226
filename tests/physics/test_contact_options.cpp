// Hertz-Mindlin stiffness, yielding asperities and rolling resistance: formulas, and the balance of energy.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <physics/pairlaw.hpp>

using namespace grus::physics;

namespace {

const ElasticSphere small{70e9, 0.3, 0.01}, large{50e9, 0.2, 0.03};
constexpr double rigid = std::numeric_limits<double>::infinity();

/// Pair with all that may go together: linear springs with yielding asperities, or Hertz, with rolling resistance.
PairConstants constants(bool hertz) {
    PairConstants c;
    c.tanPhi = 0.4;
    if (hertz)
        c.options.hertz = {2e3, 1.5e3};
    else {
        c.kn = 20;
        c.ks = 15;
        c.options.unloadingRatio = 2.5;
    }
    c.options.rolling = {0.3, 0.02};
    return c;
}

/// Presses, unloads, shears and rolls a pair to and fro, without opening it.
struct Drive {
    PairState state;
    double work = 0, lost = 0;
    int count = 0; ///< steps in which a limit was met or asperities yielded

    void run(const PairConstants& c, int steps) {
        for (int i = 0; i < steps; ++i)
            step(c, i * 10.0 / steps, (i + 1) * 10.0 / steps);
    }
    static double overlap(double t) { return 0.02 * std::min(t, 1.0) * (1 - 0.3 * std::cos(t)) * (1 + 0.1 * t); }

    void step(const PairConstants& c, double from, double to) {
        const Vec3 normal(1, 0, 0), slip(0, 0.004 * (std::sin(3 * to) - std::sin(3 * from)), 0.002 * (to - from));
        const Vec3 rotation(0, 0, 0.01 * (std::cos(2 * to) - std::cos(2 * from)));
        const PairState before = state;
        const PairEvents events = stepPair(state, c, {}, {overlap(to), slip, rotation, normal, 0});
        work += 0.5 * (before.contactNormal + state.contactNormal) * (overlap(to) - overlap(from)) -
                0.5 * (before.contactShear + state.contactShear).dot(slip) +
                0.5 * (before.rolling + state.rolling).dot(rotation);
        lost += events.sliding;
        count += events.sliding > 1e-12;
    }
};

}

TEST(Hertz, StiffnessOfTwoSpheres) {
    // Equal spheres: E* = E / (2 (1 - nu^2)), G* = G / (2 (2 - nu)), R* = R / 2.
    const ElasticSphere s{70e9, 0.3, 0.01};
    const HertzStiffness h = hertzStiffness(s, s);
    const double shear = 70e9 / 2.6;
    EXPECT_NEAR(h.normal / (4.0 / 3 * 70e9 / (2 * 0.91) * std::sqrt(0.005)), 1, 1e-14);
    EXPECT_NEAR(h.shear / (8 * shear / (2 * 1.7) * std::sqrt(0.005)), 1, 1e-14);
}

TEST(Hertz, OrderOfTheSpheresDoesNotMatter) {
    EXPECT_DOUBLE_EQ(hertzStiffness(small, large).normal, hertzStiffness(large, small).normal);
    EXPECT_DOUBLE_EQ(hertzStiffness(small, large).shear, hertzStiffness(large, small).shear);
}

TEST(Hertz, ARigidPartnerDoublesTheModulus) {
    const HertzStiffness both = hertzStiffness(small, small), one = hertzStiffness(small, {rigid, 0, small.radius});
    EXPECT_NEAR(one.normal / both.normal, 2, 1e-14);
    EXPECT_NEAR(one.shear / both.shear, 2, 1e-14);
}

TEST(Hertz, ForceIsTheDerivativeOfEnergyAndTangentThatOfForce) {
    const HertzStiffness h = hertzStiffness(small, large);
    PairConstants c;
    c.options.hertz = h;
    const double u = 1e-5, d = 1e-9;
    EXPECT_NEAR((hertzEnergy(h, u + d) - hertzEnergy(h, u - d)) / (2 * d) / hertzNormal(h, u), 1, 1e-8);
    EXPECT_NEAR((hertzNormal(h, u + d) - hertzNormal(h, u - d)) / (2 * d) / contactTangents(c, u).normal, 1, 1e-8);
    EXPECT_EQ(hertzNormal(h, -u), 0);
    EXPECT_EQ(contactTangents(c, -u).normal, 0);
}

TEST(Hysteresis, LoadsUnloadsAndReloads) {
    const Hysteresis h = hysteresis(10, 4);
    EXPECT_DOUBLE_EQ(hystereticNormal(h, 0.2, 0.2), 2);    // first loading along kn
    EXPECT_DOUBLE_EQ(hystereticNormal(h, 0.19, 0.2), 1.6); // unloading along 4 kn
    EXPECT_NEAR(hystereticNormal(h, 0.15, 0.2), 0, 1e-15); // open at (1 - 1/4) of the largest overlap
    EXPECT_EQ(hystereticNormal(h, 0.1, 0.2), 0);
    EXPECT_DOUBLE_EQ(hystereticNormal(h, 0.3, 0.3), 3); // back on the line of first loading
}

TEST(Hysteresis, RatioOneIsTheLinearContact) {
    for (double overlap : {-0.1, 0.0, 0.123456789, 0.2})
        EXPECT_EQ(hystereticNormal(hysteresis(7, 1), overlap, 0.3), contactNormal(7, overlap));
}

TEST(Hysteresis, ACycleLosesTheAreaBetweenItsLines) {
    PairConstants c;
    c.kn = 10;
    c.options.unloadingRatio = 4;
    PairState s;
    double lost = 0;
    const auto go = [&](double overlap) {
        lost += stepPair(s, c, {}, {overlap, Vec3::Zero(), Vec3::Zero(), {1, 0, 0}}).sliding;
    };
    for (int i = 1; i <= 100; ++i)
        go(0.002 * i);
    for (int i = 1; i <= 25; ++i)
        go(0.2 - 0.002 * i);
    EXPECT_NEAR(lost, 0.5 * 2 * 0.2 - 0.5 * 2 * 0.05, 1e-14); // triangles of loading and of unloading
    EXPECT_NEAR(s.contactNormal, 0, 1e-13);
}

TEST(Rolling, StiffnessAndLimitAsInCohFrict) {
    const RollingResistance r = rollingResistance({0.5, 0.1, 2}, {1.5, 0.3, 1});
    EXPECT_DOUBLE_EQ(r.stiffness, 2 * 0.5 * 1.5 / 2 * 2 * 1);
    EXPECT_DOUBLE_EQ(r.arm, 0.2);
    EXPECT_EQ(rollingResistance({0, 0.1, 2}, {1.5, 0.3, 1}).stiffness, 0);
    EXPECT_EQ(rollingResistance({0, 0, 1}, {0, 0, 1}).stiffness, 0);
}

TEST(Rolling, MomentGrowsUpToItsLimitAndStays) {
    PairConstants c;
    c.kn = 10;
    c.ks = 8;
    c.options.rolling = {0.5, 0.03};
    PairState s;
    for (int i = 0; i < 100; ++i) {
        stepPair(s, c, {}, {0.1, Vec3::Zero(), {1e-3, 0, 1e-3}, {1, 0, 0}});
        EXPECT_NEAR(s.rolling.z(), std::min(0.03, (i + 1) * 8 * 0.5 * 1e-3), 1e-15);
        EXPECT_EQ(s.rolling.x(), 0); // no resistance to twist
    }
    stepPair(s, c, {}, {-0.1, Vec3::Zero(), Vec3::Zero(), {1, 0, 0}});
    EXPECT_EQ(s.rolling.norm(), 0);
}

TEST(Rolling, BondedPairsDoNotResistBesideTheirBond) {
    PairConstants c;
    c.kind = BondKind::Parallel;
    c.kn = c.ks = 10;
    c.section = roundSection(1);
    c.bondRadius = 1;
    c.options.rolling = {0.5, 0.03};
    PairState s;
    s.bonded = true;
    const PairMotion rolls{0.1, Vec3::Zero(), {0, 0, 1e-3}, {1, 0, 0}};
    stepPair(s, c, {1e9, 1e9, 0}, rolls);
    EXPECT_EQ(s.rolling.norm(), 0);
    EXPECT_NE(stepPair(s, c, {0, 0, 0}, rolls).breakage, Breakage::None);
    EXPECT_DOUBLE_EQ(s.rolling.z(), 10 * 0.5 * 1e-3);
}

TEST(ContactOptions, EnergyOfEachStepCloses) {
    // Along the normal a Hertz contact is conservative, and the error of the trapezoid falls with the square of the
    // step.
    for (const auto& [hertz, tolerance] : {std::pair{false, 1e-13}, std::pair{true, 1e-6}}) {
        const PairConstants c = constants(hertz);
        Drive drive;
        drive.run(c, 20000);
        EXPECT_GT(drive.count, 100);
        const double left = pairEnergy(drive.state, c);
        EXPECT_NEAR(drive.lost + left, drive.work, tolerance * drive.work) << hertz;
    }
}

TEST(ContactOptions, SplittingTheStepChangesLittle) {
    for (bool hertz : {false, true}) {
        const PairConstants c = constants(hertz);
        Drive coarse, fine;
        coarse.run(c, 2000);
        fine.run(c, 20000);
        EXPECT_NEAR(coarse.lost / fine.lost, 1, 0.01);
        // The largest overlap is that of a step: it misses the true one by the square of the step.
        EXPECT_NEAR(coarse.state.contactNormal / fine.state.contactNormal, 1, 1e-6);
    }
}

TEST(ContactOptions, OffIsTheLinearContactBitByBit) {
    PairConstants plain = constants(false);
    plain.options = {};
    PairState one, two;
    for (int i = 0; i < 1000; ++i) {
        const PairMotion m{Drive::overlap(0.01 * i), {0, 1e-4 * std::cos(0.1 * i), 0}, Vec3::Zero(), {1, 0, 0}};
        PairEvents events;
        stepPair(one, plain, {}, m);
        carryAlong(two, plain, m.normal, m.roll);
        stepContactWithOptions(two, plain, m, events);
        two.overlap = m.overlap;
        EXPECT_EQ(one.contactNormal, two.contactNormal);
        EXPECT_EQ(one.contactShear, two.contactShear);
    }
}

TEST(ContactOptions, BondedPairsKeepTheirBondBesideAHertzContact) {
    PairConstants c = constants(true);
    c.kind = BondKind::Parallel;
    c.section = roundSection(1);
    c.bondRadius = 1;
    c.bond = bondStiffness(30, 20, c.section);
    PairState s;
    s.bonded = true;
    const BondStrength strong{1e9, 1e9, 0};
    stepPair(s, c, strong, {0.04, Vec3::Zero(), Vec3::Zero(), {1, 0, 0}});
    EXPECT_DOUBLE_EQ(s.contactNormal + s.load.normal, 2e3 * 0.04 * 0.2 + 30 * 0.04);
    stepPair(s, c, strong, {-0.04, Vec3::Zero(), Vec3::Zero(), {1, 0, 0}});
    EXPECT_DOUBLE_EQ(s.contactNormal + s.load.normal, -30 * 0.04);
}
