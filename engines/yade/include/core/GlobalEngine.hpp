#pragma once

#include <core/Engine.hpp>

namespace yade {

/// An engine that works on the whole scene.
class GlobalEngine : public Engine {
public:
    GlobalEngine() {}
    YADE_HOST_CLASS(GlobalEngine)
    YADE_HOST_ARCHIVE(Engine, )
};
YADE_HOST_KEY(GlobalEngine)

}
