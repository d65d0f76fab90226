#pragma once

#include <core/Shape.hpp>

namespace yade {

/// An infinite plane across one axis.
class Wall : public Shape {
public:
    int sense; // side that makes contacts: -1 below, 1 above, 0 both
    int axis;  // 0, 1 or 2

    Wall() : sense(0), axis(0) { createIndex(); }
    YADE_HOST_CLASS(Wall)
    YADE_HOST_INDEX(Wall)
};

}
