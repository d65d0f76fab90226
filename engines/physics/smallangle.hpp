// Sine and cosine of the small angles by which bodies turn in a step: exact to round-off below `smallAngle`, and
// without a branch, so that loops over them vectorise.
#pragma once

namespace grus::physics {

constexpr double smallAngle = 0.1; ///< [rad]

/// Sine over angle.
inline double smallSinc(double x) {
    const double y = x * x;
    return 1 + y * (-1.0 / 6 + y * (1.0 / 120 + y * (-1.0 / 5040 + y * (1.0 / 362880))));
}

inline double smallSine(double x) { return x * smallSinc(x); }

inline double smallCosine(double x) {
    const double y = x * x;
    return 1 + y * (-0.5 + y * (1.0 / 24 + y * (-1.0 / 720 + y * (1.0 / 40320 - y * (1.0 / 3628800)))));
}

}
