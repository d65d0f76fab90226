"""GrainLoop and YADE's own loop agree, save and balance energy with each option of the contact."""

import numpy as np
import pytest
from scenes import card, engine
from test_grainloop import EVENTS, RECORD, SPACE, assert_same, bodies, crushing
from yade import O
from yade.wrapper import GrainLoop

OPTIONS = {
    "hertz": {"contact.law": "hertz", "contact.poisson_ratio": 0.25},
    "yielding": {"contact.unloading_ratio": 3},
    "rolling": {"contact.rolling_friction": 0.3, "contact.rolling_stiffness": 0.5},
    "hertz and rolling": {
        "contact.law": "hertz",
        "contact.poisson_ratio": 0.25,
        "contact.rolling_friction": 0.3,
        "contact.rolling_stiffness": 0.5,
    },
}
# Loose elements and broken bonds early on, so that many contacts open, close and slide.
PLANE = card(crush__speed="0.2 m/s", bond__tensile_strength="0.4 MPa")
MODELS = {"plane": (PLANE, "5e13 Pa"), "space": (SPACE, "500 GPa")}
KEPT = (
    "breakage overlap0 kn ks contactNormal lastOverlap largestOverlap hertzNormal unloadingRatio rollingStiffness "
    "rollingArm bonded"
).split()


def model(dimension: str, option: str):
    base, young = MODELS[dimension]
    hertz = {"contact.young_modulus": young} if "hertz" in option else {}
    return base.with_overrides({**OPTIONS[option], **hertz})


def contacts() -> dict[tuple[int, int], np.ndarray]:
    """What real interactions hold, vectors as seen from the smaller id."""
    found = {}
    for i in O.interactions:
        if i.isReal:
            p, sign = i.phys, 1 if i.id1 < i.id2 else -1
            vectors = (p.contactShear, p.bondBending, p.rollingMoment)
            numbers = [getattr(p, name) for name in KEPT]
            found[tuple(sorted((i.id1, i.id2)))] = np.array(
                [*numbers, *(sign * c for v in vectors for c in v)], dtype=float
            )
    return found


@pytest.mark.parametrize("option", OPTIONS)
@pytest.mark.parametrize("dimension", MODELS)
def test_agrees_with_yades_loop_for_1000_steps(dimension, option):
    chosen = model(dimension, option)
    reference = crushing(chosen, loop=False)
    O.run(1000, True)
    expected, pairs = bodies(), contacts()
    events = list(zip(*(getattr(reference.engines.ledger, n) for n in EVENTS)))
    record = {n: np.array(getattr(reference.platens, n)) for n in RECORD}
    test = crushing(chosen, loop=True, substeps=50)
    O.run(1000, True)
    assert len(events) > 0
    assert list(zip(*(getattr(test.engines.ledger, n) for n in EVENTS))) == events
    assert_same(bodies(), expected, 1e-7)
    found = contacts()
    assert found.keys() == pairs.keys()
    order = sorted(pairs)
    before, after = (np.array([one[k] for k in order]).T for one in (pairs, found))
    for one, other in zip(before, after):
        np.testing.assert_allclose(other, one, rtol=0, atol=1e-7 * np.abs(one).max())
    used = {"hertz": "hertzNormal", "yielding": "unloadingRatio", "rolling": "rollingStiffness"}
    assert before[KEPT.index(used[option.split()[0]])].max() > 0
    assert_same({n: np.array(getattr(test.platens, n)) for n in RECORD}, record, 1e-6)


@pytest.mark.parametrize("loop", [False, True])
@pytest.mark.parametrize("option", OPTIONS)
def test_goes_on_bit_by_bit_after_loading(tmp_path, option, loop):
    crushing(model("plane", option), loop, substeps=50)
    O.run(1000, True)
    O.save(str(tmp_path / "scene.yade.gz"))
    O.run(1000, True)
    expected, pairs = bodies(), contacts()
    O.reset()
    O.load(str(tmp_path / "scene.yade.gz"))
    O.run(1000, True)
    assert all(np.array_equal(bodies()[name], expected[name]) for name in expected)
    found = contacts()
    assert found.keys() == pairs.keys()
    assert all(np.array_equal(found[k], pairs[k]) for k in pairs)


@pytest.mark.parametrize("option", OPTIONS)
def test_substeps_change_nothing(option):
    results = []
    for substeps in (1, 400):
        crushing(model("plane", option), loop=True, substeps=substeps)
        O.run(400, True)
        assert isinstance(engine(GrainLoop), GrainLoop)
        results.append((bodies(), contacts()))
    (one, pairs), (two, other) = results
    assert all(np.array_equal(one[name], two[name]) for name in one)
    assert pairs.keys() == other.keys()
    assert all(np.array_equal(pairs[k], other[k]) for k in pairs)


@pytest.mark.parametrize("option", OPTIONS)
def test_energy_of_a_crushed_grain_balances(option):
    test = crushing(model("plane", option), loop=True, substeps=100)
    O.run(-1, True)
    p = test.platens
    assert p.ended == "crushed"
    assert p.recordSliding[-1] > 0
    spent = p.recordElastic[-1] + p.recordKinetic[-1] + p.recordReleased[-1]
    spent += p.recordSliding[-1] + p.recordDamped[-1]
    assert spent == pytest.approx(p.work, rel=0.01)
