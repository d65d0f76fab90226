#pragma once

#include <core/Shape.hpp>

namespace yade {

/// A cuboid with half sizes along the body's axes.
class Box : public Shape {
public:
    Vector3r extents;

    Box() { createIndex(); }
    YADE_HOST_CLASS(Box)
    YADE_HOST_INDEX(Box)
};

}
