#include <grus/Law2_ScGeom_BondPhys_Bonded.hpp>

#include <core/Body.hpp>
#include <core/Cell.hpp>
#include <core/Scene.hpp>

#include <grus/BondMat.hpp>
#include <physics/bond.hpp>
#include <physics/contact.hpp>
#include <physics/transport.hpp>

namespace yade {

namespace physics = grus::physics;

struct Law2_ScGeom_BondPhys_Bonded::Motion {
    Real overlap;      // since birth of the bond [m]
    Vector3r slip;     // of 2 against 1 across the normal [m]
    Vector3r rotation; // of 1 against 2 [rad]
    Vector3r normal;
};

bool Law2_ScGeom_BondPhys_Bonded::go(boost::shared_ptr<IGeom>& ig, boost::shared_ptr<IPhys>& ip, Interaction* I) {
    const auto& geom = *static_cast<ScGeom*>(ig.get());
    auto& phys = *static_cast<BondPhys*>(ip.get());
    const Real overlap = geom.penetrationDepth - phys.overlap0;
    if (!phys.bonded && overlap < 0 && geom.penetrationDepth < 0)
        return false;

    const State& one = *Body::byId(I->id1, scene)->state;
    const State& two = *Body::byId(I->id2, scene)->state;
    const Vector3r& normal = geom.normal;
    const Motion motion{overlap, geom.shearInc, (one.angVel - two.angVel) * scene->dt, normal};
    if (!phys.lastNormal.isZero()) {
        const Real roll = 0.5 * scene->dt * normal.dot(one.angVel + two.angVel);
        phys.contactShear = physics::transport(phys.contactShear, phys.lastNormal, normal, roll);
        if (phys.bonded && phys.bondKind == BondMat::ParallelBond) {
            phys.bondShear = physics::transport(phys.bondShear, phys.lastNormal, normal, roll);
            phys.bondBending = physics::transport(phys.bondBending, phys.lastNormal, normal, roll);
        }
    }
    phys.lastNormal = normal;

    if (phys.bonded && phys.bondKind == BondMat::ParallelBond)
        parallelBond(phys, motion, *I, geom.contactPoint);
    if (phys.bonded && phys.bondKind == BondMat::ContactBond)
        contactBond(phys, motion, *I, geom.contactPoint);
    else
        frictionalContact(phys, motion);

    phys.normalForce = (phys.contactNormal + phys.bondNormal) * normal;
    phys.shearForce = phys.contactShear + phys.bondShear;
    Vector3r pos2 = two.pos;
    if (scene->isPeriodic)
        pos2 += scene->cell->hSize * I->cellDist.cast<Real>();
    applyForceAtContactPoint(-phys.normalForce - phys.shearForce, geom.contactPoint, I->id1, one.pos, I->id2, pos2);
    if (phys.bonded && phys.bondKind == BondMat::ParallelBond) {
        const Vector3r moment = phys.bondBending + phys.bondTwist * normal;
        scene->forces.addTorque(I->id1, -moment);
        scene->forces.addTorque(I->id2, moment);
    }
    return true;
}

void Law2_ScGeom_BondPhys_Bonded::parallelBond(BondPhys& phys, const Motion& motion, const Interaction& I,
                                               const Vector3r& place) const {
    const auto section = phys.section();
    const auto stiffness = phys.stiffness();
    auto load = phys.load();
    physics::deform(load, stiffness, motion.overlap, motion.slip, motion.rotation, motion.normal);
    const auto mode =
        physics::failure(physics::rimStress(load, section, phys.bondRadius, phys.momentContribution), phys.strength());
    if (mode != physics::Breakage::None) {
        breakBond(phys, mode, physics::bondEnergy(load, stiffness), I, place);
        load = {};
    }
    phys.carry(load);
}

void Law2_ScGeom_BondPhys_Bonded::contactBond(BondPhys& phys, const Motion& motion, const Interaction& I,
                                              const Vector3r& place) const {
    phys.contactNormal = phys.kn * motion.overlap;
    phys.contactShear -= phys.ks * motion.slip;
    const auto mode = physics::failure(phys.stress(), phys.strength());
    if (mode == physics::Breakage::None)
        return;
    const Real before = phys.elasticEnergy();
    phys.contactNormal = physics::contactNormal(phys.kn, motion.overlap);
    physics::slide(phys.contactShear, phys.contactNormal * phys.tangensOfFrictionAngle, phys.ks, 0);
    breakBond(phys, mode, before - phys.elasticEnergy(), I, place);
}

void Law2_ScGeom_BondPhys_Bonded::frictionalContact(BondPhys& phys, const Motion& motion) const {
    phys.contactNormal = physics::contactNormal(phys.kn, motion.overlap);
    const Real before = phys.contactShear.norm();
    phys.contactShear -= phys.ks * motion.slip;
    const Real limit = phys.contactNormal * phys.tangensOfFrictionAngle;
    const Real work = physics::slide(phys.contactShear, limit, phys.ks, before);
    if (work > 0 && ledger)
        ledger->recordSliding(work);
}

void Law2_ScGeom_BondPhys_Bonded::breakBond(BondPhys& phys, physics::Breakage mode, Real released, const Interaction& I,
                                            const Vector3r& place) const {
    phys.bonded = false;
    phys.breakage = static_cast<int>(mode);
    if (ledger)
        ledger->recordBreakage(
            {std::min(I.id1, I.id2), std::max(I.id1, I.id2), static_cast<int>(mode), released, place});
}

YADE_PLUGIN((Law2_ScGeom_BondPhys_Bonded));

}
