#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <physics/random.hpp>
#include <physics/strength.hpp>

using namespace grus::physics;

namespace {

std::vector<double> draws(int n, std::uint64_t seed) {
    std::vector<double> u;
    u.reserve(n);
    for (int i = 0; i < n; ++i)
        u.push_back(uniform(seed, Draw::BondStrength, i, i + 1));
    return u;
}

}

TEST(Random, DependsOnSeedPurposeAndIdsOnly) {
    EXPECT_EQ(uniform(7, Draw::BondStrength, 3, 9), uniform(7, Draw::BondStrength, 3, 9));
    const std::set<double> different{uniform(7, Draw::BondStrength, 3, 9),   uniform(8, Draw::BondStrength, 3, 9),
                                     uniform(7, Draw::GrainStrength, 3, 9),  uniform(7, Draw::BondStrength, 4, 9),
                                     uniform(7, Draw::BondStrength, 3, 10),  uniform(7, Draw::BondStrength, 9, 3),
                                     uniform(7, Draw::BondStrength, 3, 9, 1)};
    EXPECT_EQ(different.size(), 7u);
}

TEST(Random, StaysTheSameOnEveryMachine) {
    EXPECT_EQ(mix(0), 0xe220a8397b1dcdafULL); // first output of splitmix64 with seed 0, Vigna's reference figures
    EXPECT_EQ(mix(0x9e3779b97f4a7c15ULL), 0x6e789e6aa1b965f4ULL);
}

TEST(Random, IsUniform) {
    // Kolmogorov-Smirnov: sqrt(n) D stays below 1.63 with probability 0.99.
    for (std::uint64_t seed : {1, 2, 12345}) {
        auto u = draws(20000, seed);
        std::sort(u.begin(), u.end());
        double distance = 0;
        for (std::size_t i = 0; i < u.size(); ++i)
            distance =
                std::max({distance, std::abs(u[i] - double(i) / u.size()), std::abs(u[i] - double(i + 1) / u.size())});
        EXPECT_LT(distance * std::sqrt(u.size()), 1.63);
        EXPECT_GT(u.front(), 0);
        EXPECT_LT(u.back(), 1);
    }
}

TEST(Strength, NormalFactorHasMeanOneAndItsDeviation) {
    double sum = 0, squares = 0;
    auto u = draws(200000, 5);
    for (double x : u) {
        const double f = normalFactor(x, 0.2);
        sum += f;
        squares += f * f;
    }
    const double mean = sum / u.size();
    EXPECT_NEAR(mean, 1, 4 * 0.2 / std::sqrt(u.size()));
    EXPECT_NEAR(std::sqrt(squares / u.size() - mean * mean), 0.2, 2e-3);
}

TEST(Strength, NormalFactorIsTruncatedSymmetrically) {
    EXPECT_GT(normalFactor(1e-15, 0.9), 0);
    EXPECT_LT(normalFactor(1 - 1e-15, 0.9), 2);
    EXPECT_NEAR(normalFactor(0.5, 0.9), 1, 1e-14);
    EXPECT_NEAR(normalFactor(0.2, 0.9) + normalFactor(0.8, 0.9), 2, 1e-14);
    EXPECT_EQ(normalFactor(0.3, 0), 1);
}

TEST(Strength, WeibullFactorIsTheInverseOfItsDistribution) {
    for (double m : {0.8, 3.0, 12.0})
        for (double u : {1e-6, 0.1, 0.5, 0.99})
            EXPECT_NEAR(1 - std::exp(-std::pow(weibullFactor(u, m), m)), u, 1e-12);
    EXPECT_NEAR(weibullFactor(1 - std::exp(-1), 4), 1, 1e-12); // 37 % survive the characteristic strength
}

TEST(Strength, SizeEffectHasTheWeibullSlope) {
    EXPECT_EQ(sizeFactor(3, 3, 5, 3), 1);
    EXPECT_NEAR(std::log(sizeFactor(8, 2, 5, 3)) / std::log(4), -3.0 / 5, 1e-14);
    EXPECT_NEAR(std::log(sizeFactor(8, 2, 5, 2)) / std::log(4), -2.0 / 5, 1e-14);
}

TEST(Strength, NoScatterIsExactlyOne) { EXPECT_EQ(scatterFactor(Scatter::None, 3, 0.123), 1); }
