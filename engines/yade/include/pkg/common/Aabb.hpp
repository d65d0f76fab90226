#pragma once

#include <core/Bound.hpp>

namespace yade {

/// Axis-aligned box around a body.
class Aabb : public Bound {
public:
    Aabb();
    YADE_HOST_CLASS(Aabb)
    YADE_HOST_INDEX(Aabb)
};

}
