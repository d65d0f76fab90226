#pragma once

#include <string>
#include <vector>

#include <core/GlobalEngine.hpp>

#include <grus/AgeingBond.hpp>
#include <grus/BondLedger.hpp>
#include <grus/OedometerServo.hpp>

namespace yade {

/// Static fatigue: lets bonds age on a laboratory clock of its own, while the specimen is at rest or slowly loaded.
class BondAgeing : public GlobalEngine {
public:
    virtual ~BondAgeing(){};
    virtual void action() override;
    void postLoad(BondAgeing&);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BondAgeing, GlobalEngine,
        "Static fatigue of bonds, on a laboratory clock apart from DEM time. In a :yref:`hold<BondAgeing.hold>` it waits until the specimen is at rest, lets the clock jump to the next failure of a bond, and waits again; while the specimen is loaded the clock may follow the stress. Put it last in ``O.engines``.",
        ((std::string, law, "power", Attr::triggerPostLoad, "How bonds age: 'power' (Charles 1958), which takes strength, 'corrosion' (Potyondy 2007), which takes the diameter of parallel bonds, or 'none': only the clock goes on."))
        ((Real, exponent, 0, Attr::triggerPostLoad, "Exponent n of the power law [-]."))
        ((Real, referenceTime, 0, Attr::triggerPostLoad, "Time t0 of the power law [s]: a bond under a small constant stress lasts t0/(n+1) (stress/strength)^-n."))
        ((Real, beta1, 0, Attr::triggerPostLoad, "Rate at which the diameter of an almost unloaded bond falls by stress corrosion [m/s]."))
        ((Real, beta2, 0, Attr::triggerPostLoad, "Growth of that rate with stress over strength [-]: the rate is beta1 exp(beta2 stress/strength)."))
        ((Real, threshold, 0, Attr::triggerPostLoad, "Stress below which a bond does not age [Pa, or N of contact bonds]. In compression none does."))
        ((std::string, drivenBy, "larger", Attr::triggerPostLoad, "Stress that ages a bond: 'larger', tension or shear beyond friction, whichever is the larger share of its strength, or 'tension', the peak tension alone (Potyondy 2007)."))
        ((Real, humidity, 1, Attr::triggerPostLoad, "Relative humidity, to which the rate is proportional, 0 to 1 [-]."))
        ((Real, largestShare, 0.05, Attr::triggerPostLoad, "Largest share of its first diameter that a bond loses by stress corrosion before the specimen is brought to rest again [-]."))
        ((Real, wetAt, -1, , "Reading of the clock at which the specimen is wetted [s], in a hold or while the clock follows the stress; negative: never, and so after it has been done. See :yref:`BondAgeing.wet`."))
        ((Real, wetFactor, 1, Attr::triggerPostLoad, "Factor on the strengths of all bonds then, more than 0 and at most 1 [-]."))
        ((Real, stressRate, 0, Attr::triggerPostLoad, "Rate of the axial stress in the laboratory while the specimen is loaded or unloaded, positive for both [Pa/s]; 0: the clock stands meanwhile. Needs :yref:`BondAgeing.servo`."))
        ((std::vector<Real>, scheduleStress, , , "Instead of a rate: axial stresses of the stage in the order in which they are passed, rising or falling [Pa]."))
        ((std::vector<Real>, scheduleClock, , , "Readings of the clock at these stresses, rising [s]; linear in between."))
        ((boost::shared_ptr<OedometerServo>, servo, , , "Keeps the stress and tells when the specimen is at rest; None: the unbalanced force tells it."))
        ((boost::shared_ptr<BondLedger>, ledger, , , "Counts the broken bonds and takes the energy that corroded cement releases. The one that the law has."))
        ((Real, unbalancedLimit, 1e-3, Attr::triggerPostLoad, "Without a servo: largest unbalanced force over mean contact force of a specimen at rest [-]."))
        ((int, quietSteps, 1000, Attr::triggerPostLoad, "Without a servo: steps in a row at rest and without a bond breaking that are waited for."))
        ((int, lookInterval, 100, Attr::triggerPostLoad, "Steps between two looks at the unbalanced force (without a servo), and between two ageings while the clock follows the stress."))
        ((int, recordsPerDecade, 10, Attr::triggerPostLoad, "Records in a decade of the time since a hold began, besides those at failures."))
        ((Real, firstRecord, 1, Attr::triggerPostLoad, "Time of the first of them [s]."))
        ((Real, clock, 0, , "Laboratory clock [s]."))
        ((Real, until, 0, Attr::readonly, "Reading of the clock at the end of the hold [s]."))
        ((bool, holding, false, Attr::readonly, "True from :yref:`BondAgeing.hold` to the end of the hold, when the run is stopped."))
        ((Real, softening, 1, Attr::readonly, "Product of all factors by which wetting has changed strengths [-]."))
        ((Real, releasedEnergy, 0, Attr::readonly, "Elastic energy released by corroded cement [J]; contained in that of the ledger."))
        ((std::vector<Real>, failureClock, , Attr::readonly, "Clock at each delayed failure, that is, one that ageing brought about [s]. Bonds that break because of it, at the same reading of the clock, are in the ledger alone."))
        ((std::vector<int>, failureId1, , Attr::readonly, "Smaller id of the pair."))
        ((std::vector<int>, failureId2, , Attr::readonly, "Larger id of the pair."))
        ((std::vector<int>, failureMode, , Attr::readonly, "Mode of failure: 1 tension, 2 shear."))
        ((std::vector<Vector3r>, failurePosition, , Attr::readonly, "Place of each bond that failed [m]."))
        ((std::vector<Real>, brokenAtClock, , Attr::readonly, "Clock at each breakage in the lists of the ledger, delayed or not [s]."))
        ((std::vector<Real>, recordClock, , Attr::readonly, "Clock at each record [s]. Records are of the specimen at rest: when a hold begins, at logarithmic times in it, after each failure, at its end; and of each failure while the clock follows the stress."))
        ((std::vector<Real>, recordHeight, , Attr::readonly, "Height of the specimen [m]; 0 without a servo."))
        ((std::vector<int>, recordStage, , Attr::readonly, "Stage of the servo; -1 without one."))
        ((std::vector<Real>, recordStress, , Attr::readonly, "Axial stress [Pa]; 0 without a servo, as the following."))
        ((std::vector<Real>, recordTop, , Attr::readonly, "Stress on the top platen [Pa]."))
        ((std::vector<Real>, recordBottom, , Attr::readonly, "Stress on the bottom platen [Pa]."))
        ((std::vector<Real>, recordSide, , Attr::readonly, "Mean normal stress on the side walls [Pa]."))
        ((std::vector<int>, recordFailures, , Attr::readonly, "Delayed failures so far."))
        ((std::vector<int>, recordBreaks, , Attr::readonly, "Broken bonds in the ledger so far."))
        ((Real, holdBegin, 0, Attr::hidden, "Clock at the beginning of the hold [s]."))
        ((int, timesRecorded, 0, Attr::hidden, "Logarithmic times of the hold that are recorded."))
        ((long, lastLook, 0, Attr::hidden, "Step of the last look."))
        ((long, unrest, 0, Attr::hidden, "Last step at which the specimen was not at rest."))
        ((int, lookBreaks, 0, Attr::hidden, "Broken bonds at the last look."))
        ((int, seenStage, -1, Attr::hidden, "Stage of the servo that the stress passed belongs to."))
        ((bool, rising, true, Attr::hidden, "Whether the stress rises in that stage."))
        ((Real, passed, 0, Attr::hidden, "Farthest axial stress in that stage [Pa]."))
        ((Real, due, 0, Attr::hidden, "Time on the clock by which the bonds have not aged yet [s]."))
        ,
        , .def("hold", &BondAgeing::hold, (boost::python::arg("duration")), "Begins a hold that lasts `duration` [s] of the clock; the run is stopped at its end. With a servo the specimen is held at its target: begin a stage before, or go on with the last.")
        .def("wet", &BondAgeing::wet, (boost::python::arg("factor")), "Multiplies both strengths of all bonds by `factor` and sets the humidity to 1. The bonds that cannot carry their load any more break in the next step.")
        .def("intactShares", &BondAgeing::intactShares, "What is left of each unbroken bond, sorted [-]: the distribution of ageing; see :yref:`BondPhys.intact`.")
        .add_property("failures", &BondAgeing::failures, "Number of delayed failures.")
    );
    // clang-format on

    void hold(Real duration);
    void wet(Real factor);
    std::vector<Real> intactShares() const;
    int failures() const { return static_cast<int>(failureClock.size()); }

private:
    /// What the clock goes to: its reading then, and the bond that it waits for (null: none) with what is left of it.
    struct Next {
        Real reading;
        const AgeingBond* bond;
        Real left;
    };

    AgeingLaw ageingLaw() const;
    std::vector<AgeingBond> bonds(const AgeingLaw&) const;
    bool age(const std::vector<AgeingBond>&, Real time, const Next&);
    void awaitRest(int expectedBreaks);
    void noteBreaks();
    void record(Real reading);

    // in a hold
    bool atRest();
    void jump();
    bool advance();
    void passTo(Real reading);

    // while the stress changes
    void followStress();
    Real readingAt(Real stress) const;
    void ageByDue();
    void wetWhenDue();
};
REGISTER_SERIALIZABLE(BondAgeing);

}
