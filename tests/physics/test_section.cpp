#include <gtest/gtest.h>

#include <cmath>

#include <physics/bond.hpp>
#include <physics/section.hpp>
#include <physics/stiffness.hpp>

using namespace grus::physics;

namespace {

/// Integrates y^2 over a section of half-height r and width w(y) with the midpoint rule.
template <class Width> double secondMoment(double r, Width width) {
    const int steps = 200000;
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        const double y = -r + (i + 0.5) * 2 * r / steps;
        sum += y * y * width(y) * 2 * r / steps;
    }
    return sum;
}

}

TEST(Section, RoundAgreesWithIntegral) {
    const double r = 0.7;
    const Section s = roundSection(r);
    EXPECT_NEAR(s.area, M_PI * r * r, 1e-15);
    EXPECT_NEAR(s.inertia, secondMoment(r, [r](double y) { return 2 * std::sqrt(r * r - y * y); }), 1e-8);
    EXPECT_DOUBLE_EQ(s.polar, 2 * s.inertia);
}

TEST(Section, StripAgreesWithIntegralAndDoesNotTwist) {
    const double r = 0.7, t = 0.3;
    const Section s = stripSection(r, t);
    EXPECT_DOUBLE_EQ(s.area, 2 * r * t);
    EXPECT_NEAR(s.inertia, secondMoment(r, [t](double) { return t; }), 1e-10);
    EXPECT_EQ(s.polar, 0);
}

TEST(Section, ThicknessChoosesTheShape) {
    EXPECT_EQ(bondSection(0.5, 0).area, roundSection(0.5).area);
    EXPECT_EQ(bondSection(0.5, 2).area, stripSection(0.5, 2).area);
}

TEST(Stiffness, ThreeWaysGiveTheSameBond) {
    const double area = 0.02, length = 0.5, total = 3e9;
    EXPECT_DOUBLE_EQ(sectionStiffness(StiffnessKind::Total, total, area, length), total);
    EXPECT_DOUBLE_EQ(sectionStiffness(StiffnessKind::PerArea, total / area, area, length), total);
    EXPECT_DOUBLE_EQ(sectionStiffness(StiffnessKind::Modulus, total / area * length, area, length), total);
}

TEST(Stiffness, ModulusGivesTheStretchOfABar) {
    // A bar of modulus E, section A and length L stretches by F L / (E A).
    const double E = 5e9, A = 1e-4, L = 0.01, F = 12;
    EXPECT_NEAR(F / sectionStiffness(StiffnessKind::Modulus, E, A, L), F * L / (E * A), 1e-20);
}

TEST(Stiffness, SeriesOfEqualsIsHalfAndOfNothingIsNothing) {
    EXPECT_DOUBLE_EQ(inSeries(4, 4), 2);
    EXPECT_DOUBLE_EQ(inSeries(2, 6), 1.5);
    EXPECT_EQ(inSeries(0, 0), 0);
    EXPECT_EQ(inSeries(0, 5), 0);
}

TEST(Stiffness, BendingAndTwistOfARoundBond) {
    const double r = 0.4, kn = 7, ks = 5;
    const BondStiffness k = bondStiffness(kn, ks, roundSection(r));
    EXPECT_NEAR(k.bending, kn * r * r / 4, 1e-15);
    EXPECT_NEAR(k.twist, ks * r * r / 2, 1e-15);
}
