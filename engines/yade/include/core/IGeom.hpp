#pragma once

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

/// Geometry of a contact.
class IGeom : public Serializable, public Indexable {
public:
    IGeom() {}
    YADE_HOST_CLASS(IGeom)
    YADE_HOST_INDEX_ROOT(IGeom)
    YADE_HOST_ARCHIVE(Serializable, )
};
YADE_HOST_KEY(IGeom)

}
