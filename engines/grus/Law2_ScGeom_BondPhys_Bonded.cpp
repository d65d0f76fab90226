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
    if (!phys.bonded && overlap < 0 && geom.penetrationDepth < 0)
        return false;

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
    const auto before = phys.load();
    auto load = before;
    physics::deform(load, stiffness, motion.overlap, motion.slip, motion.rotation, motion.normal);
    const auto mode =
        physics::failure(physics::rimStress(load, section, phys.bondRadius, phys.momentContribution), phys.strength());
    if (mode != physics::Breakage::None) {
        breakBond(phys, mode, physics::releasedEnergy(before, load, stiffness), I, place);
        load = {};
    }
    phys.carry(load);
}

void Law2_ScGeom_BondPhys_Bonded::contactBond(BondPhys& phys, const Motion& motion, const Interaction& I,
                                              const Vector3r& place) const {
    const Real normal = phys.contactNormal;
    const Vector3r shear = phys.contactShear;
    phys.contactNormal = phys.kn * motion.overlap;
    phys.contactShear -= phys.ks * motion.slip;
    const auto mode = physics::failure(phys.stress(), phys.strength());
    if (mode == physics::Breakage::None)
        return;
    const Real trialNormal = phys.contactNormal;
    const Vector3r trialShear = phys.contactShear;
    phys.contactNormal = physics::contactNormal(phys.kn, motion.overlap);
    phys.contactShear = physics::slide(trialShear, phys.contactNormal * phys.tangensOfFrictionAngle);
    const Real released = physics::lostEnergy(normal, trialNormal, phys.contactNormal, phys.kn) +
                          physics::lostEnergy(shear, trialShear, phys.contactShear, phys.ks);
    breakBond(phys, mode, released, I, place);
}

void Law2_ScGeom_BondPhys_Bonded::frictionalContact(BondPhys& phys, const Motion& motion) const {
    const Vector3r before = phys.contactShear;
    const Vector3r trial = before - phys.ks * motion.slip;
    phys.contactNormal = physics::contactNormal(phys.kn, motion.overlap);
    phys.contactShear = physics::slide(trial, phys.contactNormal * phys.tangensOfFrictionAngle);
    const Real work = physics::lostEnergy(before, trial, phys.contactShear, phys.ks);
    if (work != 0 && ledger)
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
