#pragma once

#include <pkg/common/NormShearPhys.hpp>

namespace yade {

/// A contact with friction.
class FrictPhys : public NormShearPhys {
public:
    Real tangensOfFrictionAngle;

    FrictPhys();
    YADE_HOST_CLASS(FrictPhys)
    YADE_HOST_INDEX(FrictPhys)
    YADE_HOST_ARCHIVE(NormShearPhys, (tangensOfFrictionAngle))
};
YADE_HOST_KEY(FrictPhys)

}
