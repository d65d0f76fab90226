#pragma once

#include <lib/serialization/Serializable.hpp>

#include <core/Timing.hpp>

namespace yade {

class Scene;
class TimingDeltas;

/// One entry of O.engines.
class Engine : public Serializable {
public:
    Scene* scene; // set before each isActivated() and action()
    TimingInfo timingInfo;
    boost::shared_ptr<TimingDeltas> timingDeltas;
    bool dead;
    int ompThreads;
    std::string label;

    Engine();
    YADE_HOST_CLASS(Engine)
    virtual bool isActivated();
    virtual void action();
    YADE_HOST_ARCHIVE(Serializable, (dead)(ompThreads)(label))
};
YADE_HOST_KEY(Engine)

}
