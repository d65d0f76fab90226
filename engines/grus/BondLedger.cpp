#include <grus/BondLedger.hpp>

#include <algorithm>
#include <tuple>

#include <omp.h>

#include <core/Scene.hpp>

namespace yade {

void BondLedger::makeSlots() { slots.resize(omp_get_max_threads()); }

void BondLedger::postLoad(BondLedger&) { makeSlots(); }

void BondLedger::recordBreakage(const Event& event) { slots[omp_get_thread_num()].events.push_back(event); }

void BondLedger::recordSliding(Real work) { slots[omp_get_thread_num()].sliding += work; }

void BondLedger::action() {
    std::vector<Event> events;
    for (Slot& slot : slots) {
        slidingWork += slot.sliding;
        slot.sliding = 0;
        events.insert(events.end(), slot.events.begin(), slot.events.end());
        slot.events.clear();
    }
    std::sort(events.begin(), events.end(),
              [](const Event& a, const Event& b) { return std::tie(a.id1, a.id2) < std::tie(b.id1, b.id2); });
    for (const Event& event : events) {
        brokenAtIter.push_back(static_cast<int>(scene->iter));
        brokenAtTime.push_back(scene->time);
        brokenId1.push_back(event.id1);
        brokenId2.push_back(event.id2);
        brokenMode.push_back(event.mode);
        brokenEnergy.push_back(event.released);
        brokenPosition.push_back(event.position);
        releasedEnergy += event.released;
        ++(event.mode == 1 ? tensionBreaks : shearBreaks);
    }
}

YADE_PLUGIN((BondLedger));

}
