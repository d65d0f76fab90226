#pragma once

#include <core/Scene.hpp>

namespace yade {

/// Kinetic energy of all bodies that can move, translation and rotation [J].
Real kineticEnergy(const Scene&);

/// Elastic energy of all contacts and bonds with BondPhys [J].
Real elasticEnergy(const Scene&);

/// Energy that NewtonIntegrator's damping has taken out [J]; 0 unless O.trackEnergy is on.
Real dampedEnergy(const Scene&);

}
