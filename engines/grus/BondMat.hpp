#pragma once

#include <string>

#include <pkg/common/ElastMat.hpp>

#include <physics/stiffness.hpp>
#include <physics/strength.hpp>

namespace yade {

/// Material of crushable grains and of the platens that load them.
class BondMat : public FrictMat {
public:
    enum BondKind { None = 0, ContactBond = 1, ParallelBond = 2 };

    virtual ~BondMat(){};
    void postLoad(BondMat&);
    virtual boost::shared_ptr<State> newAssocState() const override;
    virtual bool stateTypeOk(State*) const override;

    BondKind bondKind() const;
    grus::physics::StiffnessKind stiffnessKind() const;
    grus::physics::Scatter scatterKind() const;
    bool hertz() const { return contactLaw == "hertz"; }
    /// Whether contacts of this material are more than linear springs with friction.
    bool hasContactOptions() const { return hertz() || unloadingRatio > 1 || rollingStiffness > 0; }

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR(BondMat, FrictMat,
        "Material of elements that can be bonded into crushable grains. Only two elements of one material object and of one grain (:yref:`BondState.grain`) are ever bonded.",
        ((Real, kn, -1, Attr::triggerPostLoad, "Normal contact stiffness of one element [N/m]; a contact has the two in series. Negative: 2 E R as in YADE's frictional materials, with E = :yref:`young<ElastMat.young>`."))
        ((Real, ks, -1, Attr::triggerPostLoad, "Shear contact stiffness of one element [N/m]; a contact has the two in series. Negative: :yref:`poisson<ElastMat.poisson>` times the normal stiffness."))
        ((std::string, contactLaw, "linear", Attr::triggerPostLoad, "Stiffness of contacts: 'linear', or 'hertz' (Hertz-Mindlin) from :yref:`young<ElastMat.young>` and :yref:`poisson<ElastMat.poisson>`, which then are those of the solid, instead of :yref:`BondMat.kn` and :yref:`BondMat.ks`. A linear partner of a Hertz element counts as rigid."))
        ((Real, unloadingRatio, 1, Attr::triggerPostLoad, "Normal stiffness of a contact that is unloaded or reloaded over that of first loading (Walton & Braun 1986), 1 or more [-]; 1: elastic. A contact takes the larger of both materials. Linear contacts only."))
        ((Real, rollingStiffness, 0, Attr::triggerPostLoad, "Rolling stiffness alpha [-]: a contact without a bond resists rolling with alpha R1 R2 times its shear stiffness [N m/rad]; alpha is the harmonic mean of both materials. 0: none. As alphaKr of :yref:`CohFrictMat`."))
        ((Real, rollingFriction, 0, Attr::triggerPostLoad, "Rolling friction eta [-]: the moment that resists rolling is at most eta R times the normal force, with the smaller eta R of both bodies. As etaRoll of :yref:`CohFrictMat`, which knows no limit for negative ones."))
        ((std::string, bond, "none", Attr::triggerPostLoad, "Kind of bond: 'none', 'contact' or 'parallel'."))
        ((std::string, bondStiffness, "total", Attr::triggerPostLoad, "How :yref:`BondMat.bondKn` and :yref:`BondMat.bondKs` are given: 'total' of the section [N/m], 'area' per area [Pa/m], or 'modulus' [Pa], which is E/(RA+RB) per area. Parallel bonds only."))
        ((Real, bondKn, 0, Attr::triggerPostLoad, "Normal stiffness of a parallel bond, in the unit that :yref:`BondMat.bondStiffness` says."))
        ((Real, bondKs, 0, Attr::triggerPostLoad, "Shear stiffness of a parallel bond, in the unit that :yref:`BondMat.bondStiffness` says."))
        ((Real, bondRadiusRatio, 1, Attr::triggerPostLoad, "Radius of a parallel bond over the smaller element radius (lambda) [-]."))
        ((Real, momentContribution, 1, Attr::triggerPostLoad, "Weight of the moments in the stress of a parallel bond (beta, Potyondy 2011), 0 to 1 [-]."))
        ((Real, tensileStrength, 0, Attr::triggerPostLoad, "Tensile strength: stress [Pa] of a parallel bond, force [N] of a contact bond. With 0, the default, a bond breaks in the first step."))
        ((Real, shearStrength, 0, Attr::triggerPostLoad, "Shear strength (the cohesion when :yref:`BondMat.bondFrictionAngle` is not 0): stress [Pa] of a parallel bond, force [N] of a contact bond."))
        ((Real, bondFrictionAngle, 0, Attr::triggerPostLoad, "Friction angle of the bond's Mohr-Coulomb shear strength [rad]; 0: constant shear strength."))
        ((std::string, scatter, "none", Attr::triggerPostLoad, "Scatter of strength from bond to bond: 'none', 'normal' (mean 1, truncated to 0 to 2) or 'weibull' (characteristic value 1)."))
        ((Real, scatterParameter, 0, Attr::triggerPostLoad, "Coefficient of variation (normal) or modulus (Weibull) of the scatter from bond to bond [-]."))
        ((Real, grainModulus, 0, Attr::triggerPostLoad, "Weibull modulus of a strength factor that all bonds of a grain share; 0: none [-]."))
        ((Real, grainReferenceDiameter, 0, Attr::triggerPostLoad, "Diameter of a grain without size effect [m]; the grain factor then follows (d/d0)^(-dim/m) with m = :yref:`BondMat.grainModulus` for elements whose :yref:`BondState.grainDiameter` is set. 0: no size effect."))
        ((Real, thickness, 0, Attr::triggerPostLoad, "Thickness of a plane specimen of discs [m]; 0: spheres."))
        ((int, seed, 1, Attr::triggerPostLoad, "Seed of every random strength; a draw depends on it and on the ids of the bond or grain, on nothing else."))
        , createIndex();
    );
    // clang-format on
    REGISTER_CLASS_INDEX(BondMat, FrictMat);
};
REGISTER_SERIALIZABLE(BondMat);

}
