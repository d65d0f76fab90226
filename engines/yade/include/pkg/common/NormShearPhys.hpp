#pragma once

#include <core/IPhys.hpp>

namespace yade {

/// Normal stiffness and force of a contact.
class NormPhys : public IPhys {
public:
    Real kn;
    Vector3r normalForce;

    NormPhys();
    YADE_HOST_CLASS(NormPhys)
    YADE_HOST_INDEX(NormPhys)
    YADE_HOST_ARCHIVE(IPhys, (kn)(normalForce))
};
YADE_HOST_KEY(NormPhys)

/// Normal and shear stiffness and force of a contact.
class NormShearPhys : public NormPhys {
public:
    Real ks;
    Vector3r shearForce;

    NormShearPhys();
    YADE_HOST_CLASS(NormShearPhys)
    YADE_HOST_INDEX(NormShearPhys)
    YADE_HOST_ARCHIVE(NormPhys, (ks)(shearForce))
};
YADE_HOST_KEY(NormShearPhys)

}
