#include <gtest/gtest.h>

#include <cmath>

#include <physics/contact.hpp>
#include <physics/servo.hpp>

using namespace grus::physics;

TEST(Contact, NoTension) {
    EXPECT_DOUBLE_EQ(contactNormal(5, 0.2), 1);
    EXPECT_EQ(contactNormal(5, -0.2), 0);
    EXPECT_EQ(contactNormal(5, 0), 0);
}

TEST(Contact, SticksBelowTheLimitAndSlidesAtIt) {
    Vec3 shear(0.6, 0.8, 0);
    EXPECT_EQ(slide(shear, 1, 2, 1), 0);
    EXPECT_TRUE(shear.isApprox(Vec3(0.6, 0.8, 0)));
    shear *= 3;
    EXPECT_GT(slide(shear, 1, 2, 1), 0);
    EXPECT_TRUE(shear.isApprox(Vec3(0.6, 0.8, 0)));
}

TEST(Contact, EnergyOfASlidingContactCloses) {
    // A contact is sheared while its limit falls to nothing: work in = energy left + work of sliding, to round-off.
    const double ks = 2;
    Vec3 shear(0, 0, 0);
    double work = 0, slid = 0;
    for (int i = 0; i < 1000; ++i) {
        const double before = shear.x();
        shear.x() += ks * 0.003;
        slid += slide(shear, std::max(0.0, 1 - 0.001 * (i + 1)), ks, before);
        work += 0.5 * (before + shear.x()) * 0.003;
    }
    EXPECT_EQ(shear.norm(), 0);
    EXPECT_NEAR(slid, work, 1e-12);
}

TEST(Contact, SpringEnergy) {
    EXPECT_DOUBLE_EQ(springEnergy(-3, 2), 2.25);
    EXPECT_EQ(springEnergy(3, 0), 0);
}

TEST(Servo, RemovesTheShareOfTheErrorAskedFor) {
    const double stiffness = 1e6, dt = 1e-5, error = 40;
    EXPECT_NEAR(servoSpeed(error, stiffness, dt, 0.25, 1e9) * dt * stiffness, 0.25 * error, 1e-12);
    EXPECT_NEAR(servoSpeed(-error, stiffness, dt, 0.25, 1e9) * dt * stiffness, -0.25 * error, 1e-12);
}

TEST(Servo, NeverPassesTheCap) {
    for (double stiffness : {0.0, 1e-9, 1.0, 1e12})
        for (double error : {-1e9, -1.0, 0.0, 1e-6, 1e9}) {
            EXPECT_LE(std::abs(servoSpeed(error, stiffness, 1e-6, 1, 0.01)), 0.01);
            EXPECT_GE(servoSpeed(error, stiffness, 1e-6, 1, 0.01) * error, 0);
        }
}
