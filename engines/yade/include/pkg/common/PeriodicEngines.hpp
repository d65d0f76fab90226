#pragma once

#include <chrono>

#include <core/GlobalEngine.hpp>

namespace yade {

/// An engine that runs each time a period has passed: of scene time, of real time, or of steps.
class PeriodicEngine : public GlobalEngine {
public:
    Real virtPeriod;
    Real realPeriod;
    long iterPeriod;
    long nDo;
    bool initRun;
    long firstIterRun;
    Real virtLast;
    Real realLast;
    long iterLast;
    long nDone;

    PeriodicEngine()
        : virtPeriod(0), realPeriod(0), iterPeriod(0), nDo(-1), initRun(false), firstIterRun(0), virtLast(0),
          realLast(getClock()), iterLast(0), nDone(0) {}
    YADE_HOST_CLASS(PeriodicEngine)
    bool isActivated() override;
    YADE_HOST_ARCHIVE(
        GlobalEngine,
        (virtPeriod)(realPeriod)(iterPeriod)(nDo)(initRun)(firstIterRun)(virtLast)(realLast)(iterLast)(nDone))

    /// Wall clock [s].
    static Real getClock() {
        using namespace std::chrono;
        return duration<Real>(system_clock::now().time_since_epoch()).count();
    }
};
YADE_HOST_KEY(PeriodicEngine)

}
