#include <grus/AgeingBond.hpp>

#include <stdexcept>

#include <pkg/dem/ScGeom.hpp>

#include <grus/BondMat.hpp>

namespace yade {

namespace physics = grus::physics;

AgeingBond::AgeingBond(const Interaction& i, const AgeingLaw& byLaw)
    : id1(std::min(i.id1, i.id2)), id2(std::max(i.id1, i.id2)), interaction(&i),
      phys(static_cast<BondPhys*>(i.phys.get())), law(&byLaw) {
    const physics::BondStress rim = phys->stress();
    const physics::BondStrength strength = phys->strength();
    if (law->corrosion) {
        if (phys->bondKind != BondMat::ParallelBond)
            throw std::runtime_error("BondAgeing: the bond " + std::to_string(id1) + "-" + std::to_string(id2) +
                                     " is a contact bond and has no diameter that corrodes; use law = 'power'");
        const auto forces = physics::rimStress(phys->load(), phys->section(), phys->bondRadius, 0);
        ratios = physics::ratiosOfDiameter(rim, forces, strength, order());
    } else
        ratios = physics::ratiosOfStrength(rim, strength);
    const Real humidity = law->corrosion ? law->stressCorrosion.humidity : law->power.humidity;
    ages = humidity > 0 && physics::ages(physics::ageingStress(rim, strength, law->stress), law->threshold);
    leftAtFailure = ages ? ratios.leftAtFailure() : 0;
    mode = ages ? ratios.mode() : physics::Breakage::None;
}

Real AgeingBond::timeUntil(Real left) const {
    if (left >= 1)
        return 0;
    if (law->corrosion)
        return physics::timeUntil(law->stressCorrosion, 2 * phys->bondRadius, ratios, law->stress, left);
    return physics::timeUntil(law->power, phys->intact, physics::ageingRatio(ratios, law->stress, 1), left);
}

Real AgeingBond::leftAfter(Real time) const {
    if (!ages || leftAtFailure >= 1)
        return 1;
    const Real left =
        law->corrosion
            ? physics::leftAfter(law->stressCorrosion, 2 * phys->bondRadius, ratios, law->stress, time)
            : physics::leftAfter(law->power, phys->intact, physics::ageingRatio(ratios, law->stress, 1), time);
    return std::max(left, leftAtFailure);
}

Vector3r AgeingBond::place() const { return static_cast<const ScGeom&>(*interaction->geom).contactPoint; }

Real AgeingBond::age(Real left) const {
    if (left >= 1)
        return 0;
    phys->intact *= left;
    if (!law->corrosion) {
        const physics::BondStrength strength = physics::softened(phys->strength(), left);
        phys->tensileStrength = strength.tensile;
        phys->shearStrength = strength.shear;
        return 0;
    }
    const Real before = phys->elasticEnergy();
    const physics::Section section = physics::thinned(phys->section(), left, order());
    physics::PairState state = phys->state();
    state.load = physics::thinned(state.load, left, order());
    const Real share = section.area / phys->sectionArea;
    phys->bondRadius *= left;
    phys->bondKn *= share;
    phys->bondKs *= share;
    phys->sectionArea = section.area;
    phys->sectionInertia = section.inertia;
    phys->sectionPolar = section.polar;
    phys->carry(state, phys->lastNormal);
    return before - phys->elasticEnergy();
}

void AgeingBond::fail() const { (mode == physics::Breakage::Shear ? phys->shearStrength : phys->tensileStrength) = 0; }

}
