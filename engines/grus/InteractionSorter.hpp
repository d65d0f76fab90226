#pragma once

#include <cstddef>
#include <tuple>

#include <core/GlobalEngine.hpp>

namespace yade {

/// Keeps the real interactions in front, in the order of their bodies' ids.
class InteractionSorter : public GlobalEngine {
public:
    virtual ~InteractionSorter(){};
    virtual void action() override;

    // clang-format off
    YADE_CLASS_BASE_DOC(InteractionSorter, GlobalEngine,
        "Keeps the real interactions in front, in the order of their bodies' ids, whatever the order in which they were found; the others, which give no force, follow as they were. Put it between the collider and :yref:`InteractionLoop`: forces are then always added up in the same order, so that a scene that was saved and loaded goes on bit by bit (one thread). The loop then goes through memory about as the bonds were made. New contacts that :yref:`Ip2_BondMat_BondMat_BondPhys` makes are put in place in the next step, those of other functors when the collider has run."
    );
    // clang-format on

private:
    using History = std::tuple<long, long, std::size_t>; ///< contacts made, last step of the collider, interactions
    History seen{-1, -1, 0};
};
REGISTER_SERIALIZABLE(InteractionSorter);

}
