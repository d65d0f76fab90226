#include <grus/InteractionSorter.hpp>

#include <algorithm>

#include <core/Scene.hpp>

#include <grus/Ip2_BondMat_BondMat_BondPhys.hpp>
#include <grus/interactionOrder.hpp>

namespace yade {

namespace {

using List = InteractionContainer::ContainerT;

bool inOrder(const List::value_type& a, const List::value_type& b) { return earlier(*a, *b); }

/// End of the real ones in front that are in their order.
List::iterator endOfOrder(List& list) {
    auto end = list.begin();
    while (end != list.end() && (*end)->isReal() && (end == list.begin() || earlier(**(end - 1), **end)))
        ++end;
    return end;
}

}

void InteractionSorter::action() {
    // Looking at all interactions would take a seventh of a step.
    const History now{Ip2_BondMat_BondMat_BondPhys::made, scene->interactions->iterColliderLastRun,
                      scene->interactions->size()};
    if (now == seen)
        return;
    seen = now;
    auto& list = scene->interactions->linIntrs;
    const auto ordered = endOfOrder(list);
    const auto real = [](const auto& interaction) { return interaction->isReal(); };
    if (std::none_of(ordered, list.end(), real))
        return;
    const auto last = std::stable_partition(ordered, list.end(), real);
    std::sort(ordered, last, inOrder);
    std::inplace_merge(list.begin(), ordered, last, inOrder);
    for (std::size_t i = 0; i < list.size(); ++i)
        list[i]->linIx = static_cast<int>(i);
}

YADE_PLUGIN((InteractionSorter));

}
