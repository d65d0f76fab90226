#include <grus/BondTimeStepper.hpp>

#include <limits>

#include <core/Body.hpp>
#include <core/Scene.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondMat.hpp>
#include <grus/BondPhys.hpp>
#include <grus/interactionOrder.hpp>
#include <grus/require.hpp>
#include <physics/timestep.hpp>

namespace yade {

namespace physics = grus::physics;

namespace {

/// The body whose motion an element follows: its clump or itself.
const Body& carrier(int id, Scene* scene) {
    const auto& body = Body::byId(id, scene);
    return body->clumpId >= 0 ? *Body::byId(body->clumpId, scene) : *body;
}

bool canMove(const Body& body) { return body.state->blockedDOFs != State::DOF_ALL && body.state->mass > 0; }

/// Overlap over the smaller radius with which a Hertz contact counts at least: it gets stiffer as it is pressed
/// together, and nothing says before the next look.
constexpr Real leastOverlap = 1e-3;

physics::ContactSprings springs(const BondPhys& phys, Real radius) {
    const auto contact = phys.tangents(leastOverlap * radius);
    physics::ContactSprings k{contact.normal, contact.shear, phys.rollingStiffness * contact.shear, 0};
    if (!phys.bonded || phys.bondKind != BondMat::ParallelBond)
        return k;
    const auto bond = phys.stiffness();
    return {k.normal + bond.normal, k.shear + bond.shear, k.bending + bond.bending, bond.twist};
}

}

Real BondTimeStepper::criticalStep(Scene* ncb) const {
    std::vector<physics::Mat6> stiffness(ncb->bodies->size(), physics::Mat6::Zero());
    for (const Interaction* interaction : realInOrder(*ncb->interactions)) {
        const auto* phys = dynamic_cast<const BondPhys*>(interaction->phys.get());
        const auto* geom = dynamic_cast<const ScGeom*>(interaction->geom.get());
        if (!phys || !geom)
            continue;
        const Body& one = carrier(interaction->id1, ncb);
        const Body& two = carrier(interaction->id2, ncb);
        const auto k = springs(*phys, std::min(geom->radius1, geom->radius2));
        const auto add = [&](const Body& body, const Vector3r& place, const Body& other) {
            if (canMove(body))
                physics::addSprings(stiffness[body.id], k, geom->contactPoint - place, geom->normal,
                                    canMove(other) ? 2 : 1);
        };
        const Vector3r shift =
            ncb->isPeriodic ? ncb->cell->intrShiftPos(interaction->cellDist) : Vector3r(Vector3r::Zero());
        add(one, one.state->pos, two);
        add(two, two.state->pos + shift, one);
    }
    Real smallest = std::numeric_limits<Real>::infinity();
    for (const auto& body : ncb->bodies->body) {
        if (!body || body->isClumpMember() || !canMove(*body))
            continue;
        const State& state = *body->state;
        const Matrix3r turn = state.ori.toRotationMatrix();
        const Matrix3r inertia = turn * state.inertia.asDiagonal() * turn.transpose();
        smallest =
            std::min(smallest, physics::criticalStep(stiffness[body->id], state.mass, inertia, state.blockedDOFs));
    }
    return smallest;
}

void BondTimeStepper::postLoad(BondTimeStepper&) {
    require(safety > 0 && safety <= 1, "BondTimeStepper.safety", safety, "more than 0, at most 1");
}

void BondTimeStepper::computeTimeStep(Scene* ncb) {
    criticalDt = criticalStep(ncb);
    ncb->dt = std::min(maxDt, safety * criticalDt);
}

YADE_PLUGIN((BondTimeStepper));

}
