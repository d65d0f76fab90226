#include <grus/BondPhys.hpp>

#include <grus/BondMat.hpp>

namespace yade {

void BondPhys::carry(const grus::physics::BondLoad& load) {
    bondNormal = load.normal;
    bondShear = load.shear;
    bondBending = load.bending;
    bondTwist = load.twist;
}

Real BondPhys::elasticEnergy() const {
    using namespace grus::physics;
    const Real contact = springEnergy(contactNormal, kn) + springEnergy(contactShear.norm(), ks);
    return bonded && bondKind == BondMat::ParallelBond ? contact + bondEnergy(load(), stiffness()) : contact;
}

grus::physics::BondStress BondPhys::stress() const {
    if (!bonded)
        return {};
    if (bondKind == BondMat::ContactBond)
        return {-contactNormal, contactShear.norm(), contactNormal};
    return grus::physics::rimStress(load(), section(), bondRadius, momentContribution);
}

Real BondPhys::tension() const { return stress().tension; }

Real BondPhys::shear() const { return stress().shear; }

YADE_PLUGIN((BondPhys));

}
