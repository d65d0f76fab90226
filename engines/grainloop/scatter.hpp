// From pairs to elements.
#pragma once

#include <grainloop/PairBlock.hpp>
#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// Adds forces and moments of a block of pairs begin to end - 1 to those of the elements; see Forces.
void scatter(int dim, const Pairs& pairs, int begin, int end, const PairBlock& block, double* forces);

}
