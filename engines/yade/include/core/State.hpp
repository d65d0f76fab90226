#pragma once

#include <mutex>

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

/// Where a body is and how it moves. pos and ori point into the same object: never copy a State.
class State : public Serializable, public Indexable {
public:
    enum { DOF_NONE = 0, DOF_X = 1, DOF_Y = 2, DOF_Z = 4, DOF_RX = 8, DOF_RY = 16, DOF_RZ = 32, DOF_ALL = 63 };

    Vector3r& pos;
    Quaternionr& ori;
    std::mutex updateMutex;
    Se3r se3;
    Vector3r vel;
    Real mass;
    Vector3r angVel;
    Vector3r angMom;
    Vector3r inertia;
    Vector3r refPos;
    Quaternionr refOri;
    unsigned blockedDOFs;
    bool isDamped;
    Real densityScaling;

    State();
    YADE_HOST_CLASS(State)
    YADE_HOST_INDEX_ROOT(State)
    YADE_HOST_ARCHIVE(Serializable,
                      (se3)(vel)(mass)(angVel)(angMom)(inertia)(refPos)(refOri)(blockedDOFs)(isDamped)(densityScaling))
};
YADE_HOST_KEY(State)

}
