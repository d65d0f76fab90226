#pragma once

#include <algorithm>
#include <vector>

#include <core/Interaction.hpp>
#include <core/InteractionContainer.hpp>

namespace yade {

/// By smaller, then by larger id. O.interactions are in the order of their history, which goes another way after a
/// scene has been saved and loaded, since only the real ones are saved: sums that motion depends on must be taken in
/// this order.
inline bool earlier(const Interaction& a, const Interaction& b) {
    return std::minmax(a.id1, a.id2) < std::minmax(b.id1, b.id2);
}

/// The real ones of a container in this order.
inline std::vector<const Interaction*> realInOrder(const InteractionContainer& interactions) {
    std::vector<const Interaction*> real;
    for (const auto& interaction : interactions)
        if (interaction->isReal())
            real.push_back(interaction.get());
    std::sort(real.begin(), real.end(), [](const auto* a, const auto* b) { return earlier(*a, *b); });
    return real;
}

}
