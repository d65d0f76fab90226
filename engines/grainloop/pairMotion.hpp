// How pairs have moved in a step.
#pragma once

#include <grainloop/Elements.hpp>
#include <grainloop/PairBlock.hpp>
#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// Normals, slips, rotations and overlaps of pairs begin to end - 1, at most blockSize of them.
void movePairs(int dim, const Elements& elements, const Pairs& pairs, double dt, int begin, int end, PairBlock& out);

}
