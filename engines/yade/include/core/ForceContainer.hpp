#pragma once

#include <mutex>
#include <vector>

#include <core/Body.hpp>
#include <lib/base/Math.hpp>

namespace yade {

/// O.forces: sums per thread, added up by sync(). Add only from the master or from one team of OpenMP threads.
class ForceContainer {
public:
    using vvector = std::vector<Vector3r>;

    std::vector<vvector> _forceData;
    std::vector<vvector> _torqueData;
    std::vector<Body::id_t> _maxId;
    std::vector<std::size_t> sizeOfThreads;
    vvector _force;
    vvector _torque;
    vvector _permForce;
    vvector _permTorque;
    std::size_t size;
    bool syncedSizes;
    int nThreads;
    bool permForceUsed;
    bool permForceSynced;
    std::mutex globalMutex;
    const Vector3r _zero;
    bool synced;
    unsigned long syncCount;
    long lastReset;

    ForceContainer();
    ~ForceContainer();
    /// Never inside a parallel region; needed before getForce and getTorque.
    void sync();
    const Vector3r& getForce(Body::id_t);
    const Vector3r& getTorque(Body::id_t);
    void addForce(Body::id_t, const Vector3r&);
    void addTorque(Body::id_t, const Vector3r&);
    /// Zeroes the totals, not what threads have added since the last sync.
    void reset(long iter, bool resetAll = false);
    /// Sums over threads without sync().
    const Vector3r getForceSingle(Body::id_t);
    const Vector3r getTorqueSingle(Body::id_t);
    void setPermForce(Body::id_t, const Vector3r&);
    void setPermTorque(Body::id_t, const Vector3r&);
    const Vector3r& getPermForce(Body::id_t);
    const Vector3r& getPermTorque(Body::id_t);
    int getNumAllocatedThreads() const;
    bool getPermForceUsed() const;
};

}
