#pragma once

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

class BoundFunctor;
class InternalForceFunctor;

/// Form of a body.
class Shape : public Serializable, public Indexable {
public:
    boost::shared_ptr<BoundFunctor> boundFunctor;
    boost::shared_ptr<InternalForceFunctor> internalforcefunctor; // only in builds with deformable elements
    Vector3r color;
    bool wire;
    bool highlight;

    Shape() : color(Vector3r::Ones()), wire(false), highlight(false) {}
    YADE_HOST_CLASS(Shape)
    YADE_HOST_INDEX_ROOT(Shape)
};

}
