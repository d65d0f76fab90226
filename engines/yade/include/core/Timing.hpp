#pragma once

namespace yade {

/// Number of runs of an engine and their time [ns].
class TimingInfo {
public:
    using delta = unsigned long long;
    long nExec;
    delta nsec;
    static bool enabled;

    TimingInfo() : nExec(0), nsec(0) {}
};

}
