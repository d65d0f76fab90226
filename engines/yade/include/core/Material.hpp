#pragma once

#include <lib/multimethods/Indexable.hpp>
#include <lib/serialization/Serializable.hpp>

namespace yade {

class Scene;
class State;

/// What a body is made of.
class Material : public Serializable, public Indexable {
public:
    int id;
    std::string label;
    Real density;

    Material() : id(-1), density(1000) {}
    YADE_HOST_CLASS(Material)
    /// A state of the class that this material needs.
    virtual boost::shared_ptr<State> newAssocState() const;
    virtual bool stateTypeOk(State*) const;
    YADE_HOST_INDEX_ROOT(Material)
    YADE_HOST_ARCHIVE(Serializable, (id)(label)(density))
};
YADE_HOST_KEY(Material)

}
