#pragma once

#include <core/Interaction.hpp>

#include <grus/BondPhys.hpp>
#include <physics/ageing.hpp>

namespace yade {

/// The rate law that a BondAgeing follows.
struct AgeingLaw {
    bool corrosion = false; ///< else the power law
    grus::physics::PowerLaw power;
    grus::physics::StressCorrosion stressCorrosion;
    grus::physics::AgeingStress stress = grus::physics::AgeingStress::Tension;
    Real threshold = 0; ///< [Pa, or N of contact bonds]
};

/// A bond as BondAgeing sees it while its load stays as it is.
class AgeingBond {
public:
    /// Of an interaction that is bonded; throws std::runtime_error for a contact bond under stress corrosion.
    AgeingBond(const Interaction& interaction, const AgeingLaw& law);

    int id1, id2;                 ///< smaller and larger id
    bool ages;                    ///< false: it stays as it is for ever
    Real leftAtFailure;           ///< share of the present strength or diameter
    grus::physics::Breakage mode; ///< in which it will fail

    Real timeUntil(Real left) const; ///< [s], for a bond that ages
    Real leftAfter(Real time) const; ///< not less than at failure
    /// When it loses the share `loss` of what it was before any ageing.
    Real leftAfterLoss(Real loss) const { return 1 - loss / phys->intact; }
    Vector3r place() const; ///< [m]

    /// Lets the share `left` of it remain; returns the elastic energy that goes with the cement [J].
    Real age(Real left) const;
    /// Takes the strength in the mode of failure, so that the law breaks the bond in its next step, as any other.
    void fail() const;

private:
    const Interaction* interaction;
    BondPhys* phys;
    const AgeingLaw* law;
    grus::physics::StressRatios ratios;
    int order() const { return phys->sectionPolar > 0 ? 2 : 1; }
};

}
