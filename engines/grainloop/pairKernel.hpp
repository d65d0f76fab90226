// Forces of all pairs in vectorised passes.
#pragma once

#include <grainloop/Elements.hpp>
#include <grainloop/KindTable.hpp>
#include <grainloop/PairBlock.hpp>
#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// One step of pairs begin to end - 1, at most blockSize of them. In the plane (dim 2) the normals and forces have no
/// third component, the rotations and moments no other.
void stepPairs(int dim, const Elements& elements, Pairs& pairs, const KindTable& kinds, double dt, int begin, int end,
               PairBlock& out);

}
