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
        const bool hertz = hertzNormal > 0;
        return {kind,
                hertz ? 0 : kn,
                hertz ? 0 : ks,
                tangensOfFrictionAngle,
                kind == grus::physics::BondKind::Parallel ? stiffness() : grus::physics::BondStiffness{},
                section(),
                bondRadius,
                momentContribution,
                {{hertzNormal, hertzShear}, unloadingRatio, {rollingStiffness, rollingArm}}};
    }
    grus::physics::PairState state() const {
        return {bonded, contactNormal, contactShear, load(), lastNormal, lastOverlap, largestOverlap, rollingMoment};
    }
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
        lastOverlap = state.overlap;
        largestOverlap = state.largest;
        rollingMoment = state.rolling;
        if (hertzNormal > 0)
            follow();
        normalForce = (contactNormal + bondNormal) * normal;
        shearForce = contactShear + bondShear;
    }

    grus::physics::BondStress stress() const;
    /// Stiffnesses that an increment meets at the last overlap or, if that is larger, at `overlap` [m].
    grus::physics::ContactTangents tangents(Real overlap = 0) const;

    Real elasticEnergy() const;
    Real tension() const;
    Real shear() const;

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BondPhys, FrictPhys,
        "A contact with or without a bond. In a Hertz contact kn and ks are those that an increment met in the last step. Forces and moments act on the second body; compression is positive. normalForce and shearForce hold the sum of contact and bond.",
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
        ((Real, hertzNormal, 0, Attr::readonly, "Normal force of a Hertz contact over its overlap to the power 3/2 [N/m^1.5]; 0: linear contact."))
        ((Real, hertzShear, 0, Attr::readonly, "Shear stiffness of a Hertz contact over the root of its overlap [N/m^1.5]."))
        ((Real, unloadingRatio, 1, , "Normal stiffness of unloading and reloading over that of first loading [-]."))
        ((Real, rollingStiffness, 0, , "Rolling stiffness over shear stiffness, alpha R1 R2 [m2]; 0: no rolling resistance."))
        ((Real, rollingArm, 0, , "Largest moment of rolling resistance over the normal force, eta R [m]."))
        ((Real, lastOverlap, 0, , "Overlap of the last step, since the contact was bonded or formed [m]."))
        ((Real, largestOverlap, 0, , "Largest of these overlaps so far [m]; kept with options of the contact only."))
        ((Vector3r, rollingMoment, Vector3r::Zero(), , "Moment of rolling resistance [N m]."))
        ((Real, intact, 1, , "Share of the bond's strength (power law) or diameter (stress corrosion) that ageing has left [-]; see :yref:`BondAgeing`."))
        , createIndex();
        , .def("elasticEnergy", &BondPhys::elasticEnergy, "Elastic energy of contact and bond [J].")
        .def("tension", &BondPhys::tension, "Largest tension now: [Pa] at the rim of a parallel bond, [N] of a contact bond; 0 without a bond.")
        .def("shear", &BondPhys::shear, "Largest shear now: [Pa] at the rim of a parallel bond, [N] of a contact bond; 0 without a bond.")
    );
    // clang-format on
    REGISTER_CLASS_INDEX(BondPhys, FrictPhys);

private:
    void follow(); // kn and ks of a Hertz contact to the last overlap
};
REGISTER_SERIALIZABLE(BondPhys);

}
