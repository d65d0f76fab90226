#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <physics/servo.hpp>

using namespace grus::physics;

namespace {

constexpr double slow = 0.01, fast = 0.1, growth = 1.1;
constexpr QuasiStatic limits{1e-3, 1e-2, 0.02};
constexpr Calm calm{{1e-4, 1e-3, 1e-3}, 0};

double next(double now, const Calm& seen) { return nextSpeedLimit(now, slow, fast, growth, seen, limits); }

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

TEST(Servo, ClosesAtTheCapWithoutContact) {
    EXPECT_EQ(servoSpeed(1, 0, 1e-7, 0.05, slow), slow);
    EXPECT_EQ(servoSpeed(-1, 0, 1e-7, 0.05, slow), -slow);
    EXPECT_EQ(servoSpeed(0, 0, 1e-7, 0.05, slow), 0);
}

TEST(Servo, NeverPassesTheCapOverJumpsOfTheStiffness) {
    std::mt19937 draw(1);
    std::uniform_real_distribution<double> exponent(-6, 14), sign(-1, 1);
    for (int i = 0; i < 10000; ++i) {
        const double error = sign(draw) * std::pow(10, exponent(draw)), stiffness = std::pow(10, exponent(draw));
        const double speed = servoSpeed(error, stiffness, 1e-7, 0.05, slow);
        EXPECT_LE(std::abs(speed), slow);
        EXPECT_GE(speed * error, 0);
    }
}

TEST(Servo, SpeedLimitGrowsUpToTheFastOneWhileTheTestIsQuasiStatic) {
    EXPECT_DOUBLE_EQ(next(slow, calm), growth * slow);
    EXPECT_DOUBLE_EQ(next(0.099, calm), fast);
}

TEST(Servo, SpeedLimitFallsBackAtOnceWhereBondsBreak) {
    EXPECT_EQ(next(fast, {calm.found, 1}), slow);
    EXPECT_EQ(next(slow, {calm.found, 1}), slow);
}

TEST(Servo, SpeedLimitFallsByAStepBeyondEachLimitButNotBelowTheSlowOne) {
    for (const QuasiStatic& beyond : {QuasiStatic{2e-3, 0, 0}, QuasiStatic{0, 2e-2, 0}, QuasiStatic{0, 0, 0.03}}) {
        EXPECT_DOUBLE_EQ(next(0.05, {beyond, 0}), 0.05 / growth);
        EXPECT_DOUBLE_EQ(next(slow, {beyond, 0}), slow);
    }
}

TEST(Servo, InertialNumberIsThatOfGDRMiDi) {
    EXPECT_DOUBLE_EQ(inertialNumber(-2, 0.01, 2500, 1e4), 2 * 0.01 * 0.5);
    EXPECT_EQ(inertialNumber(1, 0.01, 2500, 0), 0);
}
