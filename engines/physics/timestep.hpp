// Largest stable time step of central differences (leapfrog) for rigid bodies joined by springs.
//
// A spring between bodies i and j stores k |D_i q_i + D_j q_j|^2 / 2 <= k (|D_i q_i|^2 + |D_j q_j|^2), so the stiffness
// matrix of the assembly is bounded by twice its diagonal 6 x 6 blocks. With lambda_i the largest eigenvalue of
// M_i^-1 K_i, the highest frequency obeys omega^2 <= 2 max lambda_i and dt = 2/omega is safe. The bound is reached by a
// pair of equal bodies and by a long chain. A spring to a body that cannot move counts once, not twice.
#pragma once

#include <cmath>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>

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

/// Largest eigenvalue of a symmetric matrix by cyclic Jacobi rotations (Golub & Van Loan 1996, algorithm 8.4.3).
/// Eigen's solvers do the same, at several seconds of compilation for each file that includes them.
inline double largestEigenvalue(Mat6 a) {
    for (int sweep = 0; sweep < 30; ++sweep) {
        double off = 0;
        for (int p = 0; p < 6; ++p)
            for (int q = p + 1; q < 6; ++q) {
                off += a(p, q) * a(p, q);
                if (a(p, q) == 0)
                    continue;
                const double tau = (a(q, q) - a(p, p)) / (2 * a(p, q));
                const double t = (tau >= 0 ? 1 : -1) / (std::abs(tau) + std::sqrt(1 + tau * tau));
                const double c = 1 / std::sqrt(1 + t * t), s = t * c;
                for (int k = 0; k < 6; ++k) {
                    const double kp = a(k, p), kq = a(k, q);
                    a(k, p) = c * kp - s * kq;
                    a(k, q) = s * kp + c * kq;
                }
                for (int k = 0; k < 6; ++k) {
                    const double pk = a(p, k), qk = a(q, k);
                    a(p, k) = c * pk - s * qk;
                    a(q, k) = s * pk + c * qk;
                }
            }
        if (off <= 1e-28 * a.diagonal().squaredNorm())
            break;
    }
    return a.diagonal().maxCoeff();
}

/// Critical step [s] of a body with stiffness `k`, `mass` [kg], inertia tensor [kg m2] in the same frame;
/// `blocked` has bit 0..5 set for each degree of freedom that cannot move. Infinite for a body without springs.
inline double criticalStep(const Mat6& k, double mass, const Mat3& inertia, unsigned blocked = 0) {
    Mat6 stiffness = k;
    Mat3 moments = inertia;
    for (int i = 0; i < 6; ++i)
        if (blocked & (1u << i)) {
            stiffness.row(i).setZero();
            stiffness.col(i).setZero();
            if (i < 3)
                continue;
            moments.row(i - 3).setZero();
            moments.col(i - 3).setZero();
            moments(i - 3, i - 3) = 1;
        }
    // With M = L L^T the eigenvalues of M^-1 K are those of the symmetric L^-1 K L^-T.
    const Mat3 root = moments.llt().matrixL();
    Mat6 inverse = Mat6::Zero();
    inverse.topLeftCorner<3, 3>() = Mat3::Identity() / std::sqrt(mass);
    inverse.bottomRightCorner<3, 3>() = root.inverse();
    const double largest = largestEigenvalue(inverse * stiffness * inverse.transpose());
    return largest > 0 ? 2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

}
