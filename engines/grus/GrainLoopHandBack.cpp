// GrainLoop: from arrays to YADE's objects.
#include <grus/GrainLoop.hpp>

#include <algorithm>

#include <core/Body.hpp>
#include <core/Clump.hpp>
#include <core/InteractionContainer.hpp>
#include <core/Scene.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondMat.hpp>
#include <grus/Ip2_BondMat_BondMat_BondPhys.hpp>

namespace yade {

namespace grainloop = grus::grainloop;
namespace physics = grus::physics;

namespace {

/// The interaction of two bodies that have just come to touch, with a new geometry and `phys`.
boost::shared_ptr<Interaction> touching(Scene& scene, int id1, int id2, const boost::shared_ptr<BondPhys>& phys) {
    boost::shared_ptr<Interaction> interaction = scene.interactions->find(id1, id2);
    if (!interaction) {
        interaction.reset(new Interaction(id1, id2));
        scene.interactions->insert(interaction);
    }
    interaction->id1 = id1; // a potential contact may have them the other way round
    interaction->id2 = id2;
    interaction->geom.reset(new ScGeom);
    interaction->phys = phys;
    interaction->iterMadeReal = scene.iter;
    return interaction;
}

}

void GrainLoop::handBackInteractions() {
    claimed.assign(known.size(), 0);
    for (std::size_t k = 0; k < assembly.pairs.size(); ++k)
        if (assembly.real(k))
            handBackPair(k);
    for (const auto& contact : assembly.wallContacts)
        if (contact.touches)
            handBackWallContact(contact);
    for (std::size_t n = 0; n < claimed.size(); ++n)
        if (!claimed[n])
            known[n]->reset(); // a collider reports no pair twice while its bounds overlap
}

void GrainLoop::handBackPair(std::size_t k) {
    auto& pairs = assembly.pairs;
    const auto& elements = assembly.elements;
    const int one = pairs.first[k], two = pairs.second[k];
    const auto newContact = [&] {
        const auto [materialOne, radiusOne] = elementKinds[elements.kind[one]];
        const auto [materialTwo, radiusTwo] = elementKinds[elements.kind[two]];
        return Ip2_BondMat_BondMat_BondPhys::contact(*materialOne, radiusOne, *materialTwo, radiusTwo);
    };
    boost::shared_ptr<Interaction> interaction;
    if (pairs.link[k] >= 0) {
        interaction = known[pairs.link[k]];
        claimed[pairs.link[k]] = 1;
        if (pairs.lost[k])
            interaction->phys = newContact();
    } else
        interaction = touching(*scene, elementId[one], elementId[two], newContact());
    auto& geom = static_cast<ScGeom&>(*interaction->geom);
    auto& phys = static_cast<BondPhys&>(*interaction->phys);
    const Vector3r normal = pairs.normal[k];
    geom.refR1 = elements.radius[one];
    geom.refR2 = elements.radius[two];
    geom.normal = normal;
    geom.penetrationDepth = assembly.overlap(k);
    geom.contactPoint = elements.position[one] + (geom.refR1 - 0.5 * geom.penetrationDepth) * normal;
    phys.breakage = pairs.breakage[k];
    phys.overlap0 = pairs.overlap0[k];
    auto state = grainloop::pairState(pairs, k, assembly.kinds[pairs.kind[k]], geom.penetrationDepth - phys.overlap0);
    phys.carry(state, normal);
}

void GrainLoop::handBackWallContact(const grainloop::WallContact& contact) {
    const auto& elements = assembly.elements;
    const auto& wall = assembly.walls[contact.wall];
    const int i = contact.element;
    boost::shared_ptr<Interaction> interaction;
    if (contact.link >= 0) {
        interaction = known[contact.link];
        claimed[contact.link] = 1;
    } else {
        const auto [material, radius] = elementKinds[elements.kind[i]];
        const auto& wallMaterial = static_cast<const BondMat&>(*Body::byId(wallId[contact.wall], scene)->material);
        interaction = touching(*scene, wallId[contact.wall], elementId[i],
                               Ip2_BondMat_BondMat_BondPhys::contact(wallMaterial, radius, *material, radius));
    }
    auto& geom = static_cast<ScGeom&>(*interaction->geom);
    const auto geometry = grainloop::wallGeometry(wall, elements.position[i], elements.radius[i]);
    geom.refR1 = geom.refR2 = elements.radius[i];
    geom.normal = geometry.normal;
    geom.penetrationDepth = geometry.penetration;
    geom.contactPoint = elements.position[i];
    geom.contactPoint[wall.axis] = wall.position[wall.axis];
    static_cast<BondPhys&>(*interaction->phys).carry(contact.state, geometry.normal);
}

void GrainLoop::handBackForces() {
    auto& forces = scene->forces;
    for (std::size_t i = 0; i < elementId.size(); ++i) {
        forces._force[elementId[i]] = assembly.forces.force(static_cast<int>(i));
        forces._torque[elementId[i]] = assembly.forces.moment(static_cast<int>(i));
    }
    for (std::size_t b = 0; b < bodyId.size(); ++b)
        if (Body::byId(bodyId[b], scene)->isClump())
            grainloop::bodyLoad(assembly.bodies, assembly.elements, assembly.forces, static_cast<int>(b),
                                forces._force[bodyId[b]], forces._torque[bodyId[b]]);
    for (std::size_t w = 0; w < wallId.size(); ++w) {
        forces._force[wallId[w]] = assembly.walls[w].force;
        forces._torque[wallId[w]] = assembly.walls[w].moment;
    }
    forces.synced = true;
}

void GrainLoop::handBackBodies() {
    const auto& bodies = assembly.bodies;
    const auto& elements = assembly.elements;
    for (std::size_t b = 0; b < bodyId.size(); ++b) {
        const Body& body = *Body::byId(bodyId[b], scene);
        State& state = *body.state;
        state.pos = bodies.position[b];
        state.vel = bodies.velocity[b];
        state.angVel = bodies.rate[b];
        state.angMom = bodies.momentum[b];
        state.ori = Quaternionr(bodies.qw[b], bodies.qx[b], bodies.qy[b], bodies.qz[b]);
        if (!body.isClump())
            continue;
        const auto& members = static_cast<const Clump&>(*body.shape).members;
        for (int i = bodies.begin[b]; i < bodies.begin[b + 1]; ++i) {
            State& member = *Body::byId(elementId[i], scene)->state;
            member.pos = elements.position[i];
            member.vel = elements.velocity[i];
            member.angVel = elements.rate[i];
            member.ori = state.ori * members.at(elementId[i]).orientation;
        }
    }
    for (std::size_t w = 0; w < wallId.size(); ++w)
        Body::byId(wallId[w], scene)->state->pos = assembly.walls[w].position;
    scene->doSort = true; // a collider that takes over cannot know how far bodies have gone
}

}
