#pragma once

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

/// Physics of a contact: stiffnesses, strengths, forces.
class IPhys : public Serializable, public Indexable {
public:
    IPhys() {}
    YADE_HOST_CLASS(IPhys)
    YADE_HOST_INDEX_ROOT(IPhys)
    YADE_HOST_ARCHIVE(Serializable, )
};
YADE_HOST_KEY(IPhys)

}
