#include <grus/BondPhys.hpp>

#include <algorithm>

#include <grus/BondMat.hpp>

namespace yade {

Real BondPhys::elasticEnergy() const { return grus::physics::pairEnergy(state(), constants()); }

grus::physics::BondStress BondPhys::stress() const {
    if (!bonded)
        return {};
    if (bondKind == BondMat::ContactBond)
        return {-contactNormal, contactShear.norm(), contactNormal};
    return grus::physics::rimStress(load(), section(), bondRadius, momentContribution);
}

grus::physics::ContactTangents BondPhys::tangents(Real overlap) const {
    return grus::physics::contactTangents(constants(), std::max(lastOverlap, overlap));
}

void BondPhys::follow() {
    const auto now = tangents();
    kn = now.normal;
    ks = now.shear;
}

Real BondPhys::tension() const { return stress().tension; }

Real BondPhys::shear() const { return stress().shear; }

YADE_PLUGIN((BondPhys));

}
