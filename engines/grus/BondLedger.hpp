#pragma once

#include <vector>

#include <core/GlobalEngine.hpp>

namespace yade {

/// Books what the bonded law dissipates: each breakage as an event, sliding and released energy as sums.
class BondLedger : public GlobalEngine {
public:
    struct Event {
        int id1, id2, mode;
        Real released;
        Vector3r position;
    };

    virtual ~BondLedger(){};
    virtual void action() override;
    void postLoad(BondLedger&);

    /// Called by the law from any thread of the interaction loop; nothing is shared between threads.
    void recordBreakage(const Event&);
    void recordSliding(Real work);

    // clang-format off
    YADE_CLASS_BASE_DOC_ATTRS_CTOR_PY(BondLedger, GlobalEngine,
        "Books what :yref:`Law2_ScGeom_BondPhys_Bonded` dissipates. Give it to the law (``ledger``) and put it after :yref:`InteractionLoop` in ``O.engines``. Lists have one entry per broken bond, in the order of steps and, within a step, of ids, whatever the number of threads.",
        ((std::vector<int>, brokenAtIter, , Attr::readonly, "Step of each breakage."))
        ((std::vector<Real>, brokenAtTime, , Attr::readonly, "DEM time of each breakage [s]."))
        ((std::vector<int>, brokenId1, , Attr::readonly, "Smaller id of each broken pair."))
        ((std::vector<int>, brokenId2, , Attr::readonly, "Larger id of each broken pair."))
        ((std::vector<int>, brokenMode, , Attr::readonly, "Mode of each breakage: 1 tension, 2 shear."))
        ((std::vector<Real>, brokenEnergy, , Attr::readonly, "Energy released by each breakage [J]."))
        ((std::vector<Vector3r>, brokenPosition, , Attr::readonly, "Place of each breakage [m]."))
        ((int, tensionBreaks, 0, Attr::readonly, "Number of bonds broken in tension."))
        ((int, shearBreaks, 0, Attr::readonly, "Number of bonds broken in shear."))
        ((Real, releasedEnergy, 0, Attr::readonly, "Elastic energy released by all broken bonds, and by cement that has corroded (:yref:`BondAgeing`) [J]."))
        ((Real, slidingWork, 0, Attr::readonly, "Work dissipated in contacts [J]: by sliding, and where contacts have them by rolling resistance and yielding asperities."))
        , makeSlots();
        , .add_property("breaks", &BondLedger::breaks, "Number of broken bonds.")
    );
    // clang-format on

    int breaks() const { return tensionBreaks + shearBreaks; }

private:
    /// One slot per thread, each on cache lines of its own.
    struct alignas(128) Slot {
        std::vector<Event> events;
        Real sliding = 0;
    };
    std::vector<Slot> slots;
    void makeSlots();
};
REGISTER_SERIALIZABLE(BondLedger);

}
