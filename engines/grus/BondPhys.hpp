#pragma once

#include <pkg/dem/FrictPhys.hpp>

#include <physics/pairlaw.hpp>

namespace yade {

/// A contact with or without a bond: stiffnesses, strengths and everything it carries.
class BondPhys : public FrictPhys {
public:
    virtual ~BondPhys(){};

    grus::physics::Section section() const { return {sectionArea, sectionInertia, sectionPolar}; }
    grus::physics::BondStiffness stiffness() const { return grus::physics::bondStiffness(bondKn, bondKs, section()); }
    grus::physics::BondStrength strength() const { return {tensileStrength, shearStrength, bondTanPhi}; }
    grus::physics::BondLoad load() const { return {bondNormal, bondShear, bondBending, bondTwist}; }
    grus::physics::PairConstants constants() const {
        const auto kind = static_cast<grus::physics::BondKind>(bondKind);
        return {kind,
                kn,
                ks,
                tangensOfFrictionAngle,
                kind == grus::physics::BondKind::Parallel ? stiffness() : grus::physics::BondStiffness{},
                section(),
                bondRadius,
                momentContribution};
    }
    grus::physics::PairState state() const { return {bonded, contactNormal, contactShear, load(), lastNormal}; }
    /// Takes over what the law made of state(), and the forces that follow from it.
    void carry(const grus::physics::PairState& state, const Vector3r& normal) {
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

    grus::physics::BondStress stress() const;

    Real elasticEnergy() const;
    Real tension() const;
    Real shear() const;

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BondPhys, FrictPhys,
        "A contact with or without a bond. Forces and moments act on the second body; compression is positive. normalForce and shearForce hold the sum of contact and bond.",
        ((int, bondKind, 0, Attr::readonly, "0: never bonded, 1: contact bond, 2: parallel bond (what it was born as)."))
        ((bool, bonded, false, Attr::readonly, "True while the bond holds."))
        ((int, breakage, 0, Attr::readonly, "How the bond broke: 0 not, 1 in tension, 2 in shear."))
        ((Real, overlap0, 0, , "Overlap at which the contact was bonded [m]; forces are zero there. 0 for a contact that was never bonded."))
        ((Real, bondRadius, 0, , "Radius of the parallel bond [m]."))
        ((Real, sectionArea, 0, , "Area of the bond's section [m2]."))
        ((Real, sectionInertia, 0, , "Second moment of area of the bond's section [m4]."))
        ((Real, sectionPolar, 0, , "Polar moment of the bond's section [m4]; 0 in the plane."))
        ((Real, bondKn, 0, , "Normal stiffness of the parallel bond's whole section [N/m]."))
        ((Real, bondKs, 0, , "Shear stiffness of the parallel bond's whole section [N/m]."))
        ((Real, momentContribution, 1, , "Weight of the moments in the bond stress (beta) [-]."))
        ((Real, tensileStrength, 0, , "Tensile strength of this bond, scatter included: [Pa] parallel, [N] contact bond. May be changed at any time."))
        ((Real, shearStrength, 0, , "Shear strength (cohesion) of this bond, scatter included: [Pa] parallel, [N] contact bond. May be changed at any time."))
        ((Real, bondTanPhi, 0, , "Tangent of the bond's own friction angle [-]."))
        ((Real, strengthFactor, 1, , "Random factor that is contained in the two strengths [-]."))
        ((Real, bondNormal, 0, , "Normal force of the parallel bond [N]."))
        ((Vector3r, bondShear, Vector3r::Zero(), , "Shear force of the parallel bond [N]."))
        ((Vector3r, bondBending, Vector3r::Zero(), , "Bending moment of the parallel bond [N m]."))
        ((Real, bondTwist, 0, , "Twisting moment of the parallel bond [N m]."))
        ((Real, contactNormal, 0, , "Normal force of the contact [N]; negative only in a contact bond."))
        ((Vector3r, contactShear, Vector3r::Zero(), , "Shear force of the contact [N]."))
        ((Vector3r, lastNormal, Vector3r::Zero(), , "Contact normal of the last step, along which the stored vectors are carried."))
        ((Real, intact, 1, , "Share of the bond's strength (power law) or diameter (stress corrosion) that ageing has left [-]; see :yref:`BondAgeing`."))
        , createIndex();
        , .def("elasticEnergy", &BondPhys::elasticEnergy, "Elastic energy of contact and bond [J].")
        .def("tension", &BondPhys::tension, "Largest tension now: [Pa] at the rim of a parallel bond, [N] of a contact bond; 0 without a bond.")
        .def("shear", &BondPhys::shear, "Largest shear now: [Pa] at the rim of a parallel bond, [N] of a contact bond; 0 without a bond.")
    );
    // clang-format on
    REGISTER_CLASS_INDEX(BondPhys, FrictPhys);
};
REGISTER_SERIALIZABLE(BondPhys);

}
