#include <gtest/gtest.h>

#include <cmath>

#include <physics/contact.hpp>

using namespace grus::physics;

TEST(Contact, NoTension) {
    EXPECT_DOUBLE_EQ(contactNormal(5, 0.2), 1);
    EXPECT_EQ(contactNormal(5, -0.2), 0);
    EXPECT_EQ(contactNormal(5, 0), 0);
}

TEST(Contact, SticksBelowTheLimitAndSlidesAtIt) {
    const Vec3 shear(0.6, 0.8, 0);
    EXPECT_EQ(slide(shear, 1), shear);
    EXPECT_TRUE(slide(3 * shear, 1).isApprox(shear));
    EXPECT_EQ(slide(shear, 0), Vec3(0, 0, 0));
}

TEST(Contact, NothingIsLostWithoutSliding) {
    EXPECT_EQ(lostEnergy(0.3, 0.7, 0.7, 2), 0);
    EXPECT_EQ(lostEnergy(Vec3(0.1, 0.2, 0), Vec3(0.3, 0, 1), Vec3(0.3, 0, 1), 2), 0);
}

TEST(Contact, ASlowBreakLosesWhatWasStored) {
    const double k = 3, force = 0.8, step = 1e-9;
    EXPECT_NEAR(lostEnergy(force, force + step, 0, k), springEnergy(force, k), 1e-8);
}

TEST(Contact, EnergyOfASlidingContactCloses) {
    // A contact is sheared to and fro in two directions while its limit falls to nothing: work in = energy left + lost.
    const double ks = 2;
    Vec3 shear(0, 0, 0);
    double work = 0, lost = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 before = shear, slip(0.003 * std::cos(0.02 * i), 0.002 * std::sin(0.05 * i), 0);
        const Vec3 trial = before + ks * slip;
        shear = slide(trial, std::max(0.0, 1 - 0.001 * (i + 1)));
        lost += lostEnergy(before, trial, shear, ks);
        work += 0.5 * (before + shear).dot(slip);
    }
    EXPECT_EQ(shear.norm(), 0);
    EXPECT_GT(lost, 0.01);
    EXPECT_NEAR(lost, work, 1e-14);
}

TEST(Contact, SpringEnergy) {
    EXPECT_DOUBLE_EQ(springEnergy(-3, 2), 2.25);
    EXPECT_EQ(springEnergy(3, 0), 0);
}
