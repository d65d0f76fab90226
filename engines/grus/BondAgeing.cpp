#include <grus/BondAgeing.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

#include <core/InteractionContainer.hpp>
#include <core/Omega.hpp>
#include <core/Scene.hpp>

#include <grus/require.hpp>
#include <grus/unbalancedForce.hpp>

namespace yade {

namespace physics = grus::physics;

namespace {

/// The physics of an interaction that is bonded; else null.
BondPhys* bonded(const Interaction& interaction) {
    auto* phys = interaction.isReal() ? dynamic_cast<BondPhys*>(interaction.phys.get()) : nullptr;
    return phys && phys->bonded ? phys : nullptr;
}

}

void BondAgeing::postLoad(BondAgeing&) {
    const std::string of = "BondAgeing.";
    require(law == "power" || law == "corrosion" || law == "none", of + "law", "'" + law + "'",
            "'corrosion', 'none', 'power'");
    require(drivenBy == "tension" || drivenBy == "larger", of + "drivenBy", "'" + drivenBy + "'",
            "'larger', 'tension'");
    require(exponent >= 0, of + "exponent", exponent, "0 or more");
    require(referenceTime >= 0, of + "referenceTime", referenceTime, "0 or more");
    require(beta1 >= 0, of + "beta1", beta1, "0 or more");
    require(beta2 >= 0, of + "beta2", beta2, "0 or more");
    require(threshold >= 0, of + "threshold", threshold, "0 or more");
    require(humidity >= 0 && humidity <= 1, of + "humidity", humidity, "0 to 1");
    require(largestShare > 0 && largestShare < 1, of + "largestShare", largestShare, "between 0 and 1");
    require(wetFactor > 0 && wetFactor <= 1, of + "wetFactor", wetFactor, "more than 0, at most 1");
    require(stressRate >= 0, of + "stressRate", stressRate, "0 or more");
    require(unbalancedLimit > 0, of + "unbalancedLimit", unbalancedLimit, "more than 0");
    require(quietSteps >= 1, of + "quietSteps", quietSteps, "1 or more");
    require(lookInterval >= 1, of + "lookInterval", lookInterval, "1 or more");
    require(recordsPerDecade >= 1, of + "recordsPerDecade", recordsPerDecade, "1 or more");
    require(firstRecord > 0, of + "firstRecord", firstRecord, "more than 0");
}

AgeingLaw BondAgeing::ageingLaw() const {
    AgeingLaw found;
    if (law == "none") {
        found.power.humidity = 0;
        return found;
    }
    found.corrosion = law == "corrosion";
    if (found.corrosion)
        require(beta1 > 0, "BondAgeing.beta1", beta1, "more than 0 with law = 'corrosion'");
    else {
        require(exponent > 0, "BondAgeing.exponent", exponent, "more than 0 with law = 'power'");
        require(referenceTime > 0, "BondAgeing.referenceTime", referenceTime, "more than 0 with law = 'power'");
    }
    found.power = {exponent, referenceTime, humidity};
    found.stressCorrosion = {beta1, beta2, humidity};
    found.stress = drivenBy == "larger" ? physics::AgeingStress::Larger : physics::AgeingStress::Tension;
    found.threshold = threshold;
    return found;
}

/// In the order of ids, whatever that of the scene.
std::vector<AgeingBond> BondAgeing::bonds(const AgeingLaw& byLaw) const {
    std::vector<AgeingBond> found;
    for (const auto& interaction : *scene->interactions)
        if (bonded(*interaction))
            found.emplace_back(*interaction, byLaw);
    std::sort(found.begin(), found.end(),
              [](const AgeingBond& a, const AgeingBond& b) { return std::tie(a.id1, a.id2) < std::tie(b.id1, b.id2); });
    return found;
}

void BondAgeing::action() {
    noteBreaks();
    if (!holding)
        followStress();
    else if (atRest())
        jump();
}

void BondAgeing::noteBreaks() {
    if (ledger)
        brokenAtClock.resize(ledger->brokenId1.size(), clock);
}

void BondAgeing::hold(Real duration) {
    require(duration > 0, "BondAgeing.hold(duration)", duration, "more than 0 s");
    ageingLaw();
    holding = true;
    holdBegin = clock;
    until = clock + duration;
    timesRecorded = 0;
    unrest = Omega::instance().getScene()->iter;
}

bool BondAgeing::atRest() {
    if (servo)
        return servo->done;
    if (scene->iter - lastLook >= lookInterval) {
        scene->forces.sync();
        const int breaks = static_cast<int>(brokenAtClock.size());
        if (!(unbalancedForce(*scene) <= unbalancedLimit) || breaks != lookBreaks)
            unrest = scene->iter;
        lookBreaks = breaks;
        lastLook = scene->iter;
    }
    return lastLook - unrest >= quietSteps;
}

/// From one rest to what disturbs it or to the end of the hold.
void BondAgeing::jump() {
    if (servo) {
        seenStage = servo->stage;
        passed = servo->target;
    }
    for (;;) {
        record(clock);
        const int before = failures();
        if (clock >= until) {
            holding = false;
            scene->stopAtIter = scene->iter + 1;
            return;
        }
        if (advance()) {
            awaitRest(failures() - before);
            return;
        }
    }
}

/// Lets the clock go to whatever comes next; returns whether forces have changed or will.
bool BondAgeing::advance() {
    const AgeingLaw byLaw = ageingLaw();
    const auto all = bonds(byLaw);
    const bool wetting = wetAt >= 0 && wetAt < until;
    Next next{std::max(clock, wetting ? wetAt : until), nullptr, 1};
    Real step = next.reading - clock;
    for (const AgeingBond& bond : all) {
        if (!bond.ages)
            continue;
        const Real left =
            byLaw.corrosion ? std::max(bond.leftAtFailure, bond.leftAfterLoss(largestShare)) : bond.leftAtFailure;
        const Real time = bond.timeUntil(left);
        if (time < step) {
            step = time;
            next = {clock + time, &bond, left};
        }
    }
    passTo(next.reading);
    bool disturbed = age(all, step, next);
    if (wetting && !next.bond) {
        wet(wetFactor);
        wetAt = -1;
        disturbed = true;
    }
    return disturbed;
}

/// Lets all bonds age by `time` [s], and that of `next` to what is left of it then.
bool BondAgeing::age(const std::vector<AgeingBond>& all, Real time, const Next& next) {
    bool disturbed = false;
    Real released = 0;
    for (const AgeingBond& bond : all) {
        if (!bond.ages)
            continue;
        const Real left = &bond == next.bond ? next.left : bond.leftAfter(time);
        released += bond.age(left);
        disturbed |= law == "corrosion" && left < 1;
        if (left > bond.leftAtFailure)
            continue;
        bond.fail();
        disturbed = true;
        failureClock.push_back(clock);
        failureId1.push_back(bond.id1);
        failureId2.push_back(bond.id2);
        failureMode.push_back(static_cast<int>(bond.mode));
        failurePosition.push_back(bond.place());
    }
    releasedEnergy += released;
    if (ledger)
        ledger->releasedEnergy += released;
    return disturbed;
}

void BondAgeing::awaitRest(int expectedBreaks) {
    unrest = scene->iter;
    if (servo)
        servo->resume(expectedBreaks);
}

/// The specimen is as it was at the last rest until the clock shows `reading`.
void BondAgeing::passTo(Real reading) {
    for (;; ++timesRecorded) {
        const Real due = holdBegin + firstRecord * std::pow(10, Real(timesRecorded) / recordsPerDecade);
        if (due >= reading)
            break;
        if (due > clock)
            record(due);
    }
    clock = reading;
}

void BondAgeing::followStress() {
    if (!servo || servo->stage < 0)
        return;
    if (servo->stage != seenStage) {
        if (seenStage < 0)
            passed = servo->firstStress();
        seenStage = servo->stage;
        rising = servo->target >= passed;
    }
    const Real sense = rising ? 1 : -1, measured = servo->axialStress();
    // What is missing to the target when a stage ends is within the servo's tolerance.
    const bool there = servo->done || sense * measured > sense * servo->target;
    const Real now = there ? servo->target : measured;
    if (sense * now > sense * passed) {
        const Real reading = readingAt(now);
        due += reading - clock;
        clock = reading;
        passed = now;
    }
    if (due > 0 && (servo->done || scene->iter - lastLook >= lookInterval))
        ageByDue();
    wetWhenDue();
}

void BondAgeing::wetWhenDue() {
    if (wetAt < 0 || clock < wetAt)
        return;
    wet(wetFactor);
    wetAt = -1;
    if (servo->done)
        awaitRest(0);
}

/// Reading of the clock when the stress that has been `passed` reaches `stress` [Pa].
Real BondAgeing::readingAt(Real stress) const {
    if (scheduleStress.empty())
        return stressRate > 0 ? clock + std::abs(stress - passed) / stressRate : clock;
    require(scheduleStress.size() == scheduleClock.size(), "BondAgeing.scheduleClock", scheduleClock.size(),
            "as many values as scheduleStress has (" + std::to_string(scheduleStress.size()) + ")");
    const Real sense = rising ? 1 : -1;
    std::size_t i = 0;
    while (i < scheduleStress.size() && sense * scheduleStress[i] < sense * stress)
        ++i;
    if (i == 0 || i == scheduleStress.size())
        return std::max(clock, i == 0 ? scheduleClock.front() : scheduleClock.back());
    const Real share = (stress - scheduleStress[i - 1]) / (scheduleStress[i] - scheduleStress[i - 1]);
    return std::max(clock, scheduleClock[i - 1] + share * (scheduleClock[i] - scheduleClock[i - 1]));
}

void BondAgeing::ageByDue() {
    const AgeingLaw byLaw = ageingLaw();
    const int before = failures();
    const bool disturbed = age(bonds(byLaw), due, {clock, nullptr, 1});
    due = 0;
    lastLook = scene->iter;
    if (failures() > before)
        record(clock);
    if (disturbed && servo->done)
        awaitRest(failures() - before);
}

void BondAgeing::wet(Real factor) {
    require(factor > 0 && factor <= 1, "BondAgeing.wet(factor)", factor, "more than 0, at most 1");
    for (const auto& interaction : *Omega::instance().getScene()->interactions)
        if (BondPhys* phys = bonded(*interaction)) {
            const physics::BondStrength strength = physics::softened(phys->strength(), factor);
            phys->tensileStrength = strength.tensile;
            phys->shearStrength = strength.shear;
        }
    softening *= factor;
    humidity = 1;
}

std::vector<Real> BondAgeing::intactShares() const {
    std::vector<Real> found;
    for (const auto& interaction : *Omega::instance().getScene()->interactions)
        if (const BondPhys* phys = bonded(*interaction))
            found.push_back(phys->intact);
    std::sort(found.begin(), found.end());
    return found;
}

void BondAgeing::record(Real reading) {
    recordClock.push_back(reading);
    recordHeight.push_back(servo ? servo->height : 0);
    recordStage.push_back(servo ? servo->stage : -1);
    recordStress.push_back(servo ? servo->axialStress() : 0);
    recordTop.push_back(servo ? servo->topStress : 0);
    recordBottom.push_back(servo ? servo->bottomStress : 0);
    recordSide.push_back(servo ? servo->sideStress : 0);
    recordFailures.push_back(failures());
    recordBreaks.push_back(ledger ? ledger->breaks() : 0);
}

YADE_PLUGIN((BondAgeing));

}
