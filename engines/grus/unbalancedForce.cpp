#include <grus/unbalancedForce.hpp>

#include <core/Body.hpp>
#include <core/Clump.hpp>
#include <core/InteractionContainer.hpp>
#include <pkg/common/NormShearPhys.hpp>

#include <grus/LiveScene.hpp>

namespace yade {

namespace {

/// Force on a body; on a clump it is that on its members, which are only summed by the integrator.
Vector3r resultant(const Body& body, Scene& scene) {
    if (!body.isClump())
        return scene.forces.getForce(body.id);
    Vector3r sum = Vector3r::Zero();
    for (const auto& [member, place] : static_cast<const Clump&>(*body.shape).members)
        sum += scene.forces.getForce(member);
    return sum;
}

/// The part of a force along the degrees of freedom that are not blocked.
Vector3r free(Vector3r force, unsigned blocked) {
    for (int axis = 0; axis < 3; ++axis)
        if (blocked & (1u << axis))
            force[axis] = 0;
    return force;
}

}

Real unbalancedForce(Scene& scene) {
    if (const LiveScene* live = LiveScene::of(scene))
        return live->unbalancedForce();
    Real resultants = 0, contacts = 0;
    int bodies = 0, count = 0;
    for (const auto& body : scene.bodies->body) {
        if (!body || body->isClumpMember() || body->state->blockedDOFs == State::DOF_ALL)
            continue;
        resultants += free(resultant(*body, scene), body->state->blockedDOFs).norm();
        ++bodies;
    }
    for (const auto& interaction : *scene.interactions) {
        if (!interaction->isReal())
            continue;
        const auto* phys = dynamic_cast<const NormShearPhys*>(interaction->phys.get());
        if (!phys)
            continue;
        contacts += (phys->normalForce + phys->shearForce).norm();
        ++count;
    }
    return contacts > 0 ? (resultants / bodies) / (contacts / count) : 0;
}

}
