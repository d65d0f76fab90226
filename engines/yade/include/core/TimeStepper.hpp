#pragma once

#include <core/GlobalEngine.hpp>

namespace yade {

/// Sets the scene's time step.
class TimeStepper : public GlobalEngine {
public:
    bool active;
    unsigned int timeStepUpdateInterval; // steps

    TimeStepper() : active(true), timeStepUpdateInterval(1) {}
    YADE_HOST_CLASS(TimeStepper)
    virtual void computeTimeStep(Scene*);
    bool isActivated() override;
    void action() override;
    YADE_HOST_ARCHIVE(GlobalEngine, (active)(timeStepUpdateInterval))
};
YADE_HOST_KEY(TimeStepper)

}
