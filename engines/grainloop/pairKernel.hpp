// Forces of all pairs in one vectorised pass.
#pragma once

#include <vector>

#include <grainloop/Elements.hpp>
#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

/// Pairs that are worked on at a time; what they pass on stays in the first cache.
constexpr int blockSize = 128;

/// The kinds as a table of numbers that the inner loop reads.
class KindTable {
public:
    static constexpr int width = 16;
    explicit KindTable(const std::vector<PairKind>& kinds = {});
    const double* row(int kind) const { return &numbers[std::size_t(kind) * width]; }

private:
    std::vector<double> numbers;
};

/// What a block of pairs hands on: force on the second element, moments on both, work of friction, and whether the pair
/// needs the scalar law because its bond breaks or it comes apart. Such a pair is left as it was.
struct PairBlock {
    struct Column {
        double x[blockSize], y[blockSize], z[blockSize];
    };
    Column normal, contactShear, bondShear, bending;
    double twist[blockSize];
    Column force, moment1, moment2;
    double sliding[blockSize];
    int event[blockSize];
    int anyEvent;
    int anySliding;
};

inline Components<double> components(PairBlock::Column& c) { return {c.x, c.y, c.z}; }

/// One step of pairs begin to end - 1, at most blockSize of them. In the plane (dim 2) the normals and forces have no
/// third component, the rotations and moments no other.
void stepPairs(int dim, const Elements& elements, Pairs& pairs, const KindTable& kinds, double dt, int begin, int end,
               PairBlock& out);

/// Adds forces and moments of a block to those of the elements; see Forces.
void scatter(int dim, const Pairs& pairs, int begin, int end, const PairBlock& block, double* forces);

}
