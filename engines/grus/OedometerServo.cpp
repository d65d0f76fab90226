#include <grus/OedometerServo.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <core/Body.hpp>
#include <core/Omega.hpp>
#include <core/Scene.hpp>
#include <pkg/common/Wall.hpp>

#include <grus/platen.hpp>
#include <grus/require.hpp>
#include <grus/sceneEnergy.hpp>
#include <grus/unbalancedForce.hpp>

namespace yade {

namespace {

constexpr const char* name = "OedometerServo";

/// Axis that the wall stands across; throws std::runtime_error for a body of another shape.
int wallAxis(const Body& body) {
    const auto* wall = dynamic_cast<const Wall*>(body.shape.get());
    if (!wall)
        throw std::runtime_error("OedometerServo: body " + std::to_string(body.id) + " of sides is not a Wall");
    return wall->axis;
}

}

void OedometerServo::postLoad(OedometerServo&) {
    const std::string of = std::string(name) + ".";
    require(axis >= 0 && axis <= 2, of + "axis", axis, "0, 1, 2");
    require(moving == "both" || moving == "top", of + "moving", "'" + moving + "'", "'both', 'top'");
    require(area >= 0, of + "area", area, "0 or more");
    require(sideBreadth >= 0, of + "sideBreadth", sideBreadth, "0 or more");
    require(solidVolume >= 0, of + "solidVolume", solidVolume, "0 or more");
    require(tolerance > 0 && tolerance < 1, of + "tolerance", tolerance, "between 0 and 1");
    require(unbalancedLimit > 0, of + "unbalancedLimit", unbalancedLimit, "more than 0");
    require(quietSteps >= 1, of + "quietSteps", quietSteps, "1 or more");
    require(quietStretches >= 1, of + "quietStretches", quietStretches, "1 or more");
    require(maxSpeed > 0, of + "maxSpeed", maxSpeed, "more than 0");
    require(fastSpeed == 0 || fastSpeed >= maxSpeed, of + "fastSpeed", fastSpeed, "0, or maxSpeed and more");
    require(speedGrowth >= 1, of + "speedGrowth", speedGrowth, "1 or more");
    require(relaxation > 0 && relaxation <= 1, of + "relaxation", relaxation, "more than 0, at most 1");
    require(lookInterval >= 1, of + "lookInterval", lookInterval, "1 or more");
    require(recordStrain > 0, of + "recordStrain", recordStrain, "more than 0");
    require(recordStress > 0, of + "recordStress", recordStress, "more than 0");
}

void OedometerServo::begin(Real stress, bool settled) {
    require(stress > 0, std::string(name) + ".begin(target)", stress, "more than 0 Pa");
    target = stress;
    ++stage;
    awaitRest(0);
    if (settled)
        stageBreaks = -1; // as if a bond had broken
}

void OedometerServo::resume(int expectedBreaks) {
    Scene& now = *Omega::instance().getScene();
    if (done && stoppedAt == now.iter && now.stopAtIter == now.iter + 1)
        now.stopAtIter = stopBefore;
    awaitRest(expectedBreaks);
}

void OedometerServo::awaitRest(int expectedBreaks) {
    done = false;
    quiet = 0;
    quietBreaks = breaks();
    stageBreaks = quietBreaks + expectedBreaks;
    speedLimit = maxSpeed;
    unbalanced = std::numeric_limits<Real>::infinity(); // until the first look
}

void OedometerServo::action() {
    if (stage < 0 || done)
        return;
    measure();
    if (scene->iter % lookInterval == 0)
        look();
    if (recordDue())
        record();
    watchRest();
    drive();
}

void OedometerServo::measure() {
    scene->forces.sync();
    const Vector2r position{platen(bottom, *scene, name).pos[axis], platen(top, *scene, name).pos[axis]};
    const Vector2r force{scene->forces.getForce(bottom)[axis], scene->forces.getForce(top)[axis]};
    height = position[1] - position[0];
    if (!force.allFinite() || !std::isfinite(height))
        throw std::runtime_error("OedometerServo: the force on a platen is not a number");
    if (height <= 0)
        throw std::runtime_error("OedometerServo: the platens have met; the specimen is gone");
    if (initialHeight == 0) {
        require(area > 0 && solidVolume > 0, "OedometerServo.area, solidVolume", std::min(area, solidVolume),
                "more than 0");
        initialHeight = lookHeight = height;
        lookTime = scene->time;
        lastPosition = position;
        speedLimit = maxSpeed;
    }
    work -= 0.5 * (force + lastForce).dot(position - lastPosition);
    lastPosition = position;
    lastForce = force;
    topStress = force[1] / area;
    bottomStress = -force[0] / area;
    Real onSides = 0;
    for (const int id : sides) {
        platen(id, *scene, "OedometerServo.sides");
        onSides += std::abs(scene->forces.getForce(id)[wallAxis(*Body::byId(id, scene))]);
    }
    sideStress = sides.empty() || sideBreadth <= 0 ? 0 : onSides / (sides.size() * sideBreadth * height);
}

void OedometerServo::look() {
    using namespace grus::physics;
    unbalanced = unbalancedForce(*scene);
    const Real elapsed = scene->time - lookTime;
    const Real rate = elapsed > 0 ? (lookHeight - height) / height / elapsed : 0;
    const Real elastic = elasticEnergy(*scene);
    kinetic = kineticEnergy(*scene);
    if (!std::isfinite(elastic + kinetic))
        throw std::runtime_error("OedometerServo: the motion of a grain is not a number");
    const Real axial = axialStress();
    inertial = inertialNumber(rate, grainDiameter, grainDensity, axial);
    const Real gradient = axial > 0 && !baseFixed() ? std::abs(topStress - bottomStress) / axial : 0;
    const Calm calm{{inertial, elastic > 0 ? kinetic / elastic : 0, gradient}, breaks() - lookBreaks};
    speedLimit = nextSpeedLimit(speedLimit, maxSpeed, std::max(fastSpeed, maxSpeed), speedGrowth, calm,
                                {inertialLimit, kineticLimit, gradientLimit});
    lookBreaks = breaks();
    lookHeight = height;
    lookTime = scene->time;
}

bool OedometerServo::atTarget() const {
    const auto there = [this](Real stress) { return std::abs(stress - target) <= tolerance * target; };
    return there(topStress) && (baseFixed() || there(bottomStress));
}

void OedometerServo::watchRest() {
    const bool resting = atTarget() && unbalanced <= unbalancedLimit && breaks() == quietBreaks;
    quiet = resting ? quiet + 1 : 0;
    quietBreaks = breaks();
    const int stretches = breaks() > stageBreaks ? quietStretches : 1;
    if (quiet < stretches * quietSteps)
        return;
    done = true;
    record();
    stopBefore = scene->stopAtIter;
    stoppedAt = scene->iter;
    scene->stopAtIter = scene->iter + 1;
}

Real OedometerServo::speedOf(int id, Real stress) const {
    return grus::physics::servoSpeed((target - stress) * area, contactStiffness(id, *scene), scene->dt, relaxation,
                                     speedLimit);
}

void OedometerServo::drive() {
    platen(bottom, *scene, name).vel[axis] = done || baseFixed() ? 0 : speedOf(bottom, bottomStress);
    platen(top, *scene, name).vel[axis] = done ? 0 : -speedOf(top, topStress);
}

Real OedometerServo::firstStress() const {
    const auto found = std::find(recordStage.begin(), recordStage.end(), stage);
    const auto i = found - recordStage.begin();
    return found == recordStage.end() ? axialStress() : controlled(recordTop[i], recordBottom[i]);
}

bool OedometerServo::recordDue() const {
    if (recordHeight.empty() || recordStage.back() != stage)
        return true;
    const Real before = controlled(recordTop.back(), recordBottom.back());
    return std::abs(recordHeight.back() - height) >= recordStrain * initialHeight ||
           std::abs(axialStress() - before) >= recordStress * std::max(before, 0.01 * target);
}

void OedometerServo::record() {
    recordIter.push_back(static_cast<int>(scene->iter));
    recordTime.push_back(scene->time);
    recordStage.push_back(stage);
    recordHeight.push_back(height);
    recordTop.push_back(topStress);
    recordBottom.push_back(bottomStress);
    recordSide.push_back(sideStress);
    recordTension.push_back(ledger ? ledger->tensionBreaks : 0);
    recordShear.push_back(ledger ? ledger->shearBreaks : 0);
    recordUnbalanced.push_back(unbalanced);
    recordInertial.push_back(inertial);
    recordSpeed.push_back(speedLimit);
    recordWork.push_back(work);
    recordElastic.push_back(elasticEnergy(*scene));
    recordKinetic.push_back(kineticEnergy(*scene));
    recordReleased.push_back(ledger ? ledger->releasedEnergy : 0);
    recordSliding.push_back(ledger ? ledger->slidingWork : 0);
    recordDamped.push_back(dampedEnergy(*scene));
}

YADE_PLUGIN((OedometerServo));

}
