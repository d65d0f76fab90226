#include <grainloop/scatter.hpp>

#include <grainloop/Forces.hpp>

namespace grus::grainloop {

namespace {

template <int dim> inline void scatterBlock(const Pairs& p, int begin, int end, const PairBlock& b, double* forces) {
    constexpr std::size_t stride = Forces::stride(dim);
    for (int k = begin, s = 0; k < end; ++k, ++s) {
        double* __restrict__ one = forces + p.first[k] * stride;
        double* __restrict__ two = forces + p.second[k] * stride;
        one[0] -= b.force.x[s];
        one[1] -= b.force.y[s];
        two[0] += b.force.x[s];
        two[1] += b.force.y[s];
        if (dim == 2) {
            one[2] += b.moment1.z[s];
            two[2] += b.moment2.z[s];
            continue;
        }
        one[2] -= b.force.z[s];
        two[2] += b.force.z[s];
        one[3] += b.moment1.x[s];
        one[4] += b.moment1.y[s];
        one[5] += b.moment1.z[s];
        two[3] += b.moment2.x[s];
        two[4] += b.moment2.y[s];
        two[5] += b.moment2.z[s];
    }
}

}

void scatter(int dim, const Pairs& pairs, int begin, int end, const PairBlock& block, double* forces) {
    (dim == 2 ? scatterBlock<2> : scatterBlock<3>)(pairs, begin, end, block, forces);
}

}
