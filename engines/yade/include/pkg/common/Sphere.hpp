#pragma once

#include <core/Shape.hpp>

namespace yade {

/// A sphere about the body's position.
class Sphere : public Shape {
public:
    Real radius;

    Sphere();
    YADE_HOST_CLASS(Sphere)
    YADE_HOST_INDEX(Sphere)
};

}
