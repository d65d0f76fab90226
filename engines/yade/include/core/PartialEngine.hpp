#pragma once

#include <core/Engine.hpp>

namespace yade {

/// An engine that works on listed bodies.
class PartialEngine : public Engine {
public:
    std::vector<int> ids;

    PartialEngine() {}
    YADE_HOST_CLASS(PartialEngine)
    YADE_HOST_ARCHIVE(Engine, (ids))
};
YADE_HOST_KEY(PartialEngine)

}
