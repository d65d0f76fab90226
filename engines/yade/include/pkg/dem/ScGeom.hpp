#pragma once

#include <pkg/dem/DemXDofGeom.hpp>

namespace yade {

class Interaction;
class Scene;
class State;

/// Contact of two spheres with shear. radius1 and radius2 point into the same object: never copy a ScGeom.
class ScGeom : public GenericSpheresContact {
public:
    Vector3r twist_axis;
    Vector3r orthonormal_axis;
    Real& radius1;
    Real& radius2;
    Real penetrationDepth; // positive is overlap
    Vector3r shearInc;     // displacement of 2 relative to 1 in this step, across the normal

    ScGeom();
    YADE_HOST_CLASS(ScGeom)
    YADE_HOST_INDEX(ScGeom)
    void precompute(const State& state1, const State& state2, const Scene*, const boost::shared_ptr<Interaction>&,
                    const Vector3r& normal, bool isNew, const Vector3r& shift2, bool avoidGranularRatcheting);
    /// Turns a vector in place with the contact and returns it.
    Vector3r& rotate(Vector3r&) const;
    /// Velocity of 2 relative to 1 at the contact.
    Vector3r getIncidentVel(const State* state1, const State* state2, Real dt, const Vector3r& shift2,
                            const Vector3r& shiftVel, bool avoidGranularRatcheting) const;
    Vector3r getIncidentVel(const State* state1, const State* state2, Real dt, bool avoidGranularRatcheting) const;
    /// Angular velocity of 2 minus that of 1.
    Vector3r getRelAngVel(const State* state1, const State* state2, Real dt) const;
    const Vector3r& shearIncrement() const { return shearInc; }
    YADE_HOST_ARCHIVE(GenericSpheresContact, )
};
YADE_HOST_KEY(ScGeom)

/// The same with rotations since contact: of 1 relative to 2.
class ScGeom6D : public ScGeom {
public:
    Quaternionr initialOrientation1;
    Quaternionr initialOrientation2;
    Quaternionr twistCreep;
    Real twist;
    Vector3r bending;

    ScGeom6D();
    YADE_HOST_CLASS(ScGeom6D)
    YADE_HOST_INDEX(ScGeom6D)
    void precomputeRotations(const State& state1, const State& state2, bool isNew, bool creep);
    void initRotations(const State& state1, const State& state2);
    Real getTwist() const { return twist; }
    const Vector3r& getBending() const { return bending; }
    YADE_HOST_ARCHIVE(ScGeom, (initialOrientation1)(initialOrientation2)(twistCreep)(twist)(bending))
};
YADE_HOST_KEY(ScGeom6D)

}
