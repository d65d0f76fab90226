#pragma once

#include <core/Scene.hpp>

namespace yade {

/// Mean resultant force on the bodies that can move over the mean force of the contacts [-]; 0 when nothing touches.
/// Forces must be synced. Gravity, which the integrator adds, is not among them.
Real unbalancedForce(Scene&);

}
