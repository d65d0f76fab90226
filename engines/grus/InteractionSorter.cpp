#include <grus/InteractionSorter.hpp>

#include <algorithm>

#include <core/Scene.hpp>

#include <grus/interactionOrder.hpp>

namespace yade {

void InteractionSorter::action() {
    auto& list = *scene->interactions;
    const auto inOrder = [](const auto& a, const auto& b) { return earlier(*a, *b); };
    if (std::is_sorted(list.begin(), list.end(), inOrder))
        return;
    std::sort(list.begin(), list.end(), inOrder);
    for (std::size_t i = 0; i < list.size(); ++i)
        list[i]->linIx = static_cast<int>(i);
}

YADE_PLUGIN((InteractionSorter));

}
