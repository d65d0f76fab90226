// The kernels of GrainLoop on a square or cubic lattice of bonded elements, each a body of its own.
#include <cmath>

#include <benchmark/benchmark.h>

#include <grainloop/Assembly.hpp>

namespace {

using namespace grus;
using grainloop::Assembly;
using physics::Vec3;

constexpr double radius = 1e-3, stiffness = 1e8;

grainloop::PairKind bonded(int dim) {
    const auto section = dim == 2 ? physics::stripSection(radius, 1) : physics::roundSection(radius);
    return {{physics::BondKind::Parallel, stiffness, stiffness, 0.5,
             physics::bondStiffness(stiffness, stiffness, section), section, radius, 1},
            0,
            1,
            1};
}

Assembly lattice(int dim, int count) {
    Assembly a;
    a.dim = dim;
    const int side = static_cast<int>(std::round(std::pow(count, 1.0 / dim)));
    const int n = dim == 2 ? side * side : side * side * side;
    a.kinds = {bonded(dim), {{physics::BondKind::None, stiffness, stiffness, 0.5, {}, {}, 0, 1}}};
    a.pairKind = [](int, int) { return 1; };
    a.elements.resize(n);
    a.bodies.resize(n);
    a.bodies.place.resize(n);
    a.bodies.aspherical = n;
    for (int i = 0; i < n; ++i) {
        const Vec3 place = 2 * radius * Vec3(i % side, i / side % side, i / side / side);
        for (auto* v : {&a.elements.position, &a.bodies.position})
            v->set(i, place);
        for (auto* v : {&a.bodies.free, &a.bodies.freeTurn, &a.bodies.inertia})
            v->set(i, Vec3::Ones());
        const Vec3 velocity(1e-3 * std::sin(i), 1e-3 * std::cos(i), 0);
        a.bodies.velocity.set(i, velocity);
        a.elements.velocity.set(i, velocity);
        a.elements.radius[i] = radius;
        a.elements.body[i] = i;
        a.elements.mask[i] = 1;
        a.bodies.qw[i] = a.bodies.mass[i] = a.bodies.damped[i] = 1;
        a.bodies.begin.push_back(i);
    }
    a.bodies.begin.push_back(n);
    a.prepare(1);
    a.search(0.1 * radius);
    for (std::size_t k = 0; k < a.pairs.size(); ++k)
        a.pairs.kind[k] = 0;
    return a;
}

void forces(benchmark::State& state) {
    Assembly a = lattice(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    grainloop::Losses losses;
    for (auto _ : state)
        a.computeForces(1e-9, losses);
    state.counters["per bond"] =
        benchmark::Counter(static_cast<double>(a.pairs.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void motion(benchmark::State& state) {
    Assembly a = lattice(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
    grainloop::Losses losses;
    a.computeForces(1e-9, losses);
    for (auto _ : state)
        a.move({1e-9, 0.2, Vec3::Zero()}, losses);
    state.counters["per body"] =
        benchmark::Counter(static_cast<double>(a.bodies.size()),
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

BENCHMARK(forces)->ArgsProduct({{2, 3}, {1000, 50000}});
BENCHMARK(motion)->ArgsProduct({{2, 3}, {1000, 50000}});

}
