#include <grus/CrushingPlatens.hpp>

#include <core/Scene.hpp>

#include <grus/platen.hpp>
#include <grus/require.hpp>
#include <grus/sceneEnergy.hpp>
#include <physics/servo.hpp>

namespace yade {

namespace {

constexpr const char* name = "CrushingPlatens";

}

void CrushingPlatens::postLoad(CrushingPlatens&) {
    require(control == "speed" || control == "force", "CrushingPlatens.control", "'" + control + "'",
            "'force', 'speed'");
    require(axis >= 0 && axis <= 2, "CrushingPlatens.axis", axis, "0, 1, 2");
    require(speed >= 0, "CrushingPlatens.speed", speed, "0 or more");
    require(forceRate >= 0, "CrushingPlatens.forceRate", forceRate, "0 or more");
    require(relaxation > 0 && relaxation <= 1, "CrushingPlatens.relaxation", relaxation, "more than 0, at most 1");
    require(peakDrop > 0 && peakDrop < 1, "CrushingPlatens.peakDrop", peakDrop, "between 0 and 1");
    require(endDrop > 0 && endDrop <= 1, "CrushingPlatens.endDrop", endDrop, "more than 0, at most 1");
    require(maxStrain > 0 && maxStrain < 1, "CrushingPlatens.maxStrain", maxStrain, "between 0 and 1");
    require(recordInterval > 0, "CrushingPlatens.recordInterval", recordInterval, "more than 0");
}

void CrushingPlatens::action() {
    if (!ended.empty())
        return;
    if (startTime < 0)
        begin();
    measure();
    findPeak();
    if (closing >= nextRecord)
        record();
    const bool crushed = peakForce > 0 && force <= (1 - endDrop) * maxForce;
    if (crushed || closing >= maxStrain * initialGap)
        end(crushed ? "crushed" : "strain");
    else
        drive();
}

void CrushingPlatens::begin() {
    require(speed > 0, "CrushingPlatens.speed", speed, "more than 0, or the platens never close");
    require(control != "force" || forceRate > 0, "CrushingPlatens.forceRate", forceRate,
            "more than 0 under force control");
    startTime = scene->time;
    lastPosition = {platen(bottom, *scene, name).pos[axis], platen(top, *scene, name).pos[axis]};
    initialGap = lastPosition[1] - lastPosition[0];
    if (initialGap <= 0)
        throw std::runtime_error("CrushingPlatens: the top platen is not above the bottom platen");
}

void CrushingPlatens::measure() {
    scene->forces.sync();
    const Vector2r position{platen(bottom, *scene, name).pos[axis], platen(top, *scene, name).pos[axis]};
    const Vector2r onPlatens{scene->forces.getForce(bottom)[axis], scene->forces.getForce(top)[axis]};
    if (!onPlatens.allFinite() || !position.allFinite())
        throw std::runtime_error("CrushingPlatens: the force on a platen is not a number");
    work -= 0.5 * (onPlatens + lastForce).dot(position - lastPosition);
    force = 0.5 * (onPlatens[1] - onPlatens[0]);
    closing = initialGap - (position[1] - position[0]);
    lastPosition = position;
    lastForce = onPlatens;
}

void CrushingPlatens::findPeak() {
    if (peakForce == 0 && ledger && ledger->breaks() > 0 && force <= (1 - peakDrop) * maxForce) {
        peakForce = maxForce;
        peakClosing = maxForceClosing;
    }
    if (force > maxForce) {
        maxForce = force;
        maxForceClosing = closing;
    }
}

void CrushingPlatens::drive() {
    Real rate = speed;
    if (control == "force") {
        const Real error = forceRate * (scene->time - startTime) - force;
        rate = grus::physics::servoSpeed(error, platenStiffness(), scene->dt, relaxation, speed);
    }
    platen(bottom, *scene, name).vel[axis] = rate / 2;
    platen(top, *scene, name).vel[axis] = -rate / 2;
}

/// Force per closing if the grain itself were rigid: each platen moves half the closing against its own contacts.
Real CrushingPlatens::platenStiffness() const {
    return (contactStiffness(bottom, *scene) + contactStiffness(top, *scene)) / 4;
}

void CrushingPlatens::record() {
    nextRecord = closing + recordInterval * initialGap;
    recordTime.push_back(scene->time);
    recordClosing.push_back(closing);
    recordForce.push_back(force);
    recordTension.push_back(ledger ? ledger->tensionBreaks : 0);
    recordShear.push_back(ledger ? ledger->shearBreaks : 0);
    recordWork.push_back(work);
    recordElastic.push_back(elasticEnergy(*scene));
    recordKinetic.push_back(kineticEnergy(*scene));
    recordReleased.push_back(ledger ? ledger->releasedEnergy : 0);
    recordSliding.push_back(ledger ? ledger->slidingWork : 0);
    recordDamped.push_back(dampedEnergy(*scene));
}

void CrushingPlatens::end(const std::string& why) {
    record();
    ended = why;
    platen(bottom, *scene, name).vel[axis] = 0;
    platen(top, *scene, name).vel[axis] = 0;
    scene->stopAtIter = scene->iter + 1;
}

YADE_PLUGIN((CrushingPlatens));

}
