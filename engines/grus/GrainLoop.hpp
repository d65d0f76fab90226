#pragma once

#include <vector>

#include <core/GlobalEngine.hpp>

#include <grainloop/Assembly.hpp>
#include <grus/BondLedger.hpp>
#include <grus/BondPhys.hpp>
#include <grus/LiveScene.hpp>

namespace yade {

class BondMat;

/// Forces and motion of bonded grains over contiguous arrays, several sub-steps at a time.
class GrainLoop : public GlobalEngine, private LiveScene {
public:
    virtual ~GrainLoop(){};
    virtual void action() override;
    void postLoad(GrainLoop&);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS(GrainLoop, GlobalEngine,
        "Takes the place of :yref:`ForceResetter`, :yref:`InsertionSortCollider`, :yref:`InteractionLoop` and :yref:`NewtonIntegrator` in ``O.engines`` for spheres, rigid clumps of spheres and walls with :yref:`BondMat`. It computes the same forces and motions over contiguous arrays and hands everything back to ``O.bodies``, ``O.interactions`` and ``O.forces`` at the end of each YADE step.",
        ((int, substeps, 1, Attr::triggerPostLoad, "Steps of ``O.dt`` that are done in one YADE step, 1 or more; fewer when the step would pass a multiple of this number, so that engines with a period that is such a multiple act. ``O.iter`` and ``O.time`` count every one of them. Handing back costs as much as several steps: use 50 or more where nothing looks at the scene in between."))
        ((Real, damping, 0.2, Attr::triggerPostLoad, "Local damping: share of the force on each degree of freedom that acts against its motion, 0 to below 1 [-]. As :yref:`NewtonIntegrator.damping`."))
        ((Vector3r, gravity, Vector3r::Zero(), , "Acceleration of gravity [m/s2]."))
        ((Real, skin, 0, Attr::triggerPostLoad, "Gap up to which two elements are kept as a pair that may soon touch [m]; pairs are sought anew when an element may have moved by half of it. 0: a fifth of the smallest radius."))
        ((boost::shared_ptr<BondLedger>, ledger, , , "Where breakages, released energy and sliding work are booked; None: nowhere. It need not be in ``O.engines``."))
        ((std::vector<boost::shared_ptr<Engine>>, loading, , , "Engines that measure forces on walls and set the walls' velocities, such as :yref:`CrushingPlatens`: they run at each sub-step between forces and motion, and do not stand in ``O.engines``."))
        ((int, searches, 0, Attr::readonly, "How often pairs were sought so far."))
        ((int, pairs, 0, Attr::readonly, "Pairs of elements that are kept now: bonded, touching, or closer than :yref:`GrainLoop.skin`."))
    );
    // clang-format on

    Real kineticEnergy() const override { return assembly.kineticEnergy(); }
    Real elasticEnergy() const override { return assembly.elasticEnergy(); }
    Real unbalancedForce() const override { return assembly.unbalancedForce(); }
    Real contactStiffness(int wall) const override;

private:
    // scene to arrays
    void gather();
    void refuseEngines() const;
    void refuseForces() const;
    void gatherWalls();
    void gatherBodies();
    void gatherBody(int number, const Body&);
    void gatherPairs();
    bool anyContactOptions() const;
    int elementKind(const Body&, Real radius);
    int contactKind(int one, int two);
    int kindOf(const BondPhys&, int plain);
    int kindNumber(const grus::grainloop::PairKind&);

    // one sub-step
    void search();
    void load();
    void bookBreakage(const grus::grainloop::Losses&);
    void bookMotion(const grus::grainloop::Losses&);

    // arrays to scene
    void handBackInteractions();
    void handBackPair(std::size_t pair);
    void handBackWallContact(const grus::grainloop::WallContact&);
    void handBackBodies();
    void handBackForces();

    grus::grainloop::Assembly assembly;
    std::vector<int> elementId, wallId, bodyId;          // ids of the bodies behind the arrays' entries
    std::vector<int> elementOf, wallOf;                  // entries by id; -1: none
    std::vector<boost::shared_ptr<Interaction>> known;   // those that pairs link to
    std::vector<char> claimed;                           // known ones whose pairs still touch or hold
    using ElementKind = std::pair<const BondMat*, Real>; // material and radius
    std::vector<ElementKind> elementKinds;
    std::map<ElementKind, int> elementKindNumbers;
    std::map<std::pair<int, int>, int> contactKinds;
    std::map<std::vector<Real>, int> kindNumbers;
    int dampedIndex = -1, gravityIndex = -1;
};
REGISTER_SERIALIZABLE(GrainLoop);

}
