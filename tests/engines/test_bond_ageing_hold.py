"""BondAgeing with the oedometer's servo: holds of a column of three grains, in YADE's loop and in GrainLoop."""

import numpy as np
import pytest
from box import Box
from scenes import engine
from yade import O
from yade.wrapper import BondAgeing, GrainLoop, NewtonIntegrator, OedometerServo

STRESS = 100e3
LAWS = {
    "power": {"law": "power", "exponent": 8.0, "referenceTime": 10.0},
    "corrosion": {"law": "corrosion", "beta1": 1e-11, "beta2": 25.0, "largestShare": 0.2},
}
TOLERANCE = 1e-5
"""Of the servo; what it leaves open in the stress is found in the lives eight times, the exponent."""
LIVES = 10 * TOLERANCE
DURATION = {"power": 5e6, "corrosion": 6e5}


@pytest.fixture(scope="module")
def loaded(tmp_path_factory) -> str:
    """A scene of the column at rest under STRESS, without a broken bond."""
    box = Box(agglomerate__leftover="merge")
    box.stage(STRESS)
    path = str(tmp_path_factory.mktemp("loaded") / "box.yade.gz")
    O.save(path)
    return path


def ageing_of(path: str, loop: bool = False, **settings: object) -> BondAgeing:
    """Loads the scene and adds a BondAgeing; with GrainLoop in the place of YADE's engines when asked for."""
    O.load(path)
    servo, newton, stepper = engine(OedometerServo), O.engines[-1], O.engines[-3]
    servo.tolerance, servo.unbalancedLimit = TOLERANCE, 0.1 * TOLERANCE
    assert isinstance(newton, NewtonIntegrator)
    stepper.dead = True  # it acts at other steps in GrainLoop
    ageing = BondAgeing(servo=servo, ledger=servo.ledger, **settings)
    if loop:
        grains = GrainLoop(
            substeps=100, damping=newton.damping, ledger=servo.ledger, loading=[servo]
        )
        O.engines = [stepper, grains, ageing]
    else:
        O.engines = O.engines + [ageing]
    return ageing


def hold(ageing: BondAgeing, duration: float) -> None:
    """Begins a hold at STRESS as a stage of its own, so that it begins at a new rest."""
    ageing.servo.begin(STRESS)
    ageing.hold(duration)


def finish(ageing: BondAgeing, most: int = 200_000) -> None:
    """Runs to the end of the hold."""
    O.run(most, True)
    assert not ageing.holding, f"{ageing.clock:g} s after {most} steps"


def events(ageing: BondAgeing) -> list[tuple[int, int, int]]:
    """Ids and modes of the delayed failures."""
    return list(zip(ageing.failureId1, ageing.failureId2, ageing.failureMode))


@pytest.mark.parametrize("law", LAWS)
def test_both_loops_give_the_same_failures(loaded, law):
    found = []
    for loop in (False, True):
        ageing = ageing_of(loaded, loop, **LAWS[law])
        hold(ageing, DURATION[law])
        finish(ageing)
        found.append((events(ageing), np.array(ageing.brokenAtClock), ageing.recordHeight[-1]))
    (failures, clock, height), (failures2, clock2, height2) = found
    assert len(failures) >= 3 and failures2 == failures
    np.testing.assert_allclose(clock2, clock, rtol=LIVES)
    assert height2 == pytest.approx(height, rel=1e-7)


@pytest.mark.parametrize("law", LAWS)
def test_stress_is_kept_and_the_stage_stays_the_same(loaded, law):
    ageing = ageing_of(loaded, loop=True, **LAWS[law])
    servo = ageing.servo
    hold(ageing, DURATION[law])
    stage = servo.stage
    finish(ageing)
    assert ageing.failures >= 3 and servo.stage == stage and servo.done
    assert np.abs(np.array(ageing.recordStress) / STRESS - 1).max() <= 0.01
    height, breaks = np.array(ageing.recordHeight), ageing.recordBreaks
    assert height[-1] < height[0] and breaks[-1] == servo.ledger.breaks
    assert ageing.recordClock[0] == 0 and ageing.recordClock[-1] == DURATION[law]
    assert np.all(np.diff(ageing.recordClock) >= 0)
    assert set(ageing.failureClock) <= set(ageing.recordClock)
    assert len(ageing.brokenAtClock) == servo.ledger.breaks


@pytest.mark.parametrize("law", LAWS)
def test_energy_balance_stays_closed(loaded, law):
    ageing = ageing_of(loaded, loop=True, **LAWS[law])
    hold(ageing, DURATION[law])
    finish(ageing)
    s = ageing.servo
    spent = s.recordElastic[-1] + s.recordKinetic[-1] + s.recordSliding[-1] + s.recordDamped[-1]
    assert s.recordReleased[-1] > 0
    assert spent + s.recordReleased[-1] == pytest.approx(s.recordWork[-1], rel=2e-3)
    assert (ageing.releasedEnergy > 0) == (law == "corrosion")


@pytest.mark.parametrize("loop", [False, True])
@pytest.mark.parametrize("law", LAWS)
def test_goes_on_bit_by_bit_after_loading_in_a_hold(loaded, tmp_path, loop, law):
    def halves(interrupt: bool) -> tuple:
        ageing = ageing_of(loaded, loop, **LAWS[law])
        hold(ageing, DURATION[law])
        O.run(6000, True)
        assert ageing.holding and ageing.clock > 0
        if interrupt:
            path = str(tmp_path / "hold.yade.gz")
            O.save(path)
            O.reset()
            O.load(path)
        O.run(8000, True)
        ageing = engine(BondAgeing)
        assert ageing.failures > 0
        keys = ("ledger", "servo", "failurePosition")
        lists = {k: v for k, v in ageing.dict().items() if k not in keys}
        return lists, ageing.servo.recordHeight, [tuple(b.state.pos) for b in O.bodies]

    assert halves(interrupt=True) == halves(interrupt=False)


def test_the_run_stops_where_it_was_told_to(loaded):
    ageing = ageing_of(loaded, **LAWS["power"])
    hold(ageing, DURATION["power"])
    first = O.iter
    for steps in (700, 5300):
        O.run(steps, True)
        first += steps
        assert (O.iter, ageing.holding) == (first, True)
    assert ageing.clock > 0


def test_a_stage_that_ended_before_leaves_the_limit_alone(loaded):
    """A servo that is done must not end the steps that come after its stage."""
    ageing = ageing_of(loaded, loop=True, **LAWS["power"])
    ageing.servo.begin(STRESS)
    O.run(-1, True)
    assert ageing.servo.done
    O.run(-O.iter % 100 or 100, True)
    ageing.hold(DURATION["power"])
    first = O.iter
    O.run(100, True)
    assert O.iter == first + 100


def test_one_hold_after_another(loaded):
    whole = ageing_of(loaded, loop=True, **LAWS["power"])
    hold(whole, DURATION["power"])
    finish(whole)
    expected = events(whole), whole.failureClock
    parts = ageing_of(loaded, loop=True, **LAWS["power"])
    for share in (0.05, 0.45, 0.5):
        hold(parts, share * DURATION["power"])
        finish(parts)
    assert parts.clock == pytest.approx(DURATION["power"], rel=1e-12)
    assert events(parts) == expected[0]
    assert parts.failureClock == pytest.approx(expected[1], rel=LIVES)


@pytest.mark.parametrize("loop", [False, True])
def test_the_clock_follows_the_stress(loaded, loop):
    ageing = ageing_of(loaded, loop, stressRate=10.0, **LAWS["power"] | {"referenceTime": 1e12})
    servo = ageing.servo
    for target, expected in ((130e3, 3e3), (90e3, 7e3), (90e3, 7e3)):
        servo.begin(target)
        O.run(200_000, True)
        assert servo.done
        # the first stage begins at the stress that the servo was satisfied with
        assert ageing.clock == pytest.approx(expected, abs=0.01 * STRESS / 10)
    assert ageing.recordClock == [] and 0.99 < ageing.intactShares()[0] < 1


def test_the_clock_follows_a_schedule(loaded):
    ageing = ageing_of(
        loaded,
        loop=True,
        scheduleStress=[100e3, 110e3, 130e3],
        scheduleClock=[50.0, 150.0, 1000.0],
        **LAWS["power"] | {"referenceTime": 1e12},
    )
    ageing.servo.begin(120e3)
    O.run(200_000, True)
    assert ageing.clock == pytest.approx(150 + 850 / 2)
    ageing.scheduleStress, ageing.scheduleClock = [120e3, 80e3], [600.0, 700.0]
    ageing.servo.begin(100e3)
    O.run(200_000, True)
    assert ageing.clock == pytest.approx(650)
    ageing.scheduleClock = [1.0]
    ageing.servo.begin(110e3)
    with pytest.raises(RuntimeError, match="scheduleClock = 1; allowed: as many values as"):
        O.run(200_000, True)


def test_bonds_fail_while_the_stress_slowly_rises(loaded):
    """A load that rises slowly breaks bonds that a fast one leaves whole, and both come to rest."""
    found = {}
    for rate in (0.0, 1e-3):
        ageing = ageing_of(loaded, loop=True, stressRate=rate, **LAWS["power"])
        ageing.servo.begin(130e3)
        O.run(200_000, True)
        assert ageing.servo.done
        found[rate] = ageing.failures, ageing.servo.ledger.breaks, ageing.clock
        assert list(ageing.failureClock) == sorted(ageing.failureClock)
        assert set(ageing.failureClock) == set(ageing.recordClock)
    assert found[0.0] == (0, 0, 0)
    assert found[1e-3][0] > 0 and found[1e-3][1] >= found[1e-3][0]
    assert found[1e-3][2] == pytest.approx(30e3 / 1e-3, rel=0.05)


def test_wetting_in_a_hold_collapses_the_column(loaded):
    slow = LAWS["power"] | {"referenceTime": 1e12}
    ageing = ageing_of(loaded, loop=True, wetAt=100.0, wetFactor=0.15, humidity=0, **slow)
    hold(ageing, 200.0)
    finish(ageing)
    before = [b for c, b in zip(ageing.recordClock, ageing.recordBreaks) if c < 100]
    assert set(before) == {0} and ageing.recordBreaks[-1] > 3
    assert ageing.recordHeight[-1] < ageing.recordHeight[0]
    assert set(ageing.brokenAtClock) == {100.0} and ageing.failures == 0


def test_many_ages_are_many_kinds_for_grainloop(loaded):
    """Every bond of another diameter: GrainLoop takes them one by one and agrees with YADE's engines."""
    forces = []
    for loop in (False, True):
        ageing_of(loaded, loop, **LAWS["corrosion"])
        rng = np.random.default_rng(3)
        bonds = [i for i in O.interactions if i.isReal and i.phys.bonded]
        bonds.sort(key=lambda i: sorted((i.id1, i.id2)))
        for phys in (i.phys for i in bonds):
            left = rng.uniform(0.8, 1)
            phys.bondRadius *= left
            phys.sectionArea *= left
            phys.sectionInertia *= left**3
            phys.bondKn *= left
            phys.bondKs *= left
        O.run(200, True)
        forces.append(np.array([[i.phys.bondNormal, i.phys.bondBending[2]] for i in bonds]))
    assert len(forces[0]) > 400
    np.testing.assert_allclose(forces[1], forces[0], rtol=0, atol=1e-6 * np.abs(forces[0]).max())
