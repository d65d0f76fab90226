#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <physics/transport.hpp>

using namespace grus::physics;

TEST(Transport, TurnIsTheSmallestRotation) {
    const Vec3 from = Vec3(1, 2, -1).normalized(), to = Vec3(-0.3, 1, 2).normalized();
    const Vec3 v = across({0.4, -0.1, 0.8}, from);
    const Vec3 expected = Eigen::Quaterniond::FromTwoVectors(from, to) * v;
    EXPECT_TRUE(turn(v, from, to).isApprox(expected, 1e-14));
}

TEST(Transport, SpinIsRodriguesRotation) {
    const Vec3 n = Vec3(1, -1, 0.5).normalized(), v = across({0.4, -0.1, 0.8}, n);
    EXPECT_TRUE(spin(v, n, 0.7).isApprox(Eigen::AngleAxisd(0.7, n) * v, 1e-14));
}

TEST(Transport, KeepsLengthOverManyTurns) {
    Vec3 n(1, 0, 0), v(0, 1, 0);
    for (int i = 0; i < 100000; ++i) {
        const Vec3 next = (Eigen::AngleAxisd(0.01, Vec3(0.2, 0.1, 1).normalized()) * n).normalized();
        v = transport(v, n, next, 0.003);
        n = next;
    }
    EXPECT_NEAR(v.norm(), 1, 1e-9);
    EXPECT_NEAR(v.dot(n), 0, 1e-15);
}

TEST(Transport, NothingMovesWhenTheNormalStands) {
    const Vec3 n(0, 0, 1), v(0.3, -0.4, 0);
    EXPECT_TRUE(transport(v, n, n, 0).isApprox(v, 1e-16));
}

TEST(Transport, VectorStaysWhenTheNormalIsReversed) {
    const Vec3 n(0, -1, 0), v(0.3, 0, -0.4);
    EXPECT_TRUE(transport(v, n, -n, 0).isApprox(v, 1e-16));
}
