#include <grus/InteractionSorter.hpp>

#include <algorithm>

#include <core/InteractionContainer.hpp>
#include <core/Scene.hpp>

namespace yade {

namespace {

std::pair<int, int> ids(const Interaction& interaction) { return std::minmax(interaction.id1, interaction.id2); }

}

void InteractionSorter::action() {
    auto& list = scene->interactions->linIntrs;
    const auto inOrder = [](const auto& a, const auto& b) { return ids(*a) < ids(*b); };
    const auto end = list.begin() + scene->interactions->currSize;
    if (std::is_sorted(list.begin(), end, inOrder))
        return;
    std::sort(list.begin(), end, inOrder);
    for (std::size_t i = 0; i < scene->interactions->currSize; ++i)
        list[i]->linIx = static_cast<int>(i);
}

YADE_PLUGIN((InteractionSorter));

}
