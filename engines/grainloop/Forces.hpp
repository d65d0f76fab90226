// Forces and moments on elements, summed by each thread in memory of its own.
#pragma once

#include <vector>

#include <grainloop/Vectors.hpp>

namespace grus::grainloop {

/// One record of `stride` numbers an element, a cache line in space: force, then moment; in the plane fx, fy, mz.
class Forces {
public:
    static constexpr int stride(int dim) { return dim == 2 ? 4 : 8; }

    void resize(int dim, std::size_t elements, int threads);
    int threads() const { return static_cast<int>(part.size()); }
    double* data(int thread) { return part[thread].data(); }
    const double* data(int thread) const { return part[thread].data(); }

    /// Elements that a thread may have added to; it must zero them first.
    void clear(int thread, int begin, int end);

    Vec3 force(int element) const;
    Vec3 moment(int element) const;
    void add(int thread, int element, const Vec3& force, const Vec3& moment);

    struct Range {
        int begin = 0, end = 0;
    };
    std::vector<Range> range; ///< of each thread

private:
    int dim = 3;
    std::vector<Array<double>> part;
};

}
