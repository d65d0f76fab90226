#include <grus/InteractionSorter.hpp>

#include <algorithm>

#include <core/InteractionContainer.hpp>
#include <core/Scene.hpp>

namespace yade {

namespace {

std::pair<int, int> ids(const Interaction& interaction) { return std::minmax(interaction.id1, interaction.id2); }

}

void InteractionSorter::action() {
    auto& list = *scene->interactions;
    const auto inOrder = [](const auto& a, const auto& b) { return ids(*a) < ids(*b); };
    if (std::is_sorted(list.begin(), list.end(), inOrder))
        return;
    std::sort(list.begin(), list.end(), inOrder);
    for (std::size_t i = 0; i < list.size(); ++i)
        list[i]->linIx = static_cast<int>(i);
}

YADE_PLUGIN((InteractionSorter));

}
