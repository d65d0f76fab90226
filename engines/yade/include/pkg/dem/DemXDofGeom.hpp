#pragma once

#include <core/IGeom.hpp>

namespace yade {

/// A contact of two spheres, or of a sphere with something else.
class GenericSpheresContact : public IGeom {
public:
    Vector3r normal; // from the first to the second body
    Vector3r contactPoint;
    Real refR1;
    Real refR2;

    GenericSpheresContact() : refR1(0), refR2(0) { createIndex(); }
    YADE_HOST_CLASS(GenericSpheresContact)
    YADE_HOST_INDEX(GenericSpheresContact)
    YADE_HOST_ARCHIVE(IGeom, (normal)(contactPoint)(refR1)(refR2))
};
YADE_HOST_KEY(GenericSpheresContact)

}
