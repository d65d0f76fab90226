#pragma once

#include <core/Scene.hpp>

namespace yade {

/// What an engine with sub-steps of its own knows better than YADE's objects, which it updates only at the end of a
/// YADE step. The functions that measure a scene (kineticEnergy, contactStiffness, ...) ask it first, so that engines
/// which load a specimen need not know in what loop they run.
class LiveScene {
public:
    virtual ~LiveScene() {}
    virtual Real kineticEnergy() const = 0;            ///< [J]
    virtual Real elasticEnergy() const = 0;            ///< [J]
    virtual Real unbalancedForce() const = 0;          ///< [-]
    virtual Real contactStiffness(int wall) const = 0; ///< [N/m]

    /// The one of a scene; null when YADE's objects are up to date.
    static const LiveScene* of(const Scene&);

    /// Announces one while it lives.
    class Announcement {
    public:
        Announcement(const Scene&, const LiveScene&);
        ~Announcement();
        Announcement(const Announcement&) = delete;
    };
};

}
