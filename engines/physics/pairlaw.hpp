// The law of a pair: frictional contact, linear unless it has options, with an optional contact bond or parallel bond,
// over one step.
#pragma once

#include <physics/bond.hpp>
#include <physics/contact.hpp>
#include <physics/contactoptions.hpp>
#include <physics/transport.hpp>

namespace grus::physics {

enum class BondKind { None = 0, Contact = 1, Parallel = 2 };

/// What does not change while a pair lives.
struct PairConstants {
    BondKind kind = BondKind::None;
    double kn = 0, ks = 0; ///< contact stiffnesses [N/m]; 0 in a Hertz contact
    double tanPhi = 0;     ///< tangent of the contact's friction angle
    BondStiffness bond;    ///< of a parallel bond
    Section section;       ///< of a parallel bond
    double bondRadius = 0; ///< of a parallel bond [m]
    double beta = 1;       ///< weight of the moments in the bond stress
    ContactOptions options{};
};

/// What a pair carries from step to step.
struct PairState {
    bool bonded = false;
    double contactNormal = 0; ///< [N], compression positive
    Vec3 contactShear = Vec3::Zero();
    BondLoad load;
    Vec3 lastNormal = Vec3::Zero(); ///< zero before the first step
    // Only contacts with options need these:
    double overlap = 0;          ///< of the last step, since the birth of the bond [m]
    double largest = 0;          ///< largest of these overlaps [m]
    Vec3 rolling = Vec3::Zero(); ///< moment of rolling resistance [N m]
};

/// Relative motion of a pair in one step.
struct PairMotion {
    double overlap = 0; ///< since the birth of the bond [m]
    Vec3 slip;          ///< of 2 against 1 across the normal [m]
    Vec3 rotation;      ///< of 1 against 2 [rad]
    Vec3 normal;        ///< from 1 to 2
    double roll = 0;    ///< mean rotation about the normal [rad]
};

/// What a step did besides changing the state.
struct PairEvents {
    Breakage breakage = Breakage::None;
    double released = 0; ///< energy released by the breakage [J]
    double sliding = 0;  ///< work lost in the contact, by friction or yielding asperities [J]
};

/// True when an unbonded pair no longer touches; `penetration` is the overlap of the two bodies.
inline bool apart(bool bonded, double overlap, double penetration) { return !bonded && overlap < 0 && penetration < 0; }

/// Carries the stored vectors along with the pair.
inline void carryAlong(PairState& s, const PairConstants& c, const Vec3& normal, double roll) {
    if (!s.lastNormal.isZero()) {
        s.contactShear = transport(s.contactShear, s.lastNormal, normal, roll);
        if (c.options.rolling.stiffness > 0)
            s.rolling = transport(s.rolling, s.lastNormal, normal, roll);
        if (s.bonded && c.kind == BondKind::Parallel) {
            s.load.shear = transport(s.load.shear, s.lastNormal, normal, roll);
            s.load.bending = transport(s.load.bending, s.lastNormal, normal, roll);
        }
    }
    s.lastNormal = normal;
}

inline void stepParallelBond(PairState& s, const PairConstants& c, const BondStrength& strength, const PairMotion& m,
                             PairEvents& events) {
    BondLoad load = s.load;
    deform(load, c.bond, m.overlap, m.slip, m.rotation, m.normal);
    const RimFactors rim = rimFactors(c.section, c.bondRadius, c.beta);
    if (mayFail(load, rim, strength))
        events.breakage = failure(rimStress(load, rim), strength);
    if (events.breakage != Breakage::None) {
        events.released = releasedEnergy(s.load, load, c.bond);
        s.bonded = false;
        load = {};
    }
    s.load = load;
}

inline void stepContactBond(PairState& s, const PairConstants& c, const BondStrength& strength, const PairMotion& m,
                            PairEvents& events) {
    const double trialNormal = c.kn * m.overlap;
    const Vec3 trialShear = s.contactShear - c.ks * m.slip;
    events.breakage = failure({-trialNormal, trialShear.norm(), trialNormal}, strength);
    if (events.breakage == Breakage::None) {
        s.contactNormal = trialNormal;
        s.contactShear = trialShear;
        return;
    }
    const double normal = contactNormal(c.kn, m.overlap);
    const Vec3 shear = slide(trialShear, normal * c.tanPhi);
    events.released =
        lostEnergy(s.contactNormal, trialNormal, normal, c.kn) + lostEnergy(s.contactShear, trialShear, shear, c.ks);
    s.contactNormal = normal;
    s.contactShear = shear;
    s.bonded = false;
}

inline void stepContact(PairState& s, const PairConstants& c, const PairMotion& m, PairEvents& events) {
    const Vec3 before = s.contactShear;
    const Vec3 trial = before - c.ks * m.slip;
    s.contactNormal = contactNormal(c.kn, m.overlap);
    s.contactShear = slide(trial, s.contactNormal * c.tanPhi);
    if (s.contactShear != trial)
        events.sliding = lostEnergy(before, trial, s.contactShear, c.ks);
}

/// The same with options.
inline void stepContactWithOptions(PairState& s, const PairConstants& c, const PairMotion& m, PairEvents& events) {
    const ContactOptions& o = c.options;
    const NormalStep normal = stepNormal(hysteresis(c.kn, o.unloadingRatio), o.hertz, s.overlap, m.overlap, s.largest);
    const double ks0 = shearStiffness(c.ks, o.hertz, s.overlap), ks = shearStiffness(c.ks, o.hertz, m.overlap);
    const LimitedStep shear = stepLimited(s.contactShear, s.contactShear - ks * m.slip, normal.force * c.tanPhi,
                                          halfCompliance(ks0), halfCompliance(ks));
    s.contactNormal = normal.force;
    s.contactShear = shear.after;
    s.largest = normal.largest;
    events.sliding = normal.lost + shear.lost;
}

/// Rolling resistance of a pair without a bond, under the normal force that is there after the step.
inline void stepRolling(PairState& s, const PairConstants& c, const PairMotion& m, PairEvents& events) {
    const RollingResistance& r = c.options.rolling;
    const double k0 = r.stiffness * shearStiffness(c.ks, c.options.hertz, s.overlap);
    const double k = r.stiffness * shearStiffness(c.ks, c.options.hertz, m.overlap);
    const Vec3 trial = s.rolling + k * across(m.rotation, m.normal);
    const LimitedStep rolling =
        stepLimited(s.rolling, trial, r.arm * std::max(0.0, s.contactNormal), halfCompliance(k0), halfCompliance(k));
    s.rolling = rolling.after;
    events.sliding += rolling.lost;
}

/// One step of a pair that touches or is bonded.
inline PairEvents stepPair(PairState& s, const PairConstants& c, const BondStrength& strength, const PairMotion& m) {
    PairEvents events;
    carryAlong(s, c, m.normal, m.roll);
    if (s.bonded && c.kind == BondKind::Parallel)
        stepParallelBond(s, c, strength, m, events);
    if (s.bonded && c.kind == BondKind::Contact)
        stepContactBond(s, c, strength, m, events);
    else if (c.options.any())
        stepContactWithOptions(s, c, m, events);
    else
        stepContact(s, c, m, events);
    if (c.options.rolling.stiffness > 0 && !s.bonded)
        stepRolling(s, c, m, events);
    s.overlap = m.overlap;
    return events;
}

/// Force [N] on body 2.
inline Vec3 pairForce(const PairState& s, const Vec3& normal) {
    return (s.contactNormal + s.load.normal) * normal + (s.contactShear + s.load.shear);
}

/// Moment [N m] on body 2, besides that of the force.
inline Vec3 pairMoment(const PairState& s, const Vec3& normal) {
    return s.load.bending + s.load.twist * normal + s.rolling;
}

/// Normal force [N] of the contact at its present overlap.
inline double contactForce(const PairState& s, const PairConstants& c) {
    if (s.bonded && c.kind == BondKind::Contact)
        return c.kn * s.overlap;
    if (!c.options.any())
        return contactNormal(c.kn, s.overlap);
    return hystereticNormal(hysteresis(c.kn, c.options.unloadingRatio), s.overlap, s.largest) +
           hertzNormal(c.options.hertz, s.overlap);
}

/// Elastic energy [J] of the contact alone.
inline double contactEnergy(const PairState& s, const PairConstants& c) {
    const ContactOptions& o = c.options;
    if (!o.any() || (s.bonded && c.kind == BondKind::Contact))
        return springEnergy(s.contactNormal, c.kn) + springEnergy(s.contactShear.norm(), c.ks);
    const Hysteresis h = hysteresis(c.kn, o.unloadingRatio);
    const double ks = shearStiffness(c.ks, o.hertz, s.overlap);
    return springEnergy(hystereticNormal(h, s.overlap, s.largest), h.stiffness) + hertzEnergy(o.hertz, s.overlap) +
           springEnergy(s.contactShear.norm(), ks);
}

/// Elastic energy [J] of contact and bond.
inline double pairEnergy(const PairState& s, const PairConstants& c) {
    double sum = contactEnergy(s, c);
    if (c.options.rolling.stiffness > 0)
        sum += springEnergy(s.rolling.norm(),
                            c.options.rolling.stiffness * shearStiffness(c.ks, c.options.hertz, s.overlap));
    return s.bonded && c.kind == BondKind::Parallel ? sum + bondEnergy(s.load, c.bond) : sum;
}

/// Stiffnesses [N/m] along and across the normal that an increment meets at `overlap` [m]; the larger of loading and
/// unloading.
struct ContactTangents {
    double normal, shear;
};

inline ContactTangents contactTangents(const PairConstants& c, double overlap) {
    const ContactOptions& o = c.options;
    return {o.unloadingRatio * c.kn + 1.5 * o.hertz.normal * rootOverlap(overlap),
            shearStiffness(c.ks, o.hertz, overlap)};
}

}
