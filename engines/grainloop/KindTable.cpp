#include <grainloop/KindTable.hpp>

#include <grainloop/Numbering.hpp>

namespace grus::grainloop {

using physics::BondKind;

KindTable::KindTable(const std::vector<PairKind>& kinds) {
    Numbering<width> known;
    for (const PairKind& kind : kinds) {
        const auto& c = kind.constants;
        Numbering<width>::Row row{};
        row[Kn] = c.kn;
        row[Ks] = c.ks;
        row[HalfCompliance] = physics::halfCompliance(c.ks);
        row[TanPhi] = c.tanPhi;
        row[RimForce] = 1;
        row[BondTanPhi] = kind.bondTanPhi;
        row[Glued] = c.kind == BondKind::Contact;
        const physics::Hysteresis h = physics::hysteresis(c.kn, c.options.unloadingRatio);
        row[UnloadingKn] = h.stiffness;
        row[PlasticShare] = h.plasticShare;
        row[HertzNormal] = c.options.hertz.normal;
        row[HertzShear] = c.options.hertz.shear;
        row[Bonded] = c.kind != BondKind::None;
        if (c.kind == BondKind::None) {
            row[RollingStiffness] = c.options.rolling.stiffness;
            row[RollingArm] = c.options.rolling.arm;
        }
        if (c.kind == BondKind::Parallel) {
            row[BondKn] = c.bond.normal;
            row[BondKs] = c.bond.shear;
            row[BondKb] = c.bond.bending;
            row[BondKt] = c.bond.twist;
            const physics::RimFactors rim = physics::rimFactors(c.section, c.bondRadius, c.beta);
            row[RimForce] = rim.force;
            row[RimBending] = rim.bending;
            row[RimTwist] = rim.twist;
        }
        const auto [number, isNew] = known.number(row);
        if (isNew)
            numbers.insert(numbers.end(), row.begin(), row.end());
        rows.push_back(number);
        forgetful.push_back(c.kind == BondKind::None && kind.forgotten >= 0);
    }
}

}
