#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Geometry>

#include "pair.hpp"

using namespace grus::physics;
using grus::physics::test::Pair;

namespace {

const Vec3 ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1);

BondLoad someLoad() {
    BondLoad load;
    load.normal = -1.3;
    load.shear = Vec3(0, 0.4, -0.7);
    load.bending = Vec3(0, 0.2, 0.1);
    load.twist = -0.6;
    return load;
}

/// A pair that moves in every way at once, with unequal balls.
Pair movingPair() {
    Pair pair;
    pair.radiusB = 0.6;
    pair.b.position = Vec3(1.1, 0.9, -0.7);
    pair.bond();
    pair.a.velocity = Vec3(0.01, -0.02, 0.005);
    pair.b.velocity = Vec3(-0.015, 0.01, 0.02);
    pair.a.rate = Vec3(0.02, 0.01, -0.03);
    pair.b.rate = Vec3(-0.01, 0.03, 0.02);
    return pair;
}

}

TEST(Bond, StiffnessTimesDisplacement) {
    const BondStiffness k{3, 2, 0.7, 0.5};
    BondLoad load;
    deform(load, k, -0.1, 0.2 * ey, 0.3 * ez + 0.4 * ex, ex);
    EXPECT_DOUBLE_EQ(load.normal, -0.3);
    EXPECT_TRUE(load.shear.isApprox(-0.4 * ey));
    EXPECT_TRUE(load.bending.isApprox(0.21 * ez));
    EXPECT_DOUBLE_EQ(load.twist, 0.2);
}

TEST(Bond, ForceIsTheDerivativeOfTheEnergy) {
    const BondStiffness k{3, 2, 0.7, 0.5};
    const double h = 1e-6;
    auto energyAfter = [&](double stretch, const Vec3& slip, const Vec3& rotation) {
        BondLoad load = someLoad();
        deform(load, k, load.normal / k.normal + stretch, slip, rotation, ex);
        return bondEnergy(load, k);
    };
    const BondLoad load = someLoad();
    const Vec3 none = Vec3::Zero();
    EXPECT_NEAR((energyAfter(h, none, none) - energyAfter(-h, none, none)) / (2 * h), load.normal, 1e-8);
    for (const Vec3& axis : {ey, ez}) {
        EXPECT_NEAR((energyAfter(0, h * axis, none) - energyAfter(0, -h * axis, none)) / (2 * h), -load.shear.dot(axis),
                    1e-8);
        EXPECT_NEAR((energyAfter(0, none, h * axis) - energyAfter(0, none, -h * axis)) / (2 * h),
                    load.bending.dot(axis), 1e-8);
    }
    EXPECT_NEAR((energyAfter(0, none, h * ex) - energyAfter(0, none, -h * ex)) / (2 * h), load.twist, 1e-8);
}

TEST(Bond, ReleasedEnergyClosesTheBalanceOfTheStep) {
    const BondStiffness k{3, 2, 0.7, 0.5};
    const BondLoad before = someLoad();
    const double stretch = before.normal / k.normal - 0.1;
    const Vec3 slip(0, 0.02, -0.03), rotation(-0.1, 0.2, 0.05);
    BondLoad trial = before;
    deform(trial, k, stretch, slip, rotation, ex);
    // Leapfrog's work in the step that breaks the bond: half the force of before, nothing of after.
    const double work = 0.5 * (before.normal * -0.1 - before.shear.dot(slip) + before.bending.dot(rotation) +
                               before.twist * rotation.x());
    EXPECT_NEAR(releasedEnergy(before, trial, k), bondEnergy(before, k) + work, 1e-15);
}

TEST(Bond, SwappedParticlesGiveOppositeForces) {
    Pair pair = movingPair(), swapped = movingPair();
    std::swap(swapped.a, swapped.b);
    std::swap(swapped.radiusA, swapped.radiusB);
    swapped.bond();
    for (int i = 0; i < 500; ++i) {
        pair.step(0.05);
        swapped.step(0.05);
    }
    EXPECT_TRUE(pair.forceOnB().isApprox(-swapped.forceOnB(), 1e-12));
    EXPECT_TRUE(pair.momentOnB().isApprox(-swapped.momentOnB(), 1e-12));
}

TEST(Bond, TurnedFrameTurnsForcesAndMoments) {
    const Mat3 turn = (Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized())).toRotationMatrix();
    Pair pair = movingPair(), turned = movingPair();
    for (auto* ball : {&turned.a, &turned.b}) {
        ball->position = turn * ball->position;
        ball->velocity = turn * ball->velocity;
        ball->rate = turn * ball->rate;
    }
    turned.bond();
    for (int i = 0; i < 500; ++i) {
        pair.step(0.05);
        turned.step(0.05);
    }
    EXPECT_TRUE(turned.forceOnB().isApprox(turn * pair.forceOnB(), 1e-12));
    EXPECT_TRUE(turned.momentOnB().isApprox(turn * pair.momentOnB(), 1e-12));
}

TEST(Bond, RigidMotionOfThePairTurnsTheLoadOnly) {
    Pair pair = movingPair();
    pair.a.position = Vec3::Zero();
    pair.b.position = Vec3(1.6, 0, 0);
    pair.bond();
    pair.load.shear = Vec3(0, 0.3, 0.1);
    pair.load.bending = Vec3(0, -0.2, 0.4);
    const BondLoad before = pair.load;
    const Vec3 rate = Vec3(0.3, -0.2, 0.5);
    pair.a.rate = pair.b.rate = rate;
    const int steps = 20000;
    const double dt = 2.0 / steps;
    for (int i = 0; i < steps; ++i) {
        // Velocities at mid-step of an exact rotation about ball a keep the pair rigid to second order.
        const Vec3 next = Eigen::AngleAxisd(rate.norm() * dt, rate.normalized()) * pair.b.position;
        pair.b.velocity = (next - pair.b.position) / dt;
        pair.a.velocity = Vec3::Zero();
        pair.step(dt);
    }
    const Mat3 turn = Eigen::AngleAxisd(rate.norm() * 2.0, rate.normalized()).toRotationMatrix();
    EXPECT_NEAR(pair.load.shear.norm(), before.shear.norm(), 1e-4);
    EXPECT_NEAR(pair.load.bending.norm(), before.bending.norm(), 1e-12);
    EXPECT_TRUE(pair.load.bending.isApprox(turn * before.bending, 1e-4));
    EXPECT_TRUE(pair.load.shear.isApprox(turn * before.shear, 1e-3));
    EXPECT_NEAR(pair.load.twist, 0, 1e-12);
}

TEST(Bond, SplitStepsConverge) {
    auto after = [](int steps) {
        Pair pair = movingPair();
        for (int i = 0; i < steps; ++i)
            pair.step(20.0 / steps);
        return pair;
    };
    const Pair fine = after(64000);
    const double e1 =
        (after(1000).forceOnB() - fine.forceOnB()).norm() + (after(1000).momentOnB() - fine.momentOnB()).norm();
    const double e2 =
        (after(2000).forceOnB() - fine.forceOnB()).norm() + (after(2000).momentOnB() - fine.momentOnB()).norm();
    EXPECT_LT(e1, 1e-3 * fine.forceOnB().norm());
    EXPECT_NEAR(e1 / e2, 2.0, 0.15); // first order or better in the step
}

TEST(Bond, RimStressOfARoundBond) {
    const double r = 0.4;
    const Section s = roundSection(r);
    const auto full = rimStress(someLoad(), s, r, 1), mean = rimStress(someLoad(), s, r, 0);
    const double bending = std::sqrt(0.05), shear = std::sqrt(0.65);
    EXPECT_NEAR(full.tension, 1.3 / (M_PI * r * r) + bending * 4 / (M_PI * r * r * r), 1e-12);
    EXPECT_NEAR(full.shear, shear / (M_PI * r * r) + 0.6 * 2 / (M_PI * r * r * r), 1e-12);
    EXPECT_NEAR(mean.tension, 1.3 / (M_PI * r * r), 1e-12);
    EXPECT_NEAR(mean.shear, shear / (M_PI * r * r), 1e-12);
    EXPECT_NEAR(full.normal, -1.3 / (M_PI * r * r), 1e-12);
}

TEST(Bond, RimStressOfAStripIgnoresTwist) {
    const double r = 0.4, t = 0.9;
    const auto stress = rimStress(someLoad(), stripSection(r, t), r, 1);
    EXPECT_NEAR(stress.tension, 1.3 / (2 * r * t) + std::sqrt(0.05) * 1.5 / (r * r * t), 1e-12);
    EXPECT_NEAR(stress.shear, std::sqrt(0.65) / (2 * r * t), 1e-12);
}

TEST(Bond, BreaksExactlyAtItsStrength) {
    const BondStrength strength{2, 3, 0};
    EXPECT_EQ(failure({std::nextafter(2.0, 0.0), 0, -2}, strength), Breakage::None);
    EXPECT_EQ(failure({2, 0, -2}, strength), Breakage::Tension);
    EXPECT_EQ(failure({0, std::nextafter(3.0, 0.0), 0}, strength), Breakage::None);
    EXPECT_EQ(failure({0, 3, 0}, strength), Breakage::Shear);
}

TEST(Bond, ModeIsTheLimitExceededMost) {
    const BondStrength strength{2, 3, 0};
    EXPECT_EQ(failure({2.2, 3.1, -2}, strength), Breakage::Tension);
    EXPECT_EQ(failure({2.1, 3.9, -2}, strength), Breakage::Shear);
}

TEST(Bond, MohrCoulombGrowsWithPressureAndEndsAtZero) {
    const BondStrength strength{10, 3, 0.5};
    EXPECT_DOUBLE_EQ(shearStrength(strength, 4), 5);
    EXPECT_DOUBLE_EQ(shearStrength(strength, -4), 1);
    EXPECT_EQ(shearStrength(strength, -100), 0);
    EXPECT_EQ(failure({-4, 4.9, 4}, strength), Breakage::None);
    EXPECT_EQ(failure({-4, 5, 4}, strength), Breakage::Shear);
}
