#pragma once

#include <core/GlobalEngine.hpp>

namespace yade {

/// Keeps the interactions in the order of their bodies' ids.
class InteractionSorter : public GlobalEngine {
public:
    virtual ~InteractionSorter(){};
    virtual void action() override;

    // clang-format off
    YADE_CLASS_BASE_DOC(InteractionSorter, GlobalEngine,
        "Keeps the interactions in the order of their bodies' ids, whatever the order in which they were found. Put it between the collider and :yref:`InteractionLoop`: forces are then always added up in the same order, so that a scene that was saved and loaded goes on bit by bit (one thread). Bonds of neighbours also lie closer together in memory."
    );
    // clang-format on
};
REGISTER_SERIALIZABLE(InteractionSorter);

}
