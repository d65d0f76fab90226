#include <grus/GrainLoop.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>

#include <core/Body.hpp>
#include <core/EnergyTracker.hpp>
#include <core/Scene.hpp>

#include <grus/require.hpp>

namespace yade {

namespace grainloop = grus::grainloop;

void GrainLoop::postLoad(GrainLoop&) {
    require(substeps >= 1, "GrainLoop.substeps", substeps, "1 or more");
    require(damping >= 0 && damping < 1, "GrainLoop.damping", damping, "0 to below 1");
    require(skin >= 0, "GrainLoop.skin", skin, "0 or more");
}

void GrainLoop::action() {
    gather();
    // to round numbers of steps, which engines with a period wait for
    for (int left = substeps - static_cast<int>(scene->iter % substeps);; --left) {
        grainloop::Losses losses;
        if (assembly.stale())
            search();
        assembly.computeForces(scene->dt, losses);
        bookBreakage(losses);
        load();
        // The run may have to end before the sub-steps do, as it was told to or because an engine has just said so.
        const bool last = left == 1 || scene->stopAtIter == scene->iter + 1 ||
                          (scene->stopAtTime > 0 && scene->time + scene->dt >= scene->stopAtTime);
        if (last) { // contacts belong to the positions before the motion, as after a step of YADE's own
            handBackInteractions();
            handBackForces();
        }
        assembly.move({scene->dt, damping, gravity}, losses);
        bookMotion(losses);
        if (last)
            break;
        ++scene->iter;
        scene->time += scene->dt;
    }
    handBackBodies();
}

void GrainLoop::search() {
    for (std::size_t i = 0; i < elementId.size(); ++i)
        if (!assembly.elements.position[i].allFinite())
            throw std::runtime_error("GrainLoop: the position of body " + std::to_string(elementId[i]) +
                                     " is not a number");
    const auto smallest = std::min_element(assembly.elements.radius.begin(), assembly.elements.radius.end());
    const Real automatic = smallest == assembly.elements.radius.end() ? 0 : 0.2 * *smallest;
    assembly.search(skin > 0 ? skin : automatic);
    ++searches;
    pairs = static_cast<int>(assembly.pairs.size());
}

void GrainLoop::bookBreakage(const grainloop::Losses& losses) {
    if (!ledger || (assembly.broken.empty() && losses.sliding == 0))
        return;
    if (losses.sliding != 0)
        ledger->recordSliding(losses.sliding);
    for (const auto& b : assembly.broken) {
        const auto [low, high] =
            std::minmax(elementId[assembly.pairs.first[b.pair]], elementId[assembly.pairs.second[b.pair]]);
        ledger->recordBreakage({low, high, static_cast<int>(b.mode), b.released, b.place});
    }
    ledger->scene = scene;
    ledger->action();
}

void GrainLoop::bookMotion(const grainloop::Losses& losses) {
    if (!scene->trackEnergy)
        return;
    scene->energy->add(losses.damped, "nonviscDamp", dampedIndex);
    if (!gravity.isZero())
        scene->energy->add(losses.gravity, "gravWork", gravityIndex);
}

void GrainLoop::load() {
    if (loading.empty())
        return;
    for (std::size_t w = 0; w < wallId.size(); ++w) {
        scene->forces._force[wallId[w]] = assembly.walls[w].force;
        scene->forces._torque[wallId[w]] = assembly.walls[w].moment;
        Body::byId(wallId[w], scene)->state->pos = assembly.walls[w].position;
    }
    scene->forces.synced = true;
    const LiveScene::Announcement announced(*scene, *this);
    for (const auto& engine : loading) {
        engine->scene = scene;
        if (!engine->dead && engine->isActivated())
            engine->action();
    }
    for (std::size_t w = 0; w < wallId.size(); ++w)
        assembly.walls[w].velocity = Body::byId(wallId[w], scene)->state->vel;
}

Real GrainLoop::contactStiffness(int wall) const { return assembly.contactStiffness(wallOf[wall]); }

YADE_PLUGIN((GrainLoop));

}
