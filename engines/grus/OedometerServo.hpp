#pragma once

#include <string>
#include <vector>

#include <core/GlobalEngine.hpp>

#include <grus/BondLedger.hpp>
#include <physics/servo.hpp>

namespace yade {

/// Loads a specimen between two platens in a box with fixed sides, under stress control, one stage at a time.
class OedometerServo : public GlobalEngine {
public:
    virtual ~OedometerServo(){};
    virtual void action() override;
    void postLoad(OedometerServo&);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(OedometerServo, GlobalEngine,
        "Moves the platens of an oedometer so that the stress on each that moves goes to :yref:`OedometerServo.target`, and tells when the specimen is at rest there. Put it between :yref:`InteractionLoop` (and the ledger) and :yref:`NewtonIntegrator`. Compression is positive; strains and heights count from the first step.",
        ((int, bottom, -1, , "Id of the bottom platen, a fixed :yref:`Wall`."))
        ((int, top, -1, , "Id of the top platen, a fixed :yref:`Wall`."))
        ((std::vector<int>, sides, , , "Ids of the side walls."))
        ((int, axis, 1, Attr::triggerPostLoad, "Axis of loading: 0, 1 or 2."))
        ((Real, area, 0, Attr::triggerPostLoad, "Area of a platen inside the box [m2]; in the plane width times thickness."))
        ((Real, sideBreadth, 0, Attr::triggerPostLoad, "Breadth of the side walls [m]: their area is the mean breadth times the height; in the plane the thickness."))
        ((Real, solidVolume, 0, Attr::triggerPostLoad, "Volume of the solids [m3], by which void ratios are told."))
        ((std::string, moving, "both", Attr::triggerPostLoad, "Which platens move: 'both', or 'top' over a base that is fixed as the ring is; then the stress on the base is what friction on the sides leaves of it."))
        ((Real, target, 0, , "Axial stress to go to [Pa]."))
        ((Real, tolerance, 0.01, Attr::triggerPostLoad, "The stress on each platen that moves must stay this close to the target, as a share of it [-]."))
        ((Real, unbalancedLimit, 1e-3, Attr::triggerPostLoad, "Largest unbalanced force over mean contact force of a specimen at rest [-]."))
        ((int, quietSteps, 1000, Attr::triggerPostLoad, "Steps in a row at the target and at rest, without a bond breaking, after which a stage has ended."))
        ((int, quietStretches, 3, Attr::triggerPostLoad, "How many such stretches are waited for when a bond has broken in the stage; one is enough when none has."))
        ((Real, maxSpeed, 0.01, Attr::triggerPostLoad, "Largest speed of a platen [m/s]; never passed."))
        ((Real, fastSpeed, 0, Attr::triggerPostLoad, "Largest speed of a platen [m/s] while the test is quasi-static and no bond breaks; 0: as :yref:`OedometerServo.maxSpeed`, no adaptation."))
        ((Real, speedGrowth, 1.1, Attr::triggerPostLoad, "Factor by which the speed limit grows at each look towards :yref:`OedometerServo.fastSpeed` [-]."))
        ((Real, inertialLimit, 1e-3, , "Largest inertial number of a quasi-static test [-]."))
        ((Real, kineticLimit, 1e-3, , "Largest kinetic over elastic energy of a quasi-static test [-]."))
        ((Real, gradientLimit, 0.02, , "Largest difference of the platens' stresses over their mean in a quasi-static test [-]; not asked for when only the top moves, since friction on the sides makes a difference, too."))
        ((Real, relaxation, 0.05, Attr::triggerPostLoad, "Share of the stress error that is removed in a step against the contact stiffness of the platen, more than 0 and at most 1 [-]."))
        ((int, lookInterval, 100, Attr::triggerPostLoad, "Steps between two looks at unbalanced force, energies and the speed limit."))
        ((Real, recordStrain, 1e-4, Attr::triggerPostLoad, "A record is taken each time the strain has changed by this [-]."))
        ((Real, recordStress, 0.02, Attr::triggerPostLoad, "A record is taken each time the axial stress has changed by this share of itself [-]."))
        ((Real, grainDiameter, 0, , "Mean diameter of the grains [m], for the inertial number."))
        ((Real, grainDensity, 0, , "Density of the grains [kg/m3], for the inertial number."))
        ((boost::shared_ptr<BondLedger>, ledger, , , "Counts the broken bonds; without it breakage is neither seen nor recorded."))
        ((bool, done, false, Attr::readonly, "True when the stage has ended; the run is stopped then. See :yref:`OedometerServo.begin`."))
        ((Real, initialHeight, 0, Attr::readonly, "Distance of the platens at the first step [m]."))
        ((Real, height, 0, Attr::readonly, "Distance of the platens [m]."))
        ((Real, topStress, 0, Attr::readonly, "Stress on the top platen [Pa]."))
        ((Real, bottomStress, 0, Attr::readonly, "Stress on the bottom platen [Pa]."))
        ((Real, sideStress, 0, Attr::readonly, "Mean normal stress on the side walls [Pa]."))
        ((Real, unbalanced, 0, Attr::readonly, "Mean resultant force on the bodies over the mean contact force at the last look [-]."))
        ((Real, inertial, 0, Attr::readonly, "Inertial number at the last look [-]."))
        ((Real, kinetic, 0, Attr::readonly, "Kinetic energy at the last look [J]."))
        ((Real, speedLimit, 0, Attr::readonly, "Speed limit of the platens now [m/s]."))
        ((Real, work, 0, Attr::readonly, "Work done by the platens [J]."))
        ((std::vector<int>, recordIter, , Attr::readonly, "Step of each record."))
        ((std::vector<Real>, recordTime, , Attr::readonly, "DEM time [s]."))
        ((std::vector<int>, recordStage, , Attr::readonly, "Number of the stage, from 0."))
        ((std::vector<Real>, recordHeight, , Attr::readonly, "Height of the specimen [m]."))
        ((std::vector<Real>, recordTop, , Attr::readonly, "Stress on the top platen [Pa]."))
        ((std::vector<Real>, recordBottom, , Attr::readonly, "Stress on the bottom platen [Pa]."))
        ((std::vector<Real>, recordSide, , Attr::readonly, "Mean normal stress on the side walls [Pa]."))
        ((std::vector<int>, recordTension, , Attr::readonly, "Bonds broken in tension so far."))
        ((std::vector<int>, recordShear, , Attr::readonly, "Bonds broken in shear so far."))
        ((std::vector<Real>, recordUnbalanced, , Attr::readonly, "Unbalanced force ratio [-]."))
        ((std::vector<Real>, recordInertial, , Attr::readonly, "Inertial number [-]."))
        ((std::vector<Real>, recordSpeed, , Attr::readonly, "Speed limit [m/s]."))
        ((std::vector<Real>, recordWork, , Attr::readonly, "Work of the platens so far [J]."))
        ((std::vector<Real>, recordElastic, , Attr::readonly, "Elastic energy [J]."))
        ((std::vector<Real>, recordKinetic, , Attr::readonly, "Kinetic energy [J]."))
        ((std::vector<Real>, recordReleased, , Attr::readonly, "Energy released by broken bonds so far [J]."))
        ((std::vector<Real>, recordSliding, , Attr::readonly, "Work of friction so far [J]."))
        ((std::vector<Real>, recordDamped, , Attr::readonly, "Energy taken by damping so far [J]; needs ``O.trackEnergy``."))
        ((int, stage, -1, Attr::readonly, "Number of the stage, from 0; -1 before the first."))
        ((long, stopBefore, 0, Attr::hidden, "Step at which the run was to stop before the end of the stage stopped it."))
        ((long, stoppedAt, -1, Attr::hidden, "Step in which the end of the stage stopped it."))
        ((int, quiet, 0, Attr::hidden, "Steps at rest in a row."))
        ((int, stageBreaks, 0, Attr::hidden, "Broken bonds when the stage began."))
        ((int, quietBreaks, 0, Attr::hidden, "Broken bonds when the stretch of rest began."))
        ((int, lookBreaks, 0, Attr::hidden, "Broken bonds at the last look."))
        ((Real, lookHeight, 0, Attr::hidden, "Height at the last look [m]."))
        ((Real, lookTime, 0, Attr::hidden, "DEM time at the last look [s]."))
        ((Vector2r, lastPosition, Vector2r::Zero(), Attr::hidden, "Platen positions of the last step, bottom and top [m]."))
        ((Vector2r, lastForce, Vector2r::Zero(), Attr::hidden, "Forces on the platens in the last step along the axis, bottom and top [N]."))
        ,
        , .def("begin", &OedometerServo::begin, (boost::python::arg("target"), boost::python::arg("settled") = false), "Begins the next stage, which goes to the axial stress `target` [Pa]. `settled`: all :yref:`quiet stretches<OedometerServo.quietStretches>` are waited for even when no bond breaks, as before a hold.")
        .def("resume", &OedometerServo::resume, (boost::python::arg("breaks") = 0), "Goes on with a stage that has ended, as :yref:`BondAgeing` does, until the specimen is at rest again; the run is not stopped. `breaks` bonds are known to break at once: when no other does, one quiet stretch is enough.")
        .add_property("strain", &OedometerServo::strain, "Axial strain since the first step, compression positive [-].")
        .add_property("voidRatio", &OedometerServo::voidRatio, "Void ratio [-].")
        .add_property("K0", &OedometerServo::lateralRatio, "Side stress over mean axial stress [-].")
    );
    // clang-format on

    void begin(Real stress, bool settled);
    void resume(int expectedBreaks);
    Real strain() const { return initialHeight > 0 ? 1 - height / initialHeight : 0; }
    Real voidRatio() const { return area * height / solidVolume - 1; }
    /// Stress that goes to the target [Pa]: the mean of both platens, or that on the top when only it moves.
    Real axialStress() const { return controlled(topStress, bottomStress); }
    /// Axial stress at the first step of the stage [Pa].
    Real firstStress() const;
    Real lateralRatio() const {
        const Real mean = 0.5 * (topStress + bottomStress);
        return mean > 0 ? sideStress / mean : 0;
    }

private:
    bool baseFixed() const { return moving == "top"; }
    Real controlled(Real onTop, Real onBottom) const { return baseFixed() ? onTop : 0.5 * (onTop + onBottom); }
    void measure();
    void look();
    void drive();
    void watchRest();
    void awaitRest(int expectedBreaks);
    void record();
    bool recordDue() const;
    bool atTarget() const;
    int breaks() const { return ledger ? ledger->breaks() : 0; }
    Real speedOf(int id, Real stress) const;
};
REGISTER_SERIALIZABLE(OedometerServo);

}
