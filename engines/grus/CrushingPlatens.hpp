#pragma once

#include <string>
#include <vector>

#include <core/GlobalEngine.hpp>

#include <grus/BondLedger.hpp>

namespace yade {

/// Crushes one grain between two rigid platens and finds its peak force.
class CrushingPlatens : public GlobalEngine {
public:
    virtual ~CrushingPlatens(){};
    virtual void action() override;
    void postLoad(CrushingPlatens&);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS(CrushingPlatens, GlobalEngine,
        "Moves two walls towards each other, each at half the closing speed, until the grain between them has crushed. Put it between :yref:`InteractionLoop` (and the ledger) and :yref:`NewtonIntegrator`. At the end the walls stop and the run is stopped. Forces are the mean of both platens, compression positive.",
        ((int, bottom, -1, , "Id of the lower platen, a fixed :yref:`Wall`."))
        ((int, top, -1, , "Id of the upper platen, a fixed :yref:`Wall`."))
        ((int, axis, 1, Attr::triggerPostLoad, "Axis of loading: 0, 1 or 2."))
        ((std::string, control, "speed", Attr::triggerPostLoad, "'speed': constant closing speed; 'force': servo on a force that grows at :yref:`CrushingPlatens.forceRate`."))
        ((Real, speed, 0, Attr::triggerPostLoad, "Closing speed [m/s], of both platens together; under force control its limit, never exceeded."))
        ((Real, forceRate, 0, Attr::triggerPostLoad, "Rate of the target force [N/s] under force control."))
        ((Real, relaxation, 0.1, Attr::triggerPostLoad, "Share of the force error that the servo removes in a step, more than 0 and at most 1 [-]."))
        ((Real, peakDrop, 0.5, Attr::triggerPostLoad, "The grain has crushed at the first drop of the force by this share of its running maximum, once a bond has broken, 0 to 1 [-]."))
        ((Real, endDrop, 0.9, Attr::triggerPostLoad, "The test ends when the force has dropped by this share of its running maximum, 0 to 1 [-]."))
        ((Real, maxStrain, 0.2, Attr::triggerPostLoad, "The test ends at this closing over the initial gap at the latest [-]."))
        ((Real, recordInterval, 1e-4, Attr::triggerPostLoad, "A record is taken each time the closing has grown by this share of the initial gap [-]."))
        ((boost::shared_ptr<BondLedger>, ledger, , , "Counts the broken bonds; without it no peak is found and no breakage recorded."))
        ((Real, initialGap, 0, Attr::readonly, "Distance of the platens at the first step [m]."))
        ((Real, closing, 0, Attr::readonly, "Closing since then [m]."))
        ((Real, force, 0, Attr::readonly, "Force now [N]."))
        ((Real, peakForce, 0, Attr::readonly, "Force before its first drop by :yref:`CrushingPlatens.peakDrop` [N]; 0 as long as there was none."))
        ((Real, peakClosing, 0, Attr::readonly, "Closing at that force [m]."))
        ((Real, maxForce, 0, Attr::readonly, "Largest force so far [N]."))
        ((Real, maxForceClosing, 0, Attr::readonly, "Closing at the largest force [m]."))
        ((Real, work, 0, Attr::readonly, "Work done by the platens [J]."))
        ((std::string, ended, "", Attr::readonly, "Why the test ended: 'crushed' or 'strain'; empty while it runs."))
        ((std::vector<Real>, recordTime, , Attr::readonly, "DEM time of each record [s]."))
        ((std::vector<Real>, recordClosing, , Attr::readonly, "Closing at each record [m]."))
        ((std::vector<Real>, recordForce, , Attr::readonly, "Force at each record [N]."))
        ((std::vector<int>, recordTension, , Attr::readonly, "Bonds broken in tension up to each record."))
        ((std::vector<int>, recordShear, , Attr::readonly, "Bonds broken in shear up to each record."))
        ((std::vector<Real>, recordWork, , Attr::readonly, "Work of the platens up to each record [J]."))
        ((std::vector<Real>, recordElastic, , Attr::readonly, "Elastic energy at each record [J]."))
        ((std::vector<Real>, recordKinetic, , Attr::readonly, "Kinetic energy at each record [J]."))
        ((std::vector<Real>, recordReleased, , Attr::readonly, "Energy released by broken bonds up to each record [J]."))
        ((std::vector<Real>, recordSliding, , Attr::readonly, "Work of friction up to each record [J]."))
        ((std::vector<Real>, recordDamped, , Attr::readonly, "Energy taken by damping up to each record [J]; needs ``O.trackEnergy``."))
        ((Real, startTime, -1, Attr::hidden, "DEM time of the first step [s]; negative before it."))
        ((Real, nextRecord, 0, Attr::hidden, "Closing at which the next record is due [m]."))
        ((Vector2r, lastPosition, Vector2r::Zero(), Attr::hidden, "Platen positions of the last step, bottom and top [m]."))
        ((Vector2r, lastForce, Vector2r::Zero(), Attr::hidden, "Forces on the platens in the last step along the axis, bottom and top [N]."))
    );
    // clang-format on

private:
    void begin();
    void measure();
    void findPeak();
    void drive();
    void record();
    void end(const std::string& why);
    Real platenStiffness() const;
};
REGISTER_SERIALIZABLE(CrushingPlatens);

}
