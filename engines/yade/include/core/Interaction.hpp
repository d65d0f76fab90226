#pragma once

#include <lib/serialization/Serializable.hpp>

#include <core/Body.hpp>
#include <core/IGeom.hpp>
#include <core/IPhys.hpp>

namespace yade {

class IGeomFunctor;
class IPhysFunctor;
class LawFunctor;

/// A pair of bodies that touch (then it has geom and phys) or whose bounds overlap.
class Interaction : public Serializable {
public:
    bool isActive;
    struct {
        bool geomExists;
        boost::shared_ptr<IGeomFunctor> geom;
        boost::shared_ptr<IPhysFunctor> phys;
        boost::shared_ptr<LawFunctor> constLaw;
    } functorCache;
    Body::id_t id1;
    Body::id_t id2;
    long iterMadeReal;
    long iterLastSeen;
    boost::shared_ptr<IGeom> geom;
    boost::shared_ptr<IPhys> phys;
    Vector3i cellDist; // periods by which the second body is shifted
    int linIx;
    long iterBorn;

    Interaction();
    Interaction(Body::id_t id1, Body::id_t id2);
    YADE_HOST_CLASS(Interaction)
    boost::python::dict pyDictCustom() const override;

    bool isReal() const;
    /// True in the step in which the contact became real.
    bool isFresh(Scene*);
    const Body::id_t& getId1() const { return id1; }
    const Body::id_t& getId2() const { return id2; }
    void swapOrder();
    void reset();
    void init();
};

}
