#pragma once

#include <core/GlobalEngine.hpp>

namespace yade {

/// An engine that drives the boundary; its own action() throws.
class BoundaryController : public GlobalEngine {
public:
    BoundaryController() {}
    YADE_HOST_CLASS(BoundaryController)
    void action() override;
    YADE_HOST_ARCHIVE(GlobalEngine, )
};
YADE_HOST_KEY(BoundaryController)

}
