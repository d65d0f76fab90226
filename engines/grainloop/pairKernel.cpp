#include <grainloop/pairKernel.hpp>

#include <algorithm>
#include <numeric>

#include <grainloop/pairMotion.hpp>
#include <grainloop/processor.hpp>

namespace grus::grainloop {

namespace {

/// Two rows of the table; copies, which the stores of a loop cannot change.
struct TwoRows {
    std::int64_t first;
    double one[KindTable::width], other[KindTable::width];
};

/// Plain pointers, which the compiler can tell apart.
struct View {
    Components<const double> normal, contactShear, bondShear, bending;
    const double* __restrict__ twist, * __restrict__ overlap0, * __restrict__ tensile, * __restrict__ shear;
    const double* __restrict__ table;
    // With options:
    Components<const double> rolling;
    const double* __restrict__ lastOverlap, * __restrict__ largest;
};

/// One step of pair `k`, which is number `s` of the block.
template <int dim, bool two, bool options>
[[gnu::always_inline]] inline void step(const View& v, std::int64_t k, std::int64_t s, const TwoRows& rows,
                                        PairBlock& out) {
    using namespace physics;
    using K = KindTable;
    const std::int64_t row = out.row[s];
    const bool isFirst = row == rows.first;
    const auto constant = [&](K::Column column) [[gnu::always_inline]] {
        return two ? (isFirst ? rows.one[column] : rows.other[column]) : v.table[row * K::width + column];
    };
    const bool glued = constant(K::Glued) > 0;

    const PairBlock& in = out;
    const Vec3 normal = polar<dim>(components(in.normal), s), slip = polar<dim>(components(in.slip), s);
    const double roll = dim == 3 ? in.roll[s] : 0, penetration = in.penetration[s];
    const double overlap = penetration - v.overlap0[k];

    const Vec3 before = polar<dim>(v.normal, k);
    const Vec3 contact0 = transportSmall(polar<dim>(v.contactShear, k), before, normal, roll);
    BondLoad load{0, transportSmall(polar<dim>(v.bondShear, k), before, normal, roll),
                  transportSmall(axial<dim>(v.bending, k), before, normal, roll), dim == 3 ? v.twist[k] : 0};
    deform(load, {constant(K::BondKn), constant(K::BondKs), constant(K::BondKb), constant(K::BondKt)}, overlap, slip,
           axial<dim>(components(in.rotation), s), normal);

    double pressed, lost; // normal force without tension; energy
    Vec3 trial, contact, rolling;
    if constexpr (options) {
        // stepContactWithOptions() and stepRolling() of the scalar law.
        const HertzStiffness hertz{constant(K::HertzNormal), constant(K::HertzShear)};
        const double last = v.lastOverlap[k], alpha = constant(K::RollingStiffness);
        const NormalStep along =
            stepNormal({constant(K::UnloadingKn), constant(K::PlasticShare)}, hertz, last, overlap, v.largest[k]);
        const double ks0 = shearStiffness(constant(K::Ks), hertz, last),
                     ks = shearStiffness(constant(K::Ks), hertz, overlap);
        pressed = along.force;
        trial = contact0 - ks * slip;
        const LimitedStep shear = stepLimited(contact0, trial, glued ? unbreakable : pressed * constant(K::TanPhi),
                                              halfCompliance(ks0), halfCompliance(ks));
        contact = shear.after;
        const Vec3 rolling0 = transportSmall(axial<dim>(v.rolling, k), before, normal, roll);
        const Vec3 turned = across(axial<dim>(components(in.rotation), s), normal);
        const LimitedStep rolled =
            stepLimited(rolling0, rolling0 + alpha * ks * turned, pressed * constant(K::RollingArm),
                        halfCompliance(alpha * ks0), halfCompliance(alpha * ks));
        rolling = rolled.after;
        lost = along.lost + shear.lost + rolled.lost;
        setAxial<dim>(components(out.rolling), s, rolling);
        out.overlap[s] = overlap;
        // What comes apart without a bond forgets.
        const bool apart = (overlap < 0) & (penetration < 0) & !(constant(K::Bonded) > 0);
        out.largest[s] = apart ? 0 : along.largest;
    } else {
        pressed = contactNormal(constant(K::Kn), overlap);
        trial = contact0 - constant(K::Ks) * slip;
        const double factor = slideFactor(trial.squaredNorm(), pressed * constant(K::TanPhi));
        contact = trial * (glued ? 1 : factor);
        lost = (contact0 + contact).dot(trial - contact) * constant(K::HalfCompliance);
    }
    const double normalForce = glued ? constant(K::Kn) * overlap : pressed;

    const BondLoad tested{
        glued ? normalForce : load.normal,
        {glued ? trial.x() : load.shear.x(), glued ? trial.y() : load.shear.y(), glued ? trial.z() : load.shear.z()},
        load.bending,
        load.twist};
    const bool breaks = mayFail(tested, {constant(K::RimForce), constant(K::RimBending), constant(K::RimTwist)},
                                {v.tensile[k], v.shear[k], constant(K::BondTanPhi)});
    // A pair that once was bonded forgets it when it comes apart; for any other there is nothing to do then.
    const bool forgets = (in.forgets[s] > 0) & (overlap < 0) & (penetration < 0);
    const bool event = breaks | forgets;

    setPolar<dim>(components(out.contactShear), s, contact);
    setPolar<dim>(components(out.bondShear), s, load.shear);
    setAxial<dim>(components(out.bending), s, load.bending);
    if (dim == 3)
        out.twist[s] = load.twist;

    const Vec3 force = (normalForce + load.normal) * normal + (contact + load.shear);
    Vec3 moment = load.bending + load.twist * normal;
    if constexpr (options)
        moment += rolling;
    const Vec3 turn = cross(normal, force);
    setPolar<dim>(components(out.force), s, force);
    setAxial<dim>(components(out.moment1), s, -(in.arm1[s] * turn + moment));
    setAxial<dim>(components(out.moment2), s, moment - in.arm2[s] * turn);
    out.sliding[s] = event ? 0 : lost;
    out.event[s] = event;
}

template <int dim, bool two, bool options>
[[gnu::always_inline]] inline void block(const View& v, int begin, int end, int firstRow, int secondRow,
                                         PairBlock& out) {
    TwoRows rows;
    rows.first = firstRow;
    for (int c = 0; c < (options ? KindTable::width : KindTable::plainWidth); ++c) {
        rows.one[c] = v.table[firstRow * KindTable::width + c];
        rows.other[c] = v.table[secondRow * KindTable::width + c];
    }
    const std::int64_t n = end - begin;
#pragma omp simd
    for (std::int64_t s = 0; s < n; ++s)
        step<dim, two, options>(v, begin + s, s, rows, out);
}

#define GRUS_BLOCK(name, dim, two, options)                                                                            \
    GRUS_FOR_EACH_PROCESSOR(name, (const View& v, int begin, int end, int firstRow, int secondRow, PairBlock& out),    \
                            (block<dim, two, options>), (v, begin, end, firstRow, secondRow, out))
GRUS_BLOCK(planeTwo, 2, true, false)
GRUS_BLOCK(planeMany, 2, false, false)
GRUS_BLOCK(spaceTwo, 3, true, false)
GRUS_BLOCK(spaceMany, 3, false, false)
GRUS_BLOCK(planeOptions, 2, false, true)
GRUS_BLOCK(spaceOptions, 3, false, true)

/// The rows of the table that a block needs.
struct Rows {
    int first, second;
    bool more; ///< than these two
};

Rows readKinds(const Pairs& p, const KindTable& kinds, int begin, int end, PairBlock& out) {
    const int n = end - begin;
    int different = 0;
    for (int k = begin; k < end; ++k)
        different |= p.kind[k] ^ p.kind[begin];
    const int first = kinds.rowOf(p.kind[begin]);
    Rows rows{first, first, false};
    if (!different) {
        std::fill(out.row, out.row + n, first);
        std::fill(out.forgets, out.forgets + n, kinds.forgets(p.kind[begin]));
        return rows;
    }
    for (int s = 0; s < n; ++s) {
        const int kind = p.kind[begin + s], row = kinds.rowOf(kind);
        out.row[s] = row;
        out.forgets[s] = kinds.forgets(kind);
        if (row != first && rows.second == first)
            rows.second = row;
        rows.more |= row != first && row != rows.second;
    }
    return rows;
}

template <int dim> [[gnu::always_inline]] inline void keep(Pairs& p, int begin, int end, const PairBlock& b) {
    const auto normal = components(p.normal), contact = components(p.contactShear), bond = components(p.bondShear),
               bending = components(p.bending);
    double* __restrict__ twist = p.twist.data();
    const int n = end - begin;
    const auto copy = [n, begin](double* __restrict__ to, const double* from, const std::int64_t* event) {
        if (!event)
            std::copy(from, from + n, to + begin);
        else
            for (int s = 0; s < n; ++s)
                if (!event[s])
                    to[begin + s] = from[s];
    };
    const std::int64_t* event = b.anyEvent ? b.event : nullptr;
    for (const auto& [to, from] :
         {std::pair{normal, &b.normal}, std::pair{contact, &b.contactShear}, std::pair{bond, &b.bondShear}}) {
        copy(to.x, from->x, event);
        copy(to.y, from->y, event);
        if (dim == 3)
            copy(to.z, from->z, event);
    }
    if (p.options) {
        const auto rolling = components(p.rolling);
        copy(p.lastOverlap.data(), b.overlap, event);
        copy(p.largest.data(), b.largest, event);
        copy(rolling.z, b.rolling.z, event);
        if (dim == 3) {
            copy(rolling.x, b.rolling.x, event);
            copy(rolling.y, b.rolling.y, event);
        }
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

/// Eight sums side by side, whatever the processor, so that all give the same bits.
void summarise(PairBlock& block, int n) {
    constexpr int lanes = 8;
    std::fill(block.sliding + n, block.sliding + PairBlock::size, 0.0);
    std::fill(block.event + n, block.event + PairBlock::size, 0);
    double work[lanes] = {};
    std::int64_t events[lanes] = {};
    for (int s = 0; s < n; s += lanes)
        for (int l = 0; l < lanes; ++l) {
            work[l] += block.sliding[s + l];
            events[l] |= block.event[s + l];
        }
    block.slidingWork = std::accumulate(work, work + lanes, 0.0);
    block.anyEvent = std::any_of(events, events + lanes, [](std::int64_t e) { return e != 0; });
}

}

void stepPairs(int dim, const Elements& e, Pairs& p, const KindTable& kinds, double dt, int begin, int end,
               PairBlock& out) {
    const Pairs& q = p;
    const View view{components(q.normal), components(q.contactShear), components(q.bondShear), components(q.bending),
                    q.twist.data(),       q.overlap0.data(),          q.tensile.data(),        q.shear.data(),
                    kinds.data(),         components(q.rolling),      q.lastOverlap.data(),    q.largest.data()};
    movePairs(dim, e, p, dt, begin, end, out);
    const Rows rows = readKinds(p, kinds, begin, end, out);
    const auto plane = p.options   ? planeOptions
                       : rows.more ? planeMany
                                   : planeTwo,
               space = p.options   ? spaceOptions
                       : rows.more ? spaceMany
                                   : spaceTwo;
    (dim == 2 ? plane : space)(view, begin, end, rows.first, rows.second, out);
    summarise(out, end - begin);
    (dim == 2 ? keepPlane : keepSpace)(p, begin, end, out);
}

}
