#pragma once

#include <cstddef>
#include <vector>

namespace yade {

/// Sums per thread; Grus only needs its place inside EnergyTracker.
template <class T> class OpenMPArrayAccumulator {
public:
    int CLS;
    std::size_t nThreads;
    int perCL;
    std::vector<T*> chunks;
    std::size_t sz;
    std::size_t nCL;
};

}
