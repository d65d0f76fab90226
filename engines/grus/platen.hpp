#pragma once

#include <core/Scene.hpp>
#include <core/State.hpp>

namespace yade {

/// State of the wall `id`; throws std::runtime_error in the name of `engine` when there is no such body.
State& platen(int id, Scene& scene, const char* engine);

/// Sum of the normal stiffnesses of all contacts of the wall `id` [N/m], of unloading where that is larger.
Real contactStiffness(int id, Scene& scene);

}
