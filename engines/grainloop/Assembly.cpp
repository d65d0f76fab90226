#include <grainloop/Assembly.hpp>

#include <algorithm>
#include <cmath>

#include <omp.h>

#include <grainloop/neighbours.hpp>
#include <grainloop/pairKernel.hpp>
#include <grainloop/scatter.hpp>
#include <physics/kinematics.hpp>
#include <physics/motion.hpp>

namespace grus::grainloop {

using physics::BondKind;

void Assembly::prepare(int threads) {
    table = KindTable(kinds);
    forces.resize(dim, elements.size(), threads);
    shares.resize(threads);
    divide();
}

/// Every thread gets as many pairs as any other, and as many elements.
void Assembly::divide() {
    const int n = static_cast<int>(shares.size());
    for (int t = 0; t < n; ++t) {
        Share& s = shares[t];
        s.pairBegin = static_cast<int>(pairs.size() * t / n);
        s.pairEnd = static_cast<int>(pairs.size() * (t + 1) / n);
        const auto body = [&](int part) {
            const int element = static_cast<int>(elements.size() * part / n);
            return static_cast<int>(std::lower_bound(bodies.begin.begin(), bodies.begin.end() - 1, element) -
                                    bodies.begin.begin());
        };
        s.bodyBegin = body(t);
        s.bodyEnd = t + 1 < n ? body(t + 1) : static_cast<int>(bodies.size());
        s.elementBegin = static_cast<int>(elements.size());
        s.elementEnd = 0;
        for (int k = s.pairBegin; k < s.pairEnd; ++k) {
            s.elementBegin = std::min({s.elementBegin, pairs.first[k], pairs.second[k]});
            s.elementEnd = std::max({s.elementEnd, pairs.first[k] + 1, pairs.second[k] + 1});
        }
        if (t > 0)
            continue;
        for (const WallContact& c : wallContacts) { // the first thread does the walls
            s.elementBegin = std::min(s.elementBegin, c.element);
            s.elementEnd = std::max(s.elementEnd, c.element + 1);
        }
    }
}

void Assembly::search(double skin) {
    const auto close = neighbours(elements, skin);
    Pairs all;
    all.options = pairs.options;
    all.resize(close.size() + pairs.size());
    std::size_t n = 0, old = 0;
    const auto before = [&](const std::pair<int, int>& p) {
        return std::pair(std::min(pairs.first[old], pairs.second[old]), std::max(pairs.first[old], pairs.second[old])) <
               p;
    };
    // What is bonded or touches stays whatever its distance.
    const auto keepOld = [&] {
        if (real(old))
            all.copy(n++, pairs, old);
        ++old;
    };
    for (const auto& p : close) {
        while (old < pairs.size() && before(p))
            keepOld();
        const bool known = old < pairs.size() && std::minmax(pairs.first[old], pairs.second[old]) ==
                                                     std::pair<const int&, const int&>(p.first, p.second);
        if (known)
            all.copy(n++, pairs, old++);
        else
            all.clear(n++, p.first, p.second, pairKind(p.first, p.second));
    }
    while (old < pairs.size())
        keepOld();
    all.resize(n);
    std::swap(pairs, all);
    wallContacts = grainloop::wallContacts(walls, elements, skin, wallContacts, wallKind);
    searched = elements.position;
    searchedWalls.clear();
    for (const Wall& wall : walls)
        searchedWalls.push_back(wall.position);
    slack = halfSkin = skin / 2;
    table = KindTable(kinds);
    divide();
}

double Assembly::farthest() const {
    double square = 0;
    for (std::size_t i = 0; i < elements.size(); ++i)
        square = std::max(square, (elements.position[i] - searched[i]).squaredNorm());
    for (std::size_t w = 0; w < walls.size(); ++w)
        square = std::max(square, (walls[w].position - searchedWalls[w]).squaredNorm());
    return std::sqrt(square);
}

bool Assembly::stale() {
    if (slack > 0)
        return false;
    // The sum of all speeds has reached the limit; what counts is how far anything really is from where it was.
    slack = halfSkin - farthest();
    return slack < 0.05 * halfSkin;
}

double Assembly::overlap(std::size_t k) const {
    const int i = pairs.first[k], j = pairs.second[k];
    return elements.radius[i] + elements.radius[j] - (elements.position[j] - elements.position[i]).norm();
}

bool Assembly::real(std::size_t k) const {
    const double penetration = overlap(k);
    return !physics::apart(kinds[pairs.kind[k]].constants.kind != BondKind::None, penetration - pairs.overlap0[k],
                           penetration);
}

/// The scalar law, for a pair whose bond breaks or that comes apart and forgets its bond.
void Assembly::settle(int k, PairBlock& block, int slot, double dt, Share& share) {
    using namespace physics;
    const int i = pairs.first[k], j = pairs.second[k];
    const PairKind& kind = kinds[pairs.kind[k]];
    const Vec3 branch = elements.position[j] - elements.position[i];
    const double distance = branch.norm(), r1 = elements.radius[i], r2 = elements.radius[j];
    const double penetration = r1 + r2 - distance, overlap = penetration - pairs.overlap0[k];
    const auto set = [slot](PairBlock::Column& c, const Vec3& v) {
        c.x[slot] = v.x();
        c.y[slot] = v.y();
        c.z[slot] = v.z();
    };
    const Vec3 n = branch * (1 / distance), rate1 = elements.rate[i], rate2 = elements.rate[j];
    const PairMotion motion{overlap,
                            slip(elements.velocity[i], rate1, r1, elements.velocity[j], rate2, r2, distance, n, dt),
                            (rate1 - rate2) * dt, n, 0.5 * dt * n.dot(rate1 + rate2)};
    // The overlap before this step is not kept without options; where the two came from tells it.
    const double before =
        pairs.options ? pairs.lastOverlap[k]
                      : overlap + distance - (branch - dt * (elements.velocity[j] - elements.velocity[i])).norm();
    PairState s = pairState(pairs, k, kind, before);
    const PairEvents events = stepPair(s, kind.constants, {pairs.tensile[k], pairs.shear[k], kind.bondTanPhi}, motion);
    pairs.normal.set(k, n);
    pairs.contactShear.set(k, s.contactShear);
    pairs.bondShear.set(k, s.load.shear);
    pairs.bending.set(k, s.load.bending);
    pairs.twist[k] = s.load.twist;
    if (pairs.options) {
        pairs.rolling.set(k, s.rolling);
        pairs.lastOverlap[k] = s.overlap;
        pairs.largest[k] = s.largest;
    }
    if (events.breakage != Breakage::None) {
        pairs.breakage[k] = static_cast<std::int8_t>(events.breakage);
        pairs.kind[k] = kind.broken;
        pairs.tensile[k] = pairs.shear[k] = unbreakable;
        share.broken.push_back(
            {k, events.breakage, events.released, elements.position[i] + (r1 - 0.5 * penetration) * n});
    }
    share.sliding += events.sliding;
    if (apart(s.bonded, overlap, penetration)) {
        const int link = pairs.link[k];
        pairs.clear(k, i, j, kinds[pairs.kind[k]].forgotten);
        pairs.link[k] = link;
        pairs.lost[k] = 1;
        s = {};
    }
    const Vec3 force = pairForce(s, n), moment = pairMoment(s, n), turn = cross(n, force);
    set(block.force, force);
    set(block.moment1, -((r1 - 0.5 * penetration) * turn + moment));
    set(block.moment2, moment - (r2 - 0.5 * penetration) * turn);
}

void Assembly::stepShare(int t, double dt) {
    Share& share = shares[t];
    share.broken.clear();
    share.sliding = 0;
    forces.clear(t, share.elementBegin, std::max(share.elementBegin, share.elementEnd));
    PairBlock block;
    for (int begin = share.pairBegin; begin < share.pairEnd; begin += blockSize) {
        const int end = std::min(share.pairEnd, begin + blockSize);
        stepPairs(dim, elements, pairs, table, dt, begin, end, block);
        if (block.anyEvent)
            for (int s = 0; s < end - begin; ++s)
                if (block.event[s])
                    settle(begin + s, block, s, dt, share);
        share.sliding += block.slidingWork;
        scatter(dim, pairs, begin, end, block, forces.data(t));
    }
    if (t == 0)
        share.sliding += stepWalls(walls, wallContacts, kinds, elements, dt, forces, t);
}

void Assembly::computeForces(double dt, Losses& losses) {
    const int threads = static_cast<int>(shares.size());
#pragma omp parallel for schedule(static, 1) num_threads(threads) if (threads > 1)
    for (int t = 0; t < threads; ++t)
        stepShare(t, dt);
    broken.clear();
    for (const Share& s : shares) {
        losses.sliding += s.sliding;
        broken.insert(broken.end(), s.broken.begin(), s.broken.end());
    }
}

void Assembly::move(const Motion& motion, Losses& losses) {
    const int threads = static_cast<int>(shares.size());
#pragma omp parallel for schedule(static, 1) num_threads(threads) if (threads > 1)
    for (int t = 0; t < threads; ++t)
        shares[t].moved = moveBodies(dim, bodies, elements, forces, motion, shares[t].bodyBegin, shares[t].bodyEnd);
    double fastest = 0;
    for (const Share& s : shares) {
        losses.damped += s.moved.dampedEnergy;
        losses.gravity += s.moved.gravityWork;
        fastest = std::max(fastest, s.moved.fastestSquare);
    }
    for (Wall& wall : walls) {
        wall.position += motion.dt * wall.velocity;
        fastest = std::max(fastest, wall.velocity.squaredNorm());
    }
    slack -= std::sqrt(fastest) * motion.dt;
}

double Assembly::elasticEnergy() const {
    double sum = 0;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const PairKind& kind = kinds[pairs.kind[k]];
        sum += physics::pairEnergy(pairState(pairs, k, kind, overlap(k) - pairs.overlap0[k]), kind.constants);
    }
    for (const WallContact& c : wallContacts)
        sum += physics::pairEnergy(c.state, kinds[c.kind].constants);
    return sum;
}

double Assembly::kineticEnergy() const {
    double sum = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies.free[b].isZero() && bodies.freeTurn[b].isZero())
            continue;
        const physics::Quat q(bodies.qw[b], bodies.qx[b], bodies.qy[b], bodies.qz[b]);
        const Vec3 local = q.conjugate() * bodies.rate[b];
        sum += 0.5 *
               (bodies.mass[b] * bodies.velocity[b].squaredNorm() + local.dot(bodies.inertia[b].cwiseProduct(local)));
    }
    return sum;
}

double Assembly::unbalancedForce() const {
    double resultants = 0, contacts = 0;
    int moving = 0, count = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies.free[b].isZero() && bodies.freeTurn[b].isZero())
            continue;
        Vec3 force, moment;
        bodyLoad(bodies, elements, forces, static_cast<int>(b), force, moment);
        resultants += force.cwiseProduct(bodies.free[b]).norm();
        ++moving;
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (!real(k))
            continue;
        const auto s = pairState(pairs, k, kinds[pairs.kind[k]], overlap(k) - pairs.overlap0[k]);
        contacts += physics::pairForce(s, pairs.normal[k]).norm();
        ++count;
    }
    for (const WallContact& c : wallContacts)
        if (c.touches) {
            contacts += physics::pairForce(c.state, c.state.lastNormal).norm();
            ++count;
        }
    return contacts > 0 ? (resultants / moving) / (contacts / count) : 0;
}

double Assembly::contactStiffness(int wall) const {
    double sum = 0;
    for (const WallContact& c : wallContacts)
        if (c.wall == wall && c.touches)
            sum += physics::contactTangents(kinds[c.kind].constants, c.state.overlap).normal;
    return sum;
}

}
