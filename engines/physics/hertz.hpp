// Contact of two elastic spheres: Hertz (1882) along the normal, Mindlin (1949) across it, without slip inside the
// contact area. The stiffness across is that of the present overlap and acts on each increment of slip.
#pragma once

#include <algorithm>
#include <cmath>

namespace grus::physics {

/// A sphere of `radius` [m] with Young's modulus `young` [Pa] (inf: rigid) and Poisson's ratio `poisson` [-].
struct ElasticSphere {
    double young, poisson, radius;
};

/// Stiffnesses over the root of the overlap: along the normal the secant one, across it that of an increment.
struct HertzStiffness {
    double normal = 0; ///< 4/3 E* root(R*) [N/m^(3/2)]; 0: no Hertz contact
    double shear = 0;  ///< 8 G* root(R*) [N/m^(3/2)]
};

inline HertzStiffness hertzStiffness(const ElasticSphere& a, const ElasticSphere& b) {
    const auto extension = [](const ElasticSphere& s) { return (1 - s.poisson * s.poisson) / s.young; };
    const auto shearing = [](const ElasticSphere& s) { return 2 * (2 - s.poisson) * (1 + s.poisson) / s.young; };
    const double root = std::sqrt(a.radius * b.radius / (a.radius + b.radius));
    return {4.0 / 3 * root / (extension(a) + extension(b)), 8 * root / (shearing(a) + shearing(b))};
}

/// Root [m^(1/2)] of an overlap [m]; 0 of a gap.
inline double rootOverlap(double overlap) { return std::sqrt(std::max(overlap, 0.0)); }

/// Normal force [N] at `overlap` [m], never tension.
inline double hertzNormal(const HertzStiffness& h, double overlap) {
    return h.normal * std::max(overlap, 0.0) * rootOverlap(overlap);
}

/// Elastic energy [J] of the normal force.
inline double hertzEnergy(const HertzStiffness& h, double overlap) {
    return 0.4 * hertzNormal(h, overlap) * std::max(overlap, 0.0);
}

}
