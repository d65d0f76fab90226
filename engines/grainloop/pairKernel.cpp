#include <grainloop/pairKernel.hpp>

#include <algorithm>

#include <grainloop/Forces.hpp>
#include <grainloop/processor.hpp>
#include <physics/kinematics.hpp>

namespace grus::grainloop {

namespace {

using physics::BondKind;

enum Column {
    Kn,
    Ks,
    TanPhi,
    BondKn,
    BondKs,
    BondKb,
    BondKt,
    Area,
    Inertia,
    Polar,
    Radius,
    Beta,
    BondTanPhi,
    Kind,
    Tie
};

/// Plain pointers, which the compiler can tell apart.
struct View {
    Components<const double> position, velocity, rate;
    const double* __restrict__ radius;
    const int* __restrict__ first, * __restrict__ second, * __restrict__ kind;
    Components<const double> normal, contactShear, bondShear, bending;
    const double* __restrict__ twist, * __restrict__ overlap0, * __restrict__ tensile, * __restrict__ shear;
    const double* __restrict__ table;
};

template <int dim>
[[gnu::always_inline]] inline void step(const View& v, int k, int slot, int row, double dt, PairBlock& out) {
    using namespace physics;
    const int i = v.first[k], j = v.second[k];
    const PairConstants c{BondKind::None,
                          v.table[row + Kn],
                          v.table[row + Ks],
                          v.table[row + TanPhi],
                          {v.table[row + BondKn], v.table[row + BondKs], v.table[row + BondKb], v.table[row + BondKt]},
                          {v.table[row + Area], v.table[row + Inertia], v.table[row + Polar]},
                          v.table[row + Radius],
                          v.table[row + Beta]};
    const double contactBond = v.table[row + Kind], tie = v.table[row + Tie];

    const Vec3 branch = polar<dim>(v.position, j) - polar<dim>(v.position, i);
    const double distance = branch.norm(), r1 = v.radius[i], r2 = v.radius[j];
    const Vec3 n = branch * (1 / distance);
    const double penetration = r1 + r2 - distance, overlap = penetration - v.overlap0[k];
    const Vec3 rate1 = axial<dim>(v.rate, i), rate2 = axial<dim>(v.rate, j);
    const Vec3 slip =
        physics::slip(polar<dim>(v.velocity, i), rate1, r1, polar<dim>(v.velocity, j), rate2, r2, distance, n, dt);
    const double roll = 0.5 * dt * n.dot(rate1 + rate2);

    const Vec3 before = polar<dim>(v.normal, k);
    const Vec3 contact0 = polar<dim>(v.contactShear, k), shear0 = polar<dim>(v.bondShear, k);
    const Vec3 bending0 = axial<dim>(v.bending, k);
    const double twist0 = dim == 3 ? v.twist[k] : 0;
    const Vec3 contact1 = transportSmall(contact0, before, n, roll);

    BondLoad load{0, transportSmall(shear0, before, n, roll), transportSmall(bending0, before, n, roll), twist0};
    deform(load, c.bond, overlap, slip, (rate1 - rate2) * dt, n);
    const BondStress rim = rimStress(load, c.section, c.bondRadius, c.beta);

    const double pressed = contactNormal(c.kn, overlap);
    const Vec3 trial = contact1 - c.ks * slip;
    const Vec3 slid = slide(trial, pressed * c.tanPhi);
    const bool glued = contactBond > 0;
    const double normalForce = glued ? c.kn * overlap : pressed;
    const Vec3 contact2(glued ? trial.x() : slid.x(), glued ? trial.y() : slid.y(), glued ? trial.z() : slid.z());
    const double sliding = lostEnergy(contact1, trial, slid, c.ks);

    const double tension = glued ? -normalForce : rim.tension, mean = glued ? normalForce : rim.normal;
    const double across = glued ? trial.norm() : rim.shear;
    const bool breaks =
        (tension >= v.tensile[k]) | (across >= shearStrength({0, v.shear[k], v.table[row + BondTanPhi]}, mean));
    // A pair that once was bonded forgets it when it comes apart; for any other there is nothing to do then.
    const bool forgets = (tie < 0) & (overlap < 0) & (penetration < 0);
    const bool event = breaks | forgets;

    setPolar<dim>(components(out.normal), slot, n);
    setPolar<dim>(components(out.contactShear), slot, contact2);
    setPolar<dim>(components(out.bondShear), slot, load.shear);
    setAxial<dim>(components(out.bending), slot, load.bending);
    if (dim == 3)
        out.twist[slot] = load.twist;

    const Vec3 force = (normalForce + load.normal) * n + (contact2 + load.shear);
    const Vec3 moment = load.bending + load.twist * n;
    const Vec3 turn = cross(n, force);
    const Vec3 moment1 = -((r1 - 0.5 * penetration) * turn + moment);
    const Vec3 moment2 = moment - (r2 - 0.5 * penetration) * turn;
    const double work = glued | event ? 0 : sliding;
    setPolar<dim>(components(out.force), slot, force);
    setAxial<dim>(components(out.moment1), slot, moment1);
    setAxial<dim>(components(out.moment2), slot, moment2);
    out.sliding[slot] = work;
    out.event[slot] = event;
}

template <int dim, bool uniform>
[[gnu::always_inline]] inline void block(const View& v, double dt, int begin, int end, PairBlock& out) {
    const int row = v.kind[begin] * KindTable::width;
#pragma omp simd
    for (int k = begin; k < end; ++k)
        step<dim>(v, k, k - begin, uniform ? row : v.kind[k] * KindTable::width, dt, out);
}

#define GRUS_BLOCK(name, dim, uniform)                                                                                 \
    GRUS_FOR_EACH_PROCESSOR(name, (const View& v, double dt, int begin, int end, PairBlock& out),                      \
                            (block<dim, uniform>), (v, dt, begin, end, out))
GRUS_BLOCK(planeUniform, 2, true)
GRUS_BLOCK(planeMixed, 2, false)
GRUS_BLOCK(spaceUniform, 3, true)
GRUS_BLOCK(spaceMixed, 3, false)

}

KindTable::KindTable(const std::vector<PairKind>& kinds) : numbers(kinds.size() * width, 0.0) {
    for (std::size_t n = 0; n < kinds.size(); ++n) {
        const auto& c = kinds[n].constants;
        double* row = &numbers[n * width];
        row[Kn] = c.kn;
        row[Ks] = c.ks;
        row[TanPhi] = c.tanPhi;
        row[Area] = row[Inertia] = 1;
        row[BondTanPhi] = kinds[n].bondTanPhi;
        row[Kind] = c.kind == BondKind::Contact;
        row[Tie] = c.kind != BondKind::None ? 1 : kinds[n].forgotten >= 0 ? -1 : 0;
        if (c.kind != BondKind::Parallel)
            continue;
        row[BondKn] = c.bond.normal;
        row[BondKs] = c.bond.shear;
        row[BondKb] = c.bond.bending;
        row[BondKt] = c.bond.twist;
        row[Area] = c.section.area;
        row[Inertia] = c.section.inertia;
        row[Polar] = c.section.polar;
        row[Radius] = c.bondRadius;
        row[Beta] = c.beta;
    }
}

namespace {

template <int dim> [[gnu::always_inline]] inline void keep(Pairs& p, int begin, int end, const PairBlock& b) {
    const auto normal = components(p.normal), contact = components(p.contactShear), bond = components(p.bondShear),
               bending = components(p.bending);
    double* __restrict__ twist = p.twist.data();
    const int n = end - begin;
    const auto copy = [n, begin](double* __restrict__ to, const double* from, const int* event) {
        if (!event)
            std::copy(from, from + n, to + begin);
        else
            for (int s = 0; s < n; ++s)
                if (!event[s])
                    to[begin + s] = from[s];
    };
    const int* event = b.anyEvent ? b.event : nullptr;
    for (const auto& [to, from] :
         {std::pair{normal, &b.normal}, std::pair{contact, &b.contactShear}, std::pair{bond, &b.bondShear}}) {
        copy(to.x, from->x, event);
        copy(to.y, from->y, event);
        if (dim == 3)
            copy(to.z, from->z, event);
    }
    copy(bending.z, b.bending.z, event);
    if (dim == 3) {
        copy(bending.x, b.bending.x, event);
        copy(bending.y, b.bending.y, event);
        copy(twist, b.twist, event);
    }
}

void keepPlane(Pairs& p, int begin, int end, const PairBlock& b) { keep<2>(p, begin, end, b); }
void keepSpace(Pairs& p, int begin, int end, const PairBlock& b) { keep<3>(p, begin, end, b); }

}

void stepPairs(int dim, const Elements& e, Pairs& p, const KindTable& kinds, double dt, int begin, int end,
               PairBlock& out) {
    const Pairs& q = p;
    const View view{components(e.position),
                    components(e.velocity),
                    components(e.rate),
                    e.radius.data(),
                    q.first.data(),
                    q.second.data(),
                    q.kind.data(),
                    components(q.normal),
                    components(q.contactShear),
                    components(q.bondShear),
                    components(q.bending),
                    q.twist.data(),
                    q.overlap0.data(),
                    q.tensile.data(),
                    q.shear.data(),
                    kinds.row(0)};
    int different = 0;
    for (int k = begin; k < end; ++k)
        different |= p.kind[k] ^ p.kind[begin];
    if (dim == 2)
        (different ? planeMixed : planeUniform)(view, dt, begin, end, out);
    else
        (different ? spaceMixed : spaceUniform)(view, dt, begin, end, out);
    out.anyEvent = out.anySliding = 0;
    for (int s = 0; s < end - begin; ++s) {
        out.anyEvent |= out.event[s];
        out.anySliding |= out.sliding[s] != 0;
    }
    (dim == 2 ? keepPlane : keepSpace)(p, begin, end, out);
}

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
