#pragma once

#include <lib/serialization/Serializable.hpp>

#include <core/Bound.hpp>
#include <core/Material.hpp>
#include <core/Shape.hpp>
#include <core/State.hpp>

namespace yade {

class Interaction;
class Scene;

/// A particle, a wall, a clump, or a member of a clump.
class Body : public Serializable {
public:
    using id_t = int;
    using MapId2IntrT = std::map<id_t, boost::shared_ptr<Interaction>>;
    enum { FLAG_BOUNDED = 1, FLAG_ASPHERICAL = 2, FLAG_SUBDOMAIN = 4, FLAG_FLUIDDOMAINBBOX = 8 };
    static const id_t ID_NONE = -1;

    id_t id;
    int groupMask;
    int flags;
    int subdomain;
    boost::shared_ptr<Material> material;
    boost::shared_ptr<State> state;
    boost::shared_ptr<Shape> shape;
    boost::shared_ptr<Bound> bound;
    MapId2IntrT intrs; // by the other body's id; both bodies list an interaction
    id_t clumpId;
    long iterBorn;
    Real timeBorn;

    Body();
    YADE_HOST_CLASS(Body)
    virtual void userForcedDisplacementRedrawHook();

    /// No range check; the pointer is null after the body was erased.
    static const boost::shared_ptr<Body>& byId(id_t id, Scene* scene = nullptr);
    static const boost::shared_ptr<Body>& byId(id_t id, boost::shared_ptr<Scene> scene);
    id_t getId() const { return id; }
    bool isClump() const;
    bool isClumpMember() const;
    bool isStandalone() const;
    bool isDynamic() const;
    void setDynamic(bool);
    bool isBounded() const;
    void setBounded(bool);
    bool isAspherical() const;
    void setAspherical(bool);
    bool maskOk(int mask) const;
    bool maskCompatible(int mask) const;
    unsigned int coordNumber() const;
};

}
