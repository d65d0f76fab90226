#include <grainloop/pairMotion.hpp>

#include <grainloop/processor.hpp>
#include <physics/kinematics.hpp>

namespace grus::grainloop {

namespace {

/// Plain pointers, which the compiler can tell apart.
struct View {
    Components<const double> position, velocity, rate;
    const double* __restrict__ radius;
};

template <int dim>
[[gnu::always_inline]] inline void movePair(const View& v, std::int64_t s, double dt, PairBlock& out) {
    const std::int64_t i = out.first[s], j = out.second[s];
    const Vec3 branch = polar<dim>(v.position, j) - polar<dim>(v.position, i);
    const double distance = branch.norm(), r1 = v.radius[i], r2 = v.radius[j];
    const Vec3 normal = branch * (1 / distance), rate1 = axial<dim>(v.rate, i), rate2 = axial<dim>(v.rate, j);
    const double penetration = r1 + r2 - distance;
    setPolar<dim>(components(out.normal), s, normal);
    setPolar<dim>(components(out.slip), s,
                  physics::slip(polar<dim>(v.velocity, i), rate1, r1, polar<dim>(v.velocity, j), rate2, r2, distance,
                                normal, dt));
    setAxial<dim>(components(out.rotation), s, (rate1 - rate2) * dt);
    if (dim == 3)
        out.roll[s] = 0.5 * dt * normal.dot(rate1 + rate2);
    out.penetration[s] = penetration;
    out.arm1[s] = r1 - 0.5 * penetration;
    out.arm2[s] = r2 - 0.5 * penetration;
}

template <int dim>
[[gnu::always_inline]] inline void moveBlock(const View& v, double dt, std::int64_t n, PairBlock& out) {
#pragma omp simd
    for (std::int64_t s = 0; s < n; ++s)
        movePair<dim>(v, s, dt, out);
}

#define GRUS_MOTION(name, dim)                                                                                         \
    GRUS_FOR_EACH_PROCESSOR(name, (const View& v, double dt, std::int64_t n, PairBlock& out), moveBlock<dim>,          \
                            (v, dt, n, out))
GRUS_MOTION(movePlane, 2)
GRUS_MOTION(moveSpace, 3)

}

void movePairs(int dim, const Elements& e, const Pairs& p, double dt, int begin, int end, PairBlock& out) {
    for (int k = begin, s = 0; k < end; ++k, ++s) {
        out.first[s] = p.first[k];
        out.second[s] = p.second[k];
    }
    const View view{components(e.position), components(e.velocity), components(e.rate), e.radius.data()};
    (dim == 2 ? movePlane : moveSpace)(view, dt, end - begin, out);
}

}
