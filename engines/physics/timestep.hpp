// Largest stable time step of central differences (leapfrog) for rigid bodies joined by springs.
//
// A spring between bodies i and j stores k |D_i q_i + D_j q_j|^2 / 2 <= k (|D_i q_i|^2 + |D_j q_j|^2), so the stiffness
// matrix of the assembly is bounded by twice its diagonal 6 x 6 blocks. With lambda_i the largest eigenvalue of
// M_i^-1 K_i, the highest frequency obeys omega^2 <= 2 max lambda_i and dt = 2/omega is safe. The bound is reached by a
// pair of equal bodies and by a long chain. A spring to a body that cannot move counts once, not twice.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include <physics/vector.hpp>

namespace grus::physics {

/// Springs of one contact: along and across the normal [N/m], bending and twist [N m/rad].
struct ContactSprings {
    double normal = 0, shear = 0, bending = 0, twist = 0;
};

/// Adds to `k` (order ux uy uz rx ry rz) the springs at `arm` [m] from the body's centre. `share` is 2 when the other
/// body can move, 1 when it cannot.
inline void addSprings(Mat6& k, const ContactSprings& springs, const Vec3& arm, const Vec3& normal, double share) {
    const Mat3 along = normal * normal.transpose();
    const Mat3 across = Mat3::Identity() - along;
    const Mat3 force = share * (springs.normal * along + springs.shear * across);
    const Mat3 lever = -skew(arm); // velocity at the contact = u + lever * rotation rate
    k.topLeftCorner<3, 3>() += force;
    k.topRightCorner<3, 3>() += force * lever;
    k.bottomLeftCorner<3, 3>() += lever.transpose() * force;
    k.bottomRightCorner<3, 3>() +=
        lever.transpose() * force * lever + share * (springs.bending * across + springs.twist * along);
}

/// Critical step [s] of a body with stiffness `k`, `mass` [kg], inertia tensor [kg m2] in the same frame;
/// `blocked` has bit 0..5 set for each degree of freedom that cannot move. Infinite for a body without springs.
inline double criticalStep(const Mat6& k, double mass, const Mat3& inertia, unsigned blocked = 0) {
    Mat6 m = Mat6::Zero();
    m.topLeftCorner<3, 3>() = mass * Mat3::Identity();
    m.bottomRightCorner<3, 3>() = inertia;
    Mat6 free = k;
    for (int i = 0; i < 6; ++i)
        if (blocked & (1u << i)) {
            free.row(i).setZero();
            free.col(i).setZero();
            m.row(i).setZero();
            m.col(i).setZero();
            m(i, i) = 1;
        }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Mat6> solver(free, m, Eigen::EigenvaluesOnly);
    const double largest = solver.eigenvalues().maxCoeff();
    return largest > 0 ? 2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

}
