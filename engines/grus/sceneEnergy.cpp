#include <grus/sceneEnergy.hpp>

#include <core/Body.hpp>
#include <core/EnergyTracker.hpp>
#include <core/InteractionContainer.hpp>

#include <grus/BondPhys.hpp>
#include <grus/LiveScene.hpp>

namespace yade {

Real kineticEnergy(const Scene& scene) {
    if (const LiveScene* live = LiveScene::of(scene))
        return live->kineticEnergy();
    Real sum = 0;
    for (const auto& body : scene.bodies->body) {
        if (!body || body->isClumpMember() || body->state->blockedDOFs == State::DOF_ALL)
            continue;
        const State& state = *body->state;
        const Vector3r local = state.ori.conjugate() * state.angVel;
        sum += 0.5 * (state.mass * state.vel.squaredNorm() + local.dot(state.inertia.cwiseProduct(local)));
    }
    return sum;
}

Real elasticEnergy(const Scene& scene) {
    if (const LiveScene* live = LiveScene::of(scene))
        return live->elasticEnergy();
    Real sum = 0;
    for (const auto& interaction : *scene.interactions) {
        if (!interaction->isReal())
            continue;
        if (const auto* phys = dynamic_cast<const BondPhys*>(interaction->phys.get()))
            sum += phys->elasticEnergy();
    }
    return sum;
}

Real dampedEnergy(const Scene& scene) {
    const bool tracked = scene.energy->names.count("nonviscDamp") > 0;
    return !tracked ? 0 : scene.energy->getItem_py("nonviscDamp");
}

}
