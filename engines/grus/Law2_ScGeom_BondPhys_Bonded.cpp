#include <grus/Law2_ScGeom_BondPhys_Bonded.hpp>

#include <core/Body.hpp>
#include <core/Cell.hpp>
#include <core/Scene.hpp>

#include <grus/BondMat.hpp>
#include <physics/pairlaw.hpp>

namespace yade {

namespace physics = grus::physics;

bool Law2_ScGeom_BondPhys_Bonded::go(boost::shared_ptr<IGeom>& ig, boost::shared_ptr<IPhys>& ip, Interaction* I) {
    const auto& geom = *static_cast<ScGeom*>(ig.get());
    auto& phys = *static_cast<BondPhys*>(ip.get());
    const Real overlap = geom.penetrationDepth - phys.overlap0;
    const State& one = *Body::byId(I->id1, scene)->state;
    const State& two = *Body::byId(I->id2, scene)->state;
    const Vector3r& normal = geom.normal;
    physics::PairState state = phys.state();
    const physics::PairEvents events =
        physics::stepPair(state, phys.constants(), phys.strength(),
                          {overlap, geom.shearInc, (one.angVel - two.angVel) * scene->dt, normal,
                           0.5 * scene->dt * normal.dot(one.angVel + two.angVel)});
    phys.carry(state, normal);
    book(phys, events, *I, geom.contactPoint);
    if (physics::apart(phys.bonded, overlap, geom.penetrationDepth))
        return false;

    Vector3r pos2 = two.pos;
    if (scene->isPeriodic)
        pos2 += scene->cell->hSize * I->cellDist.cast<Real>();
    applyForceAtContactPoint(-phys.normalForce - phys.shearForce, geom.contactPoint, I->id1, one.pos, I->id2, pos2);
    if (phys.bonded && phys.bondKind == BondMat::ParallelBond) {
        const Vector3r moment = physics::pairMoment(state, normal);
        scene->forces.addTorque(I->id1, -moment);
        scene->forces.addTorque(I->id2, moment);
    }
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
