#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include <physics/timestep.hpp>

using namespace grus::physics;

namespace {

struct Sphere {
    Vec3 position;
    double radius, mass;
    double inertia() const { return 0.4 * mass * radius * radius; }
};

struct Link {
    int i, j;
};

/// The whole assembly's stiffness matrix, written out from the deformation of each link, and its exact critical step.
double exactStep(const std::vector<Sphere>& bodies, const std::vector<Link>& links, const ContactSprings& k) {
    const int n = 6 * static_cast<int>(bodies.size());
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(n, n), mass = Eigen::MatrixXd::Zero(n, n);
    for (const Link& link : links) {
        const Vec3 normal = (bodies[link.j].position - bodies[link.i].position).normalized();
        const Vec3 point = bodies[link.i].position + bodies[link.i].radius * normal;
        Eigen::MatrixXd motion = Eigen::MatrixXd::Zero(6, n); // slip and rotation of i against j
        for (auto [body, sign] : {std::pair{link.i, 1.0}, std::pair{link.j, -1.0}}) {
            const Vec3 arm = point - bodies[body].position;
            for (int axis = 0; axis < 3; ++axis) {
                const Vec3 e = Vec3::Unit(axis);
                motion.block<3, 1>(0, 6 * body + axis) = sign * e;
                motion.block<3, 1>(0, 6 * body + 3 + axis) = sign * e.cross(arm);
                motion.block<3, 1>(3, 6 * body + 3 + axis) = sign * e;
            }
        }
        const Mat3 along = normal * normal.transpose(), over = Mat3::Identity() - along;
        Mat6 local = Mat6::Zero();
        local.topLeftCorner<3, 3>() = k.normal * along + k.shear * over;
        local.bottomRightCorner<3, 3>() = k.twist * along + k.bending * over;
        stiffness += motion.transpose() * local * motion;
    }
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (int axis = 0; axis < 3; ++axis) {
            mass(6 * b + axis, 6 * b + axis) = bodies[b].mass;
            mass(6 * b + 3 + axis, 6 * b + 3 + axis) = bodies[b].inertia();
        }
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass, Eigen::EigenvaluesOnly);
    return 2 / std::sqrt(solver.eigenvalues().maxCoeff());
}

double boundedStep(const std::vector<Sphere>& bodies, const std::vector<Link>& links, const ContactSprings& k) {
    std::vector<Mat6> stiffness(bodies.size(), Mat6::Zero());
    for (const Link& link : links) {
        const Vec3 normal = (bodies[link.j].position - bodies[link.i].position).normalized();
        const Vec3 point = bodies[link.i].position + bodies[link.i].radius * normal;
        for (int body : {link.i, link.j})
            addSprings(stiffness[body], k, point - bodies[body].position, normal, 2);
    }
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < bodies.size(); ++b)
        step = std::min(step, criticalStep(stiffness[b], bodies[b].mass, bodies[b].inertia() * Mat3::Identity()));
    return step;
}

std::vector<Link> touching(const std::vector<Sphere>& bodies) {
    std::vector<Link> links;
    for (int i = 0; i < static_cast<int>(bodies.size()); ++i)
        for (int j = i + 1; j < static_cast<int>(bodies.size()); ++j)
            if ((bodies[i].position - bodies[j].position).norm() < 1.001 * (bodies[i].radius + bodies[j].radius))
                links.push_back({i, j});
    return links;
}

std::vector<Sphere> closePacked(int n) {
    std::vector<Sphere> bodies;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z)
                bodies.push_back(
                    {Vec3(2 * x + (y + z) % 2, std::sqrt(3) * (y + (z % 2) / 3.0), 2 * std::sqrt(6) / 3 * z), 1, 1});
    return bodies;
}

const ContactSprings axial{5, 0, 0, 0}, full{5, 3, 1.2, 0.8};

}

TEST(CriticalStep, LargestEigenvalueIsEigens) {
    for (unsigned seed = 1; seed < 50; ++seed) {
        std::srand(seed);
        const Mat6 random = Mat6::Random();
        const Mat6 symmetric = random * random.transpose() * std::pow(10.0, static_cast<double>(seed % 20) - 10);
        const Eigen::SelfAdjointEigenSolver<Mat6> solver(symmetric);
        EXPECT_NEAR(largestEigenvalue(symmetric) / solver.eigenvalues().maxCoeff(), 1, 1e-13);
    }
}

TEST(CriticalStep, PairOfEqualBodiesIsExact) {
    const std::vector<Sphere> pair{{Vec3(0, 0, 0), 1, 2}, {Vec3(2, 0, 0), 1, 2}};
    EXPECT_NEAR(boundedStep(pair, {{0, 1}}, axial), 2 / std::sqrt(2 * 5 / 2.0), 1e-12);
    EXPECT_NEAR(boundedStep(pair, {{0, 1}}, axial), exactStep(pair, {{0, 1}}, axial), 1e-12);
    const ContactSprings sheared{5, 3, 0, 0};
    EXPECT_NEAR(boundedStep(pair, {{0, 1}}, sheared), exactStep(pair, {{0, 1}}, sheared), 1e-12);
    // With a bending spring too, shear and bending cannot both be at their worst: the bound is safe, not exact.
    EXPECT_LT(boundedStep(pair, {{0, 1}}, full), exactStep(pair, {{0, 1}}, full));
    EXPECT_GT(boundedStep(pair, {{0, 1}}, full), 0.9 * exactStep(pair, {{0, 1}}, full));
}

TEST(CriticalStep, LongChainIsReachedFromBelow) {
    std::vector<Sphere> chain;
    chain.reserve(60);
    for (int i = 0; i < 60; ++i)
        chain.push_back({Vec3(2.0 * i, 0, 0), 1, 1});
    const double bound = boundedStep(chain, touching(chain), axial), exact = exactStep(chain, touching(chain), axial);
    EXPECT_NEAR(bound, 2 / std::sqrt(4 * 5.0), 1e-12); // omega^2 = 4 k / m of the endless chain
    EXPECT_LE(bound, exact);
    EXPECT_NEAR(bound, exact, 1e-3 * exact);
}

TEST(CriticalStep, CloseBlockIsSafeAndNotWasteful) {
    const auto block = closePacked(4);
    for (const auto& springs : {axial, full}) {
        const double bound = boundedStep(block, touching(block), springs),
                     exact = exactStep(block, touching(block), springs);
        EXPECT_LE(bound, exact * (1 + 1e-12));
        EXPECT_GT(bound, 0.6 * exact);
    }
}

TEST(CriticalStep, UnequalPairIsSafe) {
    const std::vector<Sphere> pair{{Vec3(0, 0, 0), 1, 2}, {Vec3(1.5, 0, 0), 0.5, 0.2}};
    EXPECT_LE(boundedStep(pair, {{0, 1}}, full), exactStep(pair, {{0, 1}}, full));
}

TEST(CriticalStep, SpringToAFixedBodyCountsOnce) {
    Mat6 k = Mat6::Zero();
    addSprings(k, axial, Vec3(1, 0, 0), Vec3(1, 0, 0), 1);
    EXPECT_NEAR(criticalStep(k, 2, Mat3::Identity()), 2 / std::sqrt(5 / 2.0), 1e-12);
}

TEST(CriticalStep, BlockedDirectionsDoNotCount) {
    Mat6 k = Mat6::Zero();
    addSprings(k, axial, Vec3(1, 0, 0), Vec3(1, 0, 0), 1);
    EXPECT_TRUE(std::isinf(criticalStep(k, 2, Mat3::Identity(), 1u)));
    EXPECT_FALSE(std::isinf(criticalStep(k, 2, Mat3::Identity(), 2u)));
}

TEST(CriticalStep, FreeBodyHasNoLimit) { EXPECT_TRUE(std::isinf(criticalStep(Mat6::Zero(), 1, Mat3::Identity()))); }
