"""BondAgeing under dead loads: times to failure against the laws, cascades, wetting, refusals."""

import numpy as np
import pytest
from bundle import RADIUS, Bundle
from scipy.integrate import quad
from scipy.optimize import brentq
from yade import O, utils
from yade.wrapper import BondAgeing, BondMat

AREA = np.pi * RADIUS**2
POWER = {"law": "power", "exponent": 20.0, "referenceTime": 100.0}
CORROSION = {"law": "corrosion", "beta1": 1e-12, "beta2": 25.0}
FOREVER = 1e12


def power_life(stress: float, strength: float, n: float = 20, t0: float = 100) -> float:
    """Time [s] in which the strength falls to the stress, by integration of the law."""
    return quad(
        lambda s: t0 / strength * (s / stress) ** n, stress, strength, epsrel=1e-12, limit=200
    )[0]


def run(steps: int = 30_000) -> None:
    O.run(steps, True)


@pytest.mark.parametrize("ratio", [0.4, 0.7, 0.95])
def test_one_bond_fails_by_the_power_law(ratio):
    bundle = Bundle([1e6], ratio * 1e6 * AREA, **POWER)
    bundle.ageing.hold(FOREVER)
    run()
    ageing = bundle.ageing
    assert ageing.failureClock == pytest.approx([power_life(ratio * 1e6, 1e6)], rel=1e-8)
    assert (ageing.failureId1, ageing.failureId2, ageing.failureMode) == ([0], [1], [1])
    assert ageing.failurePosition[0][1] == pytest.approx(-RADIUS, rel=0.1)
    assert ageing.brokenAtClock == ageing.failureClock
    assert bundle.interactions.ledger.brokenMode == [1] and not bundle.bonds[0].bonded


@pytest.mark.parametrize("thickness", [0, 0.05])
@pytest.mark.parametrize("steps", [1, 9.5])
def test_one_bond_fails_by_stress_corrosion(thickness, steps):
    """By a single jump or in steps: the dead load is there again each time, and so the life is the same."""
    area, order = (2 * RADIUS * thickness, 1) if thickness else (AREA, 2)
    ratio = 0.5
    end = ratio ** (1 / order)  # where the stress has reached the strength
    share = 1.01 * (1 - end) / steps
    bundle = Bundle([1e6], ratio * 1e6 * area, thickness, largestShare=share, **CORROSION)
    bundle.ageing.hold(FOREVER)
    run(120_000)
    slowness = quad(lambda x: np.exp(-25 * ratio / x**order), end, 1, epsrel=1e-12, limit=200)
    expected = 2 * RADIUS / 1e-12 * slowness[0]
    assert bundle.ageing.failureClock == pytest.approx([expected], rel=1e-7)
    assert bundle.bonds[0].intact == pytest.approx(end, rel=1e-6)


def test_released_energy_of_corroding_cement_is_booked():
    """The load sinks while its energy goes into the bond, the damping, and away with the cement."""
    bundle = Bundle([1e6], 0.5e6 * AREA, largestShare=0.02, **CORROSION)
    O.dt *= 0.25  # NewtonIntegrator tells the energy that damping takes to first order in the step
    state, bond = O.bodies[1].state, bundle.bonds[0]
    before = state.pos[1], bond.elasticEnergy(), O.energy["nonviscDamp"]
    life = 2 * RADIUS / 1e-12 * quad(lambda x: np.exp(-12.5 / x**2), 0.5**0.5, 1)[0]
    bundle.ageing.hold(0.95 * life)
    run(400_000)
    assert bundle.ageing.clock == 0.95 * life and 0.75 < bond.intact < 0.99
    work = 0.5e6 * AREA * (before[0] - state.pos[1])
    released = bundle.interactions.ledger.releasedEnergy
    spent = bond.elasticEnergy() - before[1] + O.energy["nonviscDamp"] - before[2] + released
    assert released == bundle.ageing.releasedEnergy > 0.3 * work > 0
    assert spent == pytest.approx(work, rel=1e-3)


def test_bundle_fails_as_the_known_cascade():
    """Equal shares of the load; the consumption, stress**n times time, at which each bond fails is known."""
    n, t0 = POWER["exponent"], POWER["referenceTime"]
    strengths = np.array([1.0, 1.08, 1.2, 1.3, 1.7]) * 1e6
    force = 2.6e6 * AREA
    bundle = Bundle(list(strengths), force, **POWER)
    bundle.ageing.hold(FOREVER)
    run(60_000)
    expected, clock, consumed = [], 0.0, 0.0
    for i, c in enumerate(strengths):
        s = force / AREA / (len(strengths) - i)
        fatal = t0 * (c ** (n + 1) - s ** (n + 1)) / ((n + 1) * c)
        clock += max(0.0, fatal - consumed) / s**n
        consumed = max(consumed, fatal)
        expected.append(clock)
    assert bundle.ageing.brokenAtClock == pytest.approx(expected, rel=1e-7)
    # The last two cannot carry what the third leaves them: an avalanche at one reading of the clock.
    assert expected[1] < expected[2] == expected[4]
    assert bundle.ageing.failures == 3


def test_larger_share_drives_and_shear_failure_is_booked():
    """A bond that is sheared by its load ages under 'larger' only, and fails in shear."""
    lives = {}
    for driven in ("tension", "larger"):
        bundle = Bundle([1e6], 1.0, drivenBy=driven, **POWER)
        bond = bundle.bonds[0]
        bond.shearStrength = 1e6
        bond.bondShear = (0.6e6 * AREA, 0, 0)  # the bar cannot move that way
        bundle.ageing.hold(1e7)
        run(5000)
        lives[driven] = list(bundle.ageing.failureClock), list(bundle.ageing.failureMode)
    assert lives["tension"] == ([], [])
    assert lives["larger"][0] == pytest.approx([power_life(0.6e6, 1e6)], rel=1e-6)
    assert lives["larger"][1] == [2]


def test_below_the_threshold_nothing_ages():
    bundle = Bundle([1e6], 0.7e6 * AREA, threshold=0.71e6, **POWER)
    bundle.ageing.hold(FOREVER)
    run()
    assert bundle.ageing.failures == 0 and bundle.bonds[0].intact == 1
    assert bundle.ageing.clock == FOREVER and not bundle.ageing.holding


def test_hold_ends_at_its_end_and_stops_the_run():
    bundle = Bundle([1e6], 0.7e6 * AREA, **POWER)
    life = power_life(0.7e6, 1e6)
    ageing = bundle.ageing
    ageing.clock = 5.0
    ageing.hold(0.5 * life)
    iteration = O.iter
    run(1_000_000)
    assert O.iter < iteration + 2000
    assert (ageing.clock, ageing.until, ageing.holding) == (5 + 0.5 * life, 5 + 0.5 * life, False)
    left = brentq(
        lambda x: power_life(0.7e6, 1e6) - power_life(0.7e6, x * 1e6) * x - 0.5 * life, 0.7, 1
    )
    assert ageing.intactShares() == pytest.approx([left], rel=1e-8)
    assert bundle.bonds[0].tensileStrength == pytest.approx(left * 1e6, rel=1e-8)
    ageing.hold(FOREVER)  # the second half
    run()
    assert ageing.failureClock == pytest.approx([5 + life], rel=1e-8)


def test_records_stand_at_logarithmic_times():
    bundle = Bundle([1e6], 0.7e6 * AREA, recordsPerDecade=4, firstRecord=10.0, **POWER)
    bundle.ageing.hold(2e3)
    run()
    clock = bundle.ageing.recordClock
    assert clock == pytest.approx([0, *10 * 10 ** (np.arange(10) / 4), 2000])
    assert bundle.ageing.recordFailures == [0] * len(clock)


@pytest.mark.parametrize("humidity", [0.25, 0.0])
def test_humidity_scales_the_rate(humidity):
    bundle = Bundle([1e6], 0.7e6 * AREA, humidity=humidity, **POWER)
    bundle.ageing.hold(FOREVER)
    run()
    expected = [power_life(0.7e6, 1e6) / humidity] if humidity else []
    assert bundle.ageing.failureClock == pytest.approx(expected, rel=1e-8)


def test_wetting_at_a_time_breaks_what_is_too_weak_and_ages_the_rest():
    strengths = [0.8e6, 1.5e6, 1.5e6]
    slow = POWER | {"referenceTime": 1e4, "humidity": 0.0}
    bundle = Bundle(strengths, 3 * 0.5e6 * AREA, wetAt=1e3, wetFactor=0.6, **slow)
    bundle.ageing.hold(2e3)
    run()
    ageing = bundle.ageing
    assert [b.bonded for b in bundle.bonds] == [False, True, True]
    assert ageing.brokenAtClock == [1e3] and ageing.failures == 0
    assert (ageing.softening, ageing.humidity, ageing.clock) == (0.6, 1.0, 2e3)
    stress, wet = 0.75e6, 0.9e6
    left = (1 - 21 * 1e3 / 1e4 * (stress / wet) ** 20) ** (1 / 21)
    assert [b.tensileStrength for b in bundle.bonds[1:]] == pytest.approx(
        [left * wet] * 2, rel=1e-8
    )
    assert ageing.recordBreaks[0] == 0 and ageing.recordBreaks[-1] == 1


def test_wetting_by_hand():
    bundle = Bundle([1e6], 0.5e6 * AREA, **POWER)
    bundle.ageing.wet(0.8)
    bundle.ageing.wet(0.5)
    assert bundle.bonds[0].tensileStrength == 0.4e6 and bundle.ageing.softening == 0.4
    run(10)
    assert bundle.interactions.ledger.brokenMode == [1]


def test_without_a_hold_nothing_happens():
    bundle = Bundle([1e6], 0.9e6 * AREA, **POWER)
    run(2000)
    assert (bundle.ageing.clock, bundle.ageing.recordClock) == (0, [])
    assert bundle.bonds[0].tensileStrength == 1e6 and bundle.bonds[0].intact == 1


@pytest.mark.parametrize("law", [POWER, CORROSION | {"largestShare": 0.2}])
@pytest.mark.parametrize("suffix", [".yade.gz", ".xml"])
def test_goes_on_bit_by_bit_after_loading_in_a_hold(tmp_path, law, suffix):
    def halves(interrupt: bool) -> tuple:
        bundle = Bundle([1e6, 1.05e6, 1.2e6, 1.5e6], 2e6 * AREA, **law)
        bundle.ageing.hold(FOREVER)
        O.run(4000, True)
        if interrupt:
            O.save(str(tmp_path / f"hold{suffix}"))
            O.reset()
            O.load(str(tmp_path / f"hold{suffix}"))
            for member in bundle.members:  # YADE does not save permanent forces
                O.forces.setPermF(member, (0, -2e6 * AREA / 4, 0))
        O.run(40_000, True)
        ageing = O.engines[-1]
        lists = {k: v for k, v in ageing.dict().items() if k not in ("ledger", "failurePosition")}
        return lists, [tuple(b.state.pos) for b in O.bodies]

    expected = halves(interrupt=False)
    assert len(expected[0]["brokenAtClock"]) == 4
    assert halves(interrupt=True) == expected


@pytest.mark.parametrize(
    "key, value, allowed",
    [
        ("law", "fast", "'corrosion', 'none', 'power'"),
        ("drivenBy", "shear", "'larger', 'tension'"),
        ("exponent", -1.0, "0 or more"),
        ("humidity", 1.1, "0 to 1"),
        ("largestShare", 1.0, "between 0 and 1"),
        ("wetFactor", 0.0, "more than 0, at most 1"),
        ("stressRate", -1.0, "0 or more"),
        ("recordsPerDecade", 0, "1 or more"),
    ],
)
def test_bad_settings_are_refused(key, value, allowed):
    with pytest.raises(ValueError, match=f"BondAgeing.{key} = .*; allowed: {allowed}"):
        BondAgeing(**{key: value})


def test_missing_parameters_and_bad_calls_are_refused():
    with pytest.raises(ValueError, match="exponent = 0; allowed: more than 0 with law = 'power'"):
        BondAgeing().hold(1.0)
    with pytest.raises(ValueError, match="beta1 = 0; allowed: more than 0 with law = 'corrosion'"):
        BondAgeing(law="corrosion").hold(1.0)
    with pytest.raises(ValueError, match="hold.duration. = 0; allowed: more than 0 s"):
        BondAgeing(**POWER).hold(0.0)
    with pytest.raises(ValueError, match="wet.factor. = 2; allowed: more than 0, at most 1"):
        BondAgeing().wet(2.0)


def test_contact_bonds_do_not_corrode():
    bundle = Bundle([1e6], 0.5e6 * AREA, **CORROSION)
    O.reset()
    material = BondMat(kn=1e7, ks=1e7, bond="contact", tensileStrength=1e3, shearStrength=1e3)
    O.materials.append(material)
    for y in (0, 2 * RADIUS):
        O.bodies.append(utils.sphere((0, y, 0), RADIUS, fixed=True))
        O.bodies[-1].state.grain = 0
    bundle.interactions.ip2.bonding = True
    bundle.interactions.reach(1.01)
    bundle.ageing.unbalancedLimit = 1e9
    O.engines = bundle.interactions.list + [bundle.ageing]
    bundle.ageing.hold(1.0)
    with pytest.raises(
        RuntimeError, match="contact bond and has no diameter .*; use law = 'power'"
    ):
        O.run(1000, True)
