// Which elements are close enough to touch soon.
#pragma once

#include <utility>
#include <vector>

#include <grainloop/Elements.hpp>

namespace grus::grainloop {

/// Pairs (i < j) of elements of different bodies, with a mask bit in common, whose surfaces are less than `gap` [m]
/// apart; in the order of i, then j.
std::vector<std::pair<int, int>> neighbours(const Elements& elements, double gap);

}
