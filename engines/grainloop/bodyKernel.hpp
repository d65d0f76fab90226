// Moves rigid bodies and their elements by one step.
#pragma once

#include <grainloop/Elements.hpp>
#include <grainloop/Forces.hpp>

namespace grus::grainloop {

/// How bodies are moved.
struct Motion {
    double dt = 0;      ///< [s]
    double damping = 0; ///< share of the force that local damping takes [-]
    Vec3 gravity = Vec3::Zero();
};

/// What a thread finds out on the way.
struct Moved {
    double dampedEnergy = 0;  ///< taken by damping [J], as NewtonIntegrator books it
    double gravityWork = 0;   ///< minus the work of gravity [J]
    double fastestSquare = 0; ///< square of the largest speed of any point of an element's path [m2/s2]
};

/// Sums the forces on bodies begin to end - 1, integrates, and puts their elements where they now are.
Moved moveBodies(int dim, Bodies& bodies, Elements& elements, const Forces& forces, const Motion& motion, int begin,
                 int end);

/// Force and moment about the centre of body `b`.
void bodyLoad(const Bodies& bodies, const Elements& elements, const Forces& forces, int b, Vec3& force, Vec3& moment);

}
