#pragma once

// Numbers, vectors and tensors as YADE's double build lays them out: no Eigen alignment, no vectorisation.
#if !defined(EIGEN_DONT_ALIGN) || !defined(EIGEN_DONT_VECTORIZE)
#error "YADE's layout needs EIGEN_DONT_ALIGN and EIGEN_DONT_VECTORIZE in every file (CMake target yade_interface)"
#endif

#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <boost/shared_ptr.hpp>

namespace yade {

using boost::shared_ptr;
using std::map;
using std::string;
using std::vector;

using Real = double;

using Vector2r = Eigen::Matrix<Real, 2, 1>;
using Vector3r = Eigen::Matrix<Real, 3, 1>;
using Vector6r = Eigen::Matrix<Real, 6, 1>;
using Vector2i = Eigen::Matrix<int, 2, 1>;
using Vector3i = Eigen::Matrix<int, 3, 1>;
using Vector6i = Eigen::Matrix<int, 6, 1>;
using Matrix3r = Eigen::Matrix<Real, 3, 3>;
using Matrix6r = Eigen::Matrix<Real, 6, 6>;
using Quaternionr = Eigen::Quaternion<Real>;
using AngleAxisr = Eigen::AngleAxis<Real>;

const Real NaN = std::numeric_limits<Real>::quiet_NaN();

struct Mathr {
    static constexpr Real PI = 3.14159265358979323846;
};

/// Position and orientation of a body.
template <class Scalar> class Se3 {
public:
    Eigen::Matrix<Scalar, 3, 1> position;
    Eigen::Quaternion<Scalar> orientation;

    Se3() = default;
    Se3(const Eigen::Matrix<Scalar, 3, 1>& pos, const Eigen::Quaternion<Scalar>& ori)
        : position(pos), orientation(ori) {}
};
using Se3r = Se3<Real>;

}
