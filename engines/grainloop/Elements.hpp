// Discs or spheres, and the rigid bodies that carry them.
#pragma once

#include <cstdint>
#include <vector>

#include <grainloop/Vectors.hpp>

namespace grus::grainloop {

/// Elements in the order of their bodies: 92 bytes each, and 64 for forces a thread.
struct Elements {
    Vectors position, velocity, rate; ///< [m], [m/s], [rad/s]
    Array<double> radius;             ///< [m]
    Array<int> body;                  ///< the body that carries it
    Array<int> kind;                  ///< number of the pair of material and radius
    Array<int> mask;                  ///< two elements can touch when their masks share a bit

    std::size_t size() const { return radius.size(); }
    void resize(std::size_t n);
};

/// Rigid bodies, each of one or more elements; those whose rotation needs the moments of all axes come last.
struct Bodies {
    Vectors position, velocity, rate, momentum; ///< of the centre of mass [m], [m/s], [rad/s], [N m s]
    Array<double> qw, qx, qy, qz;               ///< orientation
    Array<double> mass;                         ///< [kg]
    Vectors inertia;                            ///< along the body's axes [kg m2]
    Vectors free, freeTurn;                     ///< 1 for a degree of freedom that can move, 0 for a blocked one
    Array<double> damped;                       ///< 1 if damping acts, else 0
    Array<int> begin;                           ///< its elements: begin[b] up to begin[b + 1]
    Vectors place;                              ///< of each element, in the axes of its body [m]
    Array<double> reach;                        ///< distance of the farthest member from the centre [m]
    int aspherical = 0;                         ///< first body with three different moments

    std::size_t size() const { return mass.size(); }
    void resize(std::size_t n);
};

}
