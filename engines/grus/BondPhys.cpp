#include <grus/BondPhys.hpp>

#include <grus/BondMat.hpp>

namespace yade {

grus::physics::PairConstants BondPhys::constants() const {
    return {static_cast<grus::physics::BondKind>(bondKind),
            kn,
            ks,
            tangensOfFrictionAngle,
            bondKind == BondMat::ParallelBond ? stiffness() : grus::physics::BondStiffness{},
            section(),
            bondRadius,
            momentContribution};
}

grus::physics::PairState BondPhys::state() const { return {bonded, contactNormal, contactShear, load(), lastNormal}; }

void BondPhys::carry(const grus::physics::PairState& state, const Vector3r& normal) {
    bonded = state.bonded;
    contactNormal = state.contactNormal;
    contactShear = state.contactShear;
    bondNormal = state.load.normal;
    bondShear = state.load.shear;
    bondBending = state.load.bending;
    bondTwist = state.load.twist;
    lastNormal = normal;
    normalForce = (contactNormal + bondNormal) * normal;
    shearForce = contactShear + bondShear;
}

Real BondPhys::elasticEnergy() const { return grus::physics::pairEnergy(state(), constants()); }

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
