#pragma once

#include <core/TimeStepper.hpp>

namespace yade {

/// Critical time step from the stiffness of every contact and bond, loaded or not.
class BondTimeStepper : public TimeStepper {
public:
    virtual ~BondTimeStepper(){};
    virtual void computeTimeStep(Scene*) override;
    void postLoad(BondTimeStepper&);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BondTimeStepper, TimeStepper,
        "Sets the time step to a share of the critical one. Every contact and bond counts, also those without force, which :yref:`GlobalStiffnessTimeStepper` skips; members of a clump act on the clump. The critical step is a safe bound: it is reached by a pair of equal bodies and by a long chain. Only contacts with :yref:`BondPhys` are seen, each with the stiffness that an increment meets, of loading or unloading, whichever is larger; a Hertz contact counts with an overlap of at least a thousandth of the smaller radius.",
        ((Real, safety, 0.5, Attr::triggerPostLoad, "Share of the critical time step that is used, more than 0 and at most 1 [-]. The rest is room for contacts that form before the next update."))
        ((Real, maxDt, 1e-3, , "Largest time step, used when nothing touches [s]."))
        ((Real, criticalDt, 0, Attr::readonly, "Critical time step of the last update [s]."))
        , timeStepUpdateInterval = 100;
        , .def("critical", &BondTimeStepper::pyCritical, "Critical time step of the current scene now [s]; inf when nothing touches.")
    );
    // clang-format on

private:
    Real criticalStep(Scene*) const;
    Real pyCritical() const { return criticalStep(scene); }
};
REGISTER_SERIALIZABLE(BondTimeStepper);

}
