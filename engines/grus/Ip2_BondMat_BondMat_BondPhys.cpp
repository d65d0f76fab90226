#include <grus/Ip2_BondMat_BondMat_BondPhys.hpp>

#include <limits>

#include <core/Body.hpp>
#include <core/Scene.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondState.hpp>
#include <physics/random.hpp>
#include <physics/strength.hpp>

namespace yade {

namespace {

namespace physics = grus::physics;

Real normalStiffness(const BondMat& m, Real radius) { return m.kn >= 0 ? m.kn : 2 * m.young * radius; }

Real shearStiffness(const BondMat& m, Real radius) { return m.ks >= 0 ? m.ks : m.poisson * normalStiffness(m, radius); }

/// The body of a Hertz contact; a linear material counts as rigid.
physics::ElasticSphere elasticSphere(const BondMat& m, Real radius) {
    return {m.hertz() ? m.young : std::numeric_limits<Real>::infinity(), m.hertz() ? m.poisson : 0, radius};
}

void setOptions(BondPhys& phys, const BondMat& a, Real radiusA, const BondMat& b, Real radiusB) {
    const auto rolling = physics::rollingResistance({a.rollingStiffness, a.rollingFriction, radiusA},
                                                    {b.rollingStiffness, b.rollingFriction, radiusB});
    phys.rollingStiffness = rolling.stiffness;
    phys.rollingArm = rolling.arm;
    if (!a.hertz() && !b.hertz()) {
        phys.unloadingRatio = std::max(a.unloadingRatio, b.unloadingRatio);
        return;
    }
    const auto hertz = physics::hertzStiffness(elasticSphere(a, radiusA), elasticSphere(b, radiusB));
    phys.hertzNormal = hertz.normal;
    phys.hertzShear = hertz.shear;
    phys.kn = phys.ks = 0; // of a contact that has just formed
}

const BondState* grainState(int id, Scene* scene) {
    return dynamic_cast<const BondState*>(Body::byId(id, scene)->state.get());
}

/// Random factor of the bond between two elements of one grain; the same whichever comes first.
Real strengthFactor(const BondMat& m, const BondState& one, const BondState& two, const Interaction& pair) {
    const std::uint64_t seed = m.seed, grain = one.grain;
    Real factor = 1;
    if (m.scatterKind() != physics::Scatter::None) {
        const int a = one.element >= 0 ? one.element : pair.id1, b = two.element >= 0 ? two.element : pair.id2;
        const Real u = physics::uniform(seed, physics::Draw::BondStrength, grain, std::min(a, b), std::max(a, b));
        factor = physics::scatterFactor(m.scatterKind(), m.scatterParameter, u);
    }
    if (m.grainModulus > 0) {
        const Real u = physics::uniform(seed, physics::Draw::GrainStrength, grain);
        factor *= physics::weibullFactor(u, m.grainModulus);
        if (m.grainReferenceDiameter > 0 && one.grainDiameter > 0)
            factor *= physics::sizeFactor(one.grainDiameter, m.grainReferenceDiameter, m.grainModulus,
                                          m.thickness > 0 ? 2 : 3);
    }
    return factor;
}

}

std::atomic<long> Ip2_BondMat_BondMat_BondPhys::made{0};

boost::shared_ptr<BondPhys> Ip2_BondMat_BondMat_BondPhys::contact(const BondMat& a, Real radiusA, const BondMat& b,
                                                                  Real radiusB) {
    boost::shared_ptr<BondPhys> phys(new BondPhys);
    phys->kn = physics::inSeries(normalStiffness(a, radiusA), normalStiffness(b, radiusB));
    phys->ks = physics::inSeries(shearStiffness(a, radiusA), shearStiffness(b, radiusB));
    phys->tangensOfFrictionAngle = std::tan(std::min(a.frictionAngle, b.frictionAngle));
    if (a.hasContactOptions() || b.hasContactOptions())
        setOptions(*phys, a, radiusA, b, radiusB);
    return phys;
}

void Ip2_BondMat_BondMat_BondPhys::go(const boost::shared_ptr<Material>& m1, const boost::shared_ptr<Material>& m2,
                                      const boost::shared_ptr<Interaction>& interaction) {
    if (interaction->phys)
        return;
    made.fetch_add(1, std::memory_order_relaxed);
    const auto& geom = *static_cast<ScGeom*>(interaction->geom.get());
    const auto& a = *static_cast<BondMat*>(m1.get());
    const auto& b = *static_cast<BondMat*>(m2.get());
    const auto phys = contact(a, geom.radius1, b, geom.radius2);
    interaction->phys = phys;
    if (bonding && m1 == m2)
        bond(*phys, a, *interaction);
}

void Ip2_BondMat_BondMat_BondPhys::bond(BondPhys& phys, const BondMat& m, const Interaction& interaction) const {
    const auto kind = m.bondKind();
    if (kind == BondMat::None)
        return;
    const BondState* one = grainState(interaction.id1, scene);
    const BondState* two = grainState(interaction.id2, scene);
    if (!one || !two || one->grain < 0 || one->grain != two->grain)
        return;
    const auto& geom = *static_cast<ScGeom*>(interaction.geom.get());
    const Real radius = std::min(geom.radius1, geom.radius2);
    if (geom.penetrationDepth < -tolerance * radius)
        return;

    phys.bonded = true;
    phys.bondKind = kind;
    phys.overlap0 = geom.penetrationDepth;
    phys.strengthFactor = strengthFactor(m, *one, *two, interaction);
    phys.tensileStrength = m.tensileStrength * phys.strengthFactor;
    phys.shearStrength = m.shearStrength * phys.strengthFactor;
    phys.bondTanPhi = std::tan(m.bondFrictionAngle);
    if (kind != BondMat::ParallelBond)
        return;

    phys.bondRadius = m.bondRadiusRatio * radius;
    const auto section = physics::bondSection(phys.bondRadius, m.thickness);
    phys.sectionArea = section.area;
    phys.sectionInertia = section.inertia;
    phys.sectionPolar = section.polar;
    const Real length = geom.radius1 + geom.radius2;
    phys.bondKn = physics::sectionStiffness(m.stiffnessKind(), m.bondKn, section.area, length);
    phys.bondKs = physics::sectionStiffness(m.stiffnessKind(), m.bondKs, section.area, length);
    phys.momentContribution = m.momentContribution;
}

YADE_PLUGIN((Ip2_BondMat_BondMat_BondPhys));

}
