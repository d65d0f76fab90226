// Scatter of bond strength: factors on the strengths of a bond, as functions of a uniform number u in (0, 1).
#pragma once

#include <cmath>

#include <boost/math/distributions/normal.hpp>

namespace grus::physics {

enum class Scatter { None, Normal, Weibull };

/// Normal factor with mean 1 and coefficient of variation `cv` before truncation to (0, 2), which keeps the mean.
inline double normalFactor(double u, double cv) {
    if (cv <= 0)
        return 1;
    const boost::math::normal standard;
    const double tail = boost::math::cdf(standard, -1 / cv);
    return 1 + cv * boost::math::quantile(standard, tail + u * (1 - 2 * tail));
}

/// Weibull factor with modulus `m` and characteristic value 1 (37 % of the factors are larger).
inline double weibullFactor(double u, double m) { return std::pow(-std::log1p(-u), 1 / m); }

/// Weakest-link size effect (Weibull 1951): strength of a grain of diameter `d` against one of diameter `d0`.
inline double sizeFactor(double d, double d0, double m, int dimension) { return std::pow(d / d0, -dimension / m); }

/// Factor of the kind asked for; `parameter` is the coefficient of variation or the modulus.
inline double scatterFactor(Scatter kind, double parameter, double u) {
    switch (kind) {
    case Scatter::None:
        return 1;
    case Scatter::Normal:
        return normalFactor(u, parameter);
    case Scatter::Weibull:
        return weibullFactor(u, parameter);
    }
    return 1;
}

}
