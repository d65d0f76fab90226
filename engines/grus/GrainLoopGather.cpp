// GrainLoop: from YADE's objects to arrays.
#include <grus/GrainLoop.hpp>

#include <algorithm>
#include <stdexcept>

#include <omp.h>

#include <core/Body.hpp>
#include <core/Clump.hpp>
#include <core/Scene.hpp>
#include <pkg/common/Sphere.hpp>
#include <pkg/common/Wall.hpp>
#include <pkg/dem/ScGeom.hpp>

#include <grus/BondMat.hpp>
#include <grus/Ip2_BondMat_BondMat_BondPhys.hpp>

namespace yade {

namespace grainloop = grus::grainloop;
namespace physics = grus::physics;

namespace {

constexpr const char* instead = "use InteractionLoop and NewtonIntegrator instead";

constexpr const char* unbounded = "is not bounded, so that nothing should touch it; give it a mask of its own";

[[noreturn]] void refuse(const std::string& what) { throw std::runtime_error("GrainLoop: " + what); }

[[noreturn]] void refuseBody(const Body& body, const std::string& what) {
    refuse("body " + std::to_string(body.id) + " " + what + "; " + instead);
}

const BondMat& materialOf(const Body& body) {
    const auto* material = dynamic_cast<const BondMat*>(body.material.get());
    if (!material)
        refuseBody(body, "is of " + (body.material ? body.material->getClassName() : "no material") + ", not BondMat");
    return *material;
}

/// Whether all motion stays in a plane normal to z.
bool isPlane(const Scene& scene, const Vector3r& gravity) {
    constexpr unsigned out = State::DOF_Z | State::DOF_RX | State::DOF_RY;
    Real height = 0;
    bool first = true;
    for (const auto& body : scene.bodies->body) {
        if (!body || dynamic_cast<const Wall*>(body->shape.get())) {
            if (body && (static_cast<const Wall&>(*body->shape).axis == 2 || body->state->vel[2] != 0))
                return false;
            continue;
        }
        const State& state = *body->state;
        if (first)
            height = state.pos[2];
        first = false;
        if (state.pos[2] != height || state.vel[2] != 0 || state.angVel[0] != 0 || state.angVel[1] != 0)
            return false;
        if (body->isClumpMember())
            continue;
        if ((state.blockedDOFs & out) != out)
            return false;
        if (body->isClump() && (state.ori.x() != 0 || state.ori.y() != 0))
            return false;
    }
    return gravity[2] == 0;
}

}

void GrainLoop::gather() {
    refuseEngines();
    assembly.dim = isPlane(*scene, gravity) ? 2 : 3;
    assembly.kinds.clear();
    elementKinds.clear();
    elementKindNumbers.clear();
    contactKinds.clear();
    kindNumbers.clear();
    gatherWalls();
    gatherBodies();
    gatherPairs();
    assembly.pairKind = [this](int one, int two) {
        return contactKind(assembly.elements.kind[one], assembly.elements.kind[two]);
    };
    assembly.wallKind = [this](int wall, int element) {
        const Real radius = assembly.elements.radius[element]; // as YADE does, also for the wall
        const Body& body = *Body::byId(wallId[wall], scene);
        return contactKind(elementKind(body, radius), assembly.elements.kind[element]);
    };
    assembly.prepare(ompThreads > 0 ? std::min(ompThreads, omp_get_max_threads()) : omp_get_max_threads());
    search();
    if (scene->bodies->size() > 0) { // makes room for all bodies
        scene->forces.reset(scene->iter);
        scene->forces.addForce(static_cast<int>(scene->bodies->size()) - 1, Vector3r::Zero());
        scene->forces.addTorque(static_cast<int>(scene->bodies->size()) - 1, Vector3r::Zero());
        scene->forces.sync();
    }
}

void GrainLoop::refuseEngines() const {
    if (scene->isPeriodic)
        refuse(std::string("the scene is periodic; ") + instead);
    refuseForces();
    if (scene->forces.getPermForceUsed())
        refuse(std::string("a body has a permanent force; ") + instead);
    for (const auto& engine : scene->engines) {
        const std::string name = engine->getClassName();
        if (!engine->dead && (name == "InteractionLoop" || name == "NewtonIntegrator" || name == "ForceResetter" ||
                              name == "InsertionSortCollider"))
            refuse("it does the work of " + name + "; take that out of O.engines");
        if (!engine->dead && std::count(loading.begin(), loading.end(), engine))
            refuse(name + " is in GrainLoop.loading; take it out of O.engines");
    }
}

/// Those that were put on bodies since the last step: only the loop's own count.
void GrainLoop::refuseForces() const {
    auto& forces = scene->forces;
    if (forces.synced)
        return;
    forces.sync();
    for (const auto& body : scene->bodies->body)
        if (body && !(forces.getForce(body->id).isZero() && forces.getTorque(body->id).isZero()))
            refuseBody(*body, "has a force that an engine or a script put on it");
}

void GrainLoop::gatherWalls() {
    wallId.clear();
    wallOf.assign(scene->bodies->size(), -1);
    assembly.walls.clear();
    for (const auto& body : scene->bodies->body) {
        const auto* shape = body ? dynamic_cast<const Wall*>(body->shape.get()) : nullptr;
        if (!shape)
            continue;
        const State& state = *body->state;
        materialOf(*body);
        if (state.blockedDOFs != State::DOF_ALL || !state.angVel.isZero())
            refuseBody(*body, "is a wall that turns or moves by forces");
        if (!body->isBounded())
            refuseBody(*body, unbounded);
        wallOf[body->id] = static_cast<int>(wallId.size());
        wallId.push_back(body->id);
        grainloop::Wall wall;
        wall.axis = shape->axis;
        wall.sense = shape->sense;
        wall.mask = body->groupMask;
        wall.position = state.pos;
        wall.velocity = state.vel;
        assembly.walls.push_back(wall);
    }
}

void GrainLoop::gatherBodies() {
    struct Entry {
        bool aspherical;
        int first, id; // smallest element id, by which bodies are sorted, and the body's own
    };
    std::vector<Entry> order;
    constexpr unsigned turns = State::DOF_RX | State::DOF_RY | State::DOF_RZ;
    for (const auto& body : scene->bodies->body) {
        if (!body || body->isClumpMember() || wallOf[body->id] >= 0)
            continue;
        if (!body->shape)
            refuseBody(*body, "has no shape");
        const bool clump = body->isClump();
        if (!clump && !dynamic_cast<const Sphere*>(body->shape.get()))
            refuseBody(*body, "is a " + body->shape->getClassName() + "; GrainLoop moves spheres, clumps and walls");
        const auto* members = clump ? &static_cast<const Clump&>(*body->shape).members : nullptr;
        if (members && members->empty())
            continue;
        // As NewtonIntegrator does, which turns a body of which an axis is blocked as if it were a sphere.
        order.push_back({body->isAspherical() && !(body->state->blockedDOFs & turns),
                         clump ? members->begin()->first : body->id, body->id});
    }
    std::sort(order.begin(), order.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.aspherical, a.first) < std::tie(b.aspherical, b.first);
    });
    auto& bodies = assembly.bodies;
    bodies.resize(order.size());
    bodies.aspherical =
        static_cast<int>(std::count_if(order.begin(), order.end(), [](const Entry& e) { return !e.aspherical; }));
    bodies.begin.assign(1, 0);
    bodyId.clear();
    elementId.clear();
    elementOf.assign(scene->bodies->size(), -1);
    for (const Entry& entry : order) {
        const Body& body = *Body::byId(entry.id, scene);
        bodyId.push_back(entry.id);
        if (body.isClump())
            for (const auto& [member, place] : static_cast<const Clump&>(*body.shape).members)
                elementId.push_back(member);
        else
            elementId.push_back(entry.id);
        bodies.begin.push_back(static_cast<int>(elementId.size()));
    }
    bodies.place.resize(elementId.size());
    assembly.elements.resize(elementId.size());
    for (std::size_t b = 0; b < order.size(); ++b)
        gatherBody(static_cast<int>(b), *Body::byId(order[b].id, scene));
}

void GrainLoop::gatherBody(int b, const Body& body) {
    auto& bodies = assembly.bodies;
    auto& elements = assembly.elements;
    const State& state = *body.state;
    bodies.position.set(b, state.pos);
    bodies.velocity.set(b, state.vel);
    bodies.rate.set(b, state.angVel);
    bodies.momentum.set(b, state.angMom);
    bodies.qw[b] = state.ori.w();
    bodies.qx[b] = state.ori.x();
    bodies.qy[b] = state.ori.y();
    bodies.qz[b] = state.ori.z();
    Vector3r inertia = state.inertia, free, freeTurn;
    for (int c = 0; c < 3; ++c) {
        free[c] = state.blockedDOFs & (1u << c) ? 0 : 1;
        freeTurn[c] = state.blockedDOFs & (8u << c) ? 0 : 1;
        if (freeTurn[c] == 0 && inertia[c] <= 0)
            inertia[c] = 1; // divided by, and then not used
    }
    if (!free.isZero() && !(state.mass > 0))
        refuseBody(body, "can move but has no mass");
    if (((freeTurn.array() > 0) && !(inertia.array() > 0)).any())
        refuseBody(body, "can turn but has no inertia");
    bodies.mass[b] = state.mass > 0 ? state.mass : 1;
    bodies.inertia.set(b, inertia);
    bodies.free.set(b, free);
    bodies.freeTurn.set(b, freeTurn);
    bodies.damped[b] = state.isDamped && state.blockedDOFs != State::DOF_ALL;
    bodies.reach[b] = 0;
    for (int i = bodies.begin[b]; i < bodies.begin[b + 1]; ++i) {
        const int id = elementId[i];
        const Body& member = *Body::byId(id, scene);
        const auto* sphere = dynamic_cast<const Sphere*>(member.shape.get());
        if (!member.isBounded())
            refuseBody(member, unbounded);
        if (!sphere)
            refuseBody(member, "in a clump is a " + member.shape->getClassName() + ", not a Sphere");
        elementOf[id] = i;
        elements.position.set(i, member.state->pos);
        elements.velocity.set(i, member.state->vel);
        elements.rate.set(i, member.state->angVel);
        elements.radius[i] = sphere->radius;
        elements.body[i] = b;
        elements.kind[i] = elementKind(member, sphere->radius);
        elements.mask[i] = member.groupMask;
        const Vector3r place = body.isClump() ? static_cast<const Clump&>(*body.shape).members.at(id).position
                                              : Vector3r(Vector3r::Zero());
        bodies.place.set(i, place);
        bodies.reach[b] = std::max(bodies.reach[b], place.norm());
    }
}

void GrainLoop::gatherPairs() {
    auto& pairs = assembly.pairs;
    known.clear();
    std::vector<std::pair<std::pair<int, int>, int>> order;   // elements, smaller first, and link
    std::vector<std::pair<std::pair<int, int>, int>> onWalls; // wall, element and link
    for (const auto& interaction : *scene->interactions) {
        if (!interaction->isReal())
            continue;
        const int link = static_cast<int>(known.size());
        const int id1 = interaction->id1, id2 = interaction->id2;
        if (!dynamic_cast<const ScGeom*>(interaction->geom.get()) ||
            !dynamic_cast<const BondPhys*>(interaction->phys.get()))
            refuse("interaction " + std::to_string(id1) + "-" + std::to_string(id2) + " has " +
                   interaction->geom->getClassName() + " and " + interaction->phys->getClassName() +
                   ", not ScGeom and BondPhys; " + instead);
        if (wallOf[id1] >= 0)
            onWalls.push_back({{wallOf[id1], elementOf[id2]}, link});
        else if (elementOf[id1] >= 0 && elementOf[id2] >= 0)
            order.push_back({std::minmax(elementOf[id1], elementOf[id2]), link});
        else
            refuse("interaction " + std::to_string(id1) + "-" + std::to_string(id2) +
                   " is not between a wall or an element and an element; " + instead);
        known.push_back(interaction);
    }
    std::sort(order.begin(), order.end());
    std::sort(onWalls.begin(), onWalls.end());
    pairs.options = anyContactOptions();
    pairs.resize(order.size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const int link = order[k].second;
        const auto& phys = static_cast<const BondPhys&>(*known[link]->phys);
        const int one = elementOf[known[link]->id1], two = elementOf[known[link]->id2];
        const auto& kind = assembly.elements.kind;
        pairs.clear(k, one, two, kindOf(phys, contactKind(kind[one], kind[two])));
        pairs.link[k] = link;
        pairs.breakage[k] = static_cast<std::int8_t>(phys.breakage);
        pairs.normal.set(k, phys.lastNormal);
        pairs.contactShear.set(k, phys.contactShear);
        pairs.bondShear.set(k, phys.bondShear);
        pairs.bending.set(k, phys.bondBending);
        pairs.twist[k] = phys.bondTwist;
        pairs.overlap0[k] = phys.overlap0;
        if (pairs.options) {
            pairs.rolling.set(k, phys.rollingMoment);
            pairs.lastOverlap[k] = phys.lastOverlap;
            pairs.largest[k] = phys.largestOverlap;
        }
        if (phys.bonded) {
            pairs.tensile[k] = phys.tensileStrength;
            pairs.shear[k] = phys.shearStrength;
        }
    }
    assembly.wallContacts.clear();
    for (const auto& [place, link] : onWalls) {
        const auto& phys = static_cast<const BondPhys&>(*known[link]->phys);
        const int plain =
            contactKind(elementKind(*Body::byId(wallId[place.first], scene), assembly.elements.radius[place.second]),
                        assembly.elements.kind[place.second]);
        assembly.wallContacts.push_back({place.first, place.second, kindOf(phys, plain), phys.state(), link, true});
    }
}

/// Whether a contact of two elements has options or will have.
bool GrainLoop::anyContactOptions() const {
    return std::any_of(elementKinds.begin(), elementKinds.end(),
                       [](const ElementKind& kind) { return kind.first->hasContactOptions(); }) ||
           std::any_of(known.begin(), known.end(), [](const auto& interaction) {
               return static_cast<const BondPhys&>(*interaction->phys).constants().options.any();
           });
}

int GrainLoop::elementKind(const Body& body, Real radius) {
    const ElementKind kind{&materialOf(body), radius};
    const auto [found, isNew] = elementKindNumbers.try_emplace(kind, static_cast<int>(elementKinds.size()));
    if (isNew)
        elementKinds.push_back(kind);
    return found->second;
}

int GrainLoop::contactKind(int one, int two) {
    const auto [found, isNew] = contactKinds.try_emplace(std::minmax(one, two), -1);
    if (isNew) {
        const auto [materialOne, radiusOne] = elementKinds[one];
        const auto [materialTwo, radiusTwo] = elementKinds[two];
        const auto phys = Ip2_BondMat_BondMat_BondPhys::contact(*materialOne, radiusOne, *materialTwo, radiusTwo);
        found->second = kindNumber({phys->constants()});
    }
    return found->second;
}

/// Kind of a pair with this physics; `plain` is that of a new contact of the two.
int GrainLoop::kindOf(const BondPhys& phys, int plain) {
    grainloop::PairKind kind{phys.constants()};
    const auto& c = kind.constants;
    const grainloop::PairKind unbonded{{physics::BondKind::None, c.kn, c.ks, c.tanPhi, {}, {}, 0, 1, c.options}};
    const bool remembers = phys.bondKind != BondMat::None || phys.overlap0 != 0;
    if (!phys.bonded) {
        kind = unbonded;
        kind.forgotten = remembers ? plain : -1;
        return kindNumber(kind);
    }
    grainloop::PairKind broken = unbonded;
    broken.forgotten = plain;
    kind.bondTanPhi = phys.bondTanPhi;
    kind.broken = kindNumber(broken);
    return kindNumber(kind);
}

int GrainLoop::kindNumber(const grainloop::PairKind& kind) {
    const auto& c = kind.constants;
    const auto& o = c.options;
    const std::vector<Real> key{
        Real(c.kind),         c.kn,           c.ks,          c.tanPhi,         c.bond.normal,
        c.bond.shear,         c.bond.bending, c.bond.twist,  c.section.area,   c.section.inertia,
        c.section.polar,      c.bondRadius,   c.beta,        kind.bondTanPhi,  Real(kind.broken),
        Real(kind.forgotten), o.hertz.normal, o.hertz.shear, o.unloadingRatio, o.rolling.stiffness,
        o.rolling.arm};
    const auto [found, isNew] = kindNumbers.try_emplace(key, static_cast<int>(assembly.kinds.size()));
    if (isNew)
        assembly.kinds.push_back(kind);
    return found->second;
}

}
