#pragma once

#include <core/Functor.hpp>

namespace yade {

class Body;
class Bound;
class IGeom;
class Interaction;
class IPhys;
class Material;
class Shape;
class State;

/// Makes or updates the box around a body.
class BoundFunctor : public sdk::SingleFunctor<void, const boost::shared_ptr<Shape>&, boost::shared_ptr<Bound>&,
                                               const Se3r&, const Body*> {
public:
    BoundFunctor() {}
    YADE_HOST_CLASS(BoundFunctor)
    YADE_HOST_ARCHIVE(Functor, )
};
YADE_HOST_KEY(BoundFunctor)

/// Makes or updates the geometry of a contact: shapes, states, shift of the second (periodic cell), force, interaction.
class IGeomFunctor
    : public sdk::PairFunctor<bool, const boost::shared_ptr<Shape>&, const boost::shared_ptr<Shape>&, const State&,
                              const State&, const Vector3r&, const bool&, const boost::shared_ptr<Interaction>&> {
public:
    IGeomFunctor() {}
    YADE_HOST_CLASS(IGeomFunctor)
    virtual void preStep();
    YADE_HOST_ARCHIVE(Functor, )
};
YADE_HOST_KEY(IGeomFunctor)

/// Makes the physics of a contact; called at every step, also when interaction->phys exists.
class IPhysFunctor
    : public sdk::PairFunctor<void, const boost::shared_ptr<Material>&, const boost::shared_ptr<Material>&,
                              const boost::shared_ptr<Interaction>&> {
public:
    IPhysFunctor() {}
    YADE_HOST_CLASS(IPhysFunctor)
    YADE_HOST_ARCHIVE(Functor, )
};
YADE_HOST_KEY(IPhysFunctor)

/// The law of a contact; false resets the interaction. An exception here ends the process.
class LawFunctor : public sdk::PairFunctor<bool, boost::shared_ptr<IGeom>&, boost::shared_ptr<IPhys>&, Interaction*> {
public:
    LawFunctor() {}
    YADE_HOST_CLASS(LawFunctor)
    void applyForceAtContactPoint(const Vector3r& force, const Vector3r& contactPoint, const int id1,
                                  const Vector3r& pos1, const int id2, const Vector3r& pos2);
    YADE_HOST_ARCHIVE(Functor, )
};
YADE_HOST_KEY(LawFunctor)

}
