#include <grainloop/Forces.hpp>

#include <algorithm>

namespace grus::grainloop {

void Forces::resize(int dimension, std::size_t elements, int threads) {
    dim = dimension;
    part.resize(threads);
    range.assign(threads, {});
    for (auto& p : part)
        p.resize(elements * stride(dim));
}

void Forces::clear(int thread, int begin, int end) {
    range[thread] = {begin, end};
    std::fill(part[thread].begin() + std::size_t(begin) * stride(dim),
              part[thread].begin() + std::size_t(end) * stride(dim), 0.0);
}

Vec3 Forces::force(int element) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t t = 0; t < part.size(); ++t)
        if (range[t].begin <= element && element < range[t].end) {
            const double* f = &part[t][std::size_t(element) * stride(dim)];
            sum += Vec3(f[0], f[1], dim == 2 ? 0 : f[2]);
        }
    return sum;
}

Vec3 Forces::moment(int element) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t t = 0; t < part.size(); ++t)
        if (range[t].begin <= element && element < range[t].end) {
            const double* f = &part[t][std::size_t(element) * stride(dim)];
            sum += dim == 2 ? Vec3(0, 0, f[2]) : Vec3(f[3], f[4], f[5]);
        }
    return sum;
}

void Forces::add(int thread, int element, const Vec3& force, const Vec3& moment) {
    double* f = &part[thread][std::size_t(element) * stride(dim)];
    if (dim == 2) {
        f[0] += force.x();
        f[1] += force.y();
        f[2] += moment.z();
        return;
    }
    for (int c = 0; c < 3; ++c) {
        f[c] += force[c];
        f[3 + c] += moment[c];
    }
}

}
