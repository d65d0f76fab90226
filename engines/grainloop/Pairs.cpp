#include <grainloop/Pairs.hpp>

namespace grus::grainloop {

void Pairs::resize(std::size_t n) {
    for (auto* v : {&first, &second, &kind, &link})
        v->resize(n);
    for (Vectors* v : {&normal, &contactShear, &bondShear, &bending})
        v->resize(n);
    for (auto* v : {&twist, &overlap0, &tensile, &shear})
        v->resize(n);
    breakage.resize(n);
    lost.resize(n);
    if (!options)
        return;
    rolling.resize(n);
    lastOverlap.resize(n);
    largest.resize(n);
}

void Pairs::copy(std::size_t to, const Pairs& other, std::size_t from) {
    first[to] = other.first[from];
    second[to] = other.second[from];
    kind[to] = other.kind[from];
    normal.set(to, other.normal[from]);
    contactShear.set(to, other.contactShear[from]);
    bondShear.set(to, other.bondShear[from]);
    bending.set(to, other.bending[from]);
    twist[to] = other.twist[from];
    overlap0[to] = other.overlap0[from];
    tensile[to] = other.tensile[from];
    shear[to] = other.shear[from];
    link[to] = other.link[from];
    breakage[to] = other.breakage[from];
    lost[to] = other.lost[from];
    if (!options)
        return;
    rolling.set(to, other.rolling[from]);
    lastOverlap[to] = other.lastOverlap[from];
    largest[to] = other.largest[from];
}

void Pairs::clear(std::size_t to, int one, int two, int pairKind) {
    first[to] = one;
    second[to] = two;
    kind[to] = pairKind;
    for (Vectors* v : {&normal, &contactShear, &bondShear, &bending})
        v->set(to, Vec3::Zero());
    twist[to] = overlap0[to] = 0;
    tensile[to] = shear[to] = unbreakable;
    link[to] = -1;
    breakage[to] = lost[to] = 0;
    if (!options)
        return;
    rolling.set(to, Vec3::Zero());
    lastOverlap[to] = largest[to] = 0;
}

physics::PairState pairState(const Pairs& pairs, std::size_t k, const PairKind& kind, double overlap) {
    using physics::BondKind;
    const auto& c = kind.constants;
    physics::PairState s;
    s.bonded = c.kind != BondKind::None;
    s.contactShear = pairs.contactShear[k];
    s.load = {c.bond.normal * overlap, pairs.bondShear[k], pairs.bending[k], pairs.twist[k]};
    s.lastNormal = pairs.normal[k];
    s.overlap = overlap;
    if (pairs.options) {
        s.largest = pairs.largest[k];
        s.rolling = pairs.rolling[k];
    }
    s.contactNormal = physics::contactForce(s, c);
    return s;
}

}
