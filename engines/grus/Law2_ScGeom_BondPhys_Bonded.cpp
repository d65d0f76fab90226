#include <grus/Law2_ScGeom_BondPhys_Bonded.hpp>

#include <core/Body.hpp>
#include <core/BodyContainer.hpp>
#include <core/Cell.hpp>
#include <core/Scene.hpp>

#include <grus/BondMat.hpp>
#include <physics/pairlaw.hpp>

namespace yade {

namespace physics = grus::physics;

namespace {

/// What a step gives.
struct Outcome {
    physics::PairEvents events;
    Vector3r force, moment; ///< on body 2
};

/// One step of the law; the attribute takes all that it calls into one function.
[[gnu::flatten]] Outcome step(BondPhys& phys, const ScGeom& geom, Real overlap, const Vector3r& rate1,
                              const Vector3r& rate2, Real dt) {
    const Vector3r normal = geom.normal;
    physics::PairState state = phys.state();
    Outcome outcome;
    outcome.events =
        physics::stepPair(state, phys.constants(), phys.strength(),
                          {overlap, geom.shearInc, (rate1 - rate2) * dt, normal, 0.5 * dt * normal.dot(rate1 + rate2)});
    phys.carry(state, normal);
    outcome.force = physics::pairForce(state, normal);
    outcome.moment = physics::pairMoment(state, normal); // zero without a parallel bond
    return outcome;
}

}

bool Law2_ScGeom_BondPhys_Bonded::go(boost::shared_ptr<IGeom>& ig, boost::shared_ptr<IPhys>& ip, Interaction* I) {
    const auto& geom = *static_cast<ScGeom*>(ig.get());
    auto& phys = *static_cast<BondPhys*>(ip.get());
    const Real overlap = geom.penetrationDepth - phys.overlap0;
    const State& one = *scene->bodies->body[I->id1]->state;
    const State& two = *scene->bodies->body[I->id2]->state;
    const Outcome outcome = step(phys, geom, overlap, one.angVel, two.angVel, scene->dt);
    if (outcome.events.breakage != physics::Breakage::None || outcome.events.sliding != 0)
        book(phys, outcome.events, *I, geom.contactPoint);
    if (physics::apart(phys.bonded, overlap, geom.penetrationDepth))
        return false;

    Vector3r pos2 = two.pos;
    if (scene->isPeriodic)
        pos2 += scene->cell->hSize * I->cellDist.cast<Real>();
    const Vector3r& force = outcome.force;
    scene->forces.addForce(I->id1, -force);
    scene->forces.addForce(I->id2, force);
    scene->forces.addTorque(I->id1, -(physics::cross(geom.contactPoint - one.pos, force) + outcome.moment));
    scene->forces.addTorque(I->id2, physics::cross(geom.contactPoint - pos2, force) + outcome.moment);
    return true;
}

void Law2_ScGeom_BondPhys_Bonded::book(BondPhys& phys, const physics::PairEvents& events, const Interaction& I,
                                       const Vector3r& place) const {
    if (events.breakage != physics::Breakage::None)
        phys.breakage = static_cast<int>(events.breakage);
    if (!ledger)
        return;
    if (events.sliding != 0)
        ledger->recordSliding(events.sliding);
    if (events.breakage != physics::Breakage::None)
        ledger->recordBreakage({std::min(I.id1, I.id2), std::max(I.id1, I.id2), phys.breakage, events.released, place});
}

YADE_PLUGIN((Law2_ScGeom_BondPhys_Bonded));

}
