#include <grus/platen.hpp>

#include <stdexcept>

#include <core/Body.hpp>
#include <pkg/common/NormShearPhys.hpp>

#include <grus/BondPhys.hpp>
#include <grus/LiveScene.hpp>

namespace yade {

State& platen(int id, Scene& scene, const char* engine) {
    const bool found = id >= 0 && id < static_cast<int>(scene.bodies->size()) && Body::byId(id, &scene);
    if (!found)
        throw std::runtime_error(std::string(engine) + ": no body with id " + std::to_string(id) +
                                 "; give it the ids of the walls");
    return *Body::byId(id, &scene)->state;
}

Real contactStiffness(int id, Scene& scene) {
    if (const LiveScene* live = LiveScene::of(scene))
        return live->contactStiffness(id);
    Real sum = 0;
    for (const auto& [other, interaction] : Body::byId(id, &scene)->intrs)
        if (const auto* own = dynamic_cast<const BondPhys*>(interaction->phys.get()))
            sum += own->tangents().normal;
        else if (const auto* phys = dynamic_cast<const NormPhys*>(interaction->phys.get()))
            sum += phys->kn;
    return sum;
}

}
