#pragma once

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

/// Outer limits of a body, for the collider.
class Bound : public Serializable, public Indexable {
public:
    int lastUpdateIter;
    Vector3r refPos;
    Real sweepLength;
    Vector3r color;
    Vector3r min;
    Vector3r max;

    YADE_HOST_CLASS(Bound)
    YADE_HOST_INDEX_ROOT(Bound)
};

}
