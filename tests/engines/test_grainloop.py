"""GrainLoop does what InteractionLoop and NewtonIntegrator do: the same numbers to round-off, in the plane and in space."""

import numpy as np
import pytest
from scenes import MODELS, card, engine
from yade import O, utils
from yade.wrapper import (
    BondMat,
    BondTimeStepper,
    ForceEngine,
    ForceResetter,
    FrictMat,
    GrainLoop,
    NewtonIntegrator,
)

from grus.card import Card
from grus.crushing import CrushingTest
from grus.scene import InteractionEngines

PLANE = card(crush__speed="0.2 m/s")
# Without damping: it acts by the signs of angular velocities, which at first are round-off and nothing else.
SPACE = Card.from_file(MODELS / "montesinho-3d.toml").with_overrides(
    {"crush.speed": "0.5 m/s", "crush.damping": 0, "crush.loop": "InteractionLoop"}
)


def crushing(model: Card, loop: bool, substeps: int = 1) -> CrushingTest:
    """A crushing test with a fixed time step, with YADE's engines or GrainLoop in their place."""
    test = CrushingTest(model)
    stepper = engine(BondTimeStepper)
    O.dt = stepper.safety * stepper.critical()
    stepper.dead = True
    if loop:
        O.engines = [
            stepper,
            GrainLoop(
                substeps=substeps,
                damping=model.crush.damping,
                ledger=test.engines.ledger,
                loading=[test.platens],
            ),
        ]
    return test


def bodies() -> dict[str, np.ndarray]:
    """Motion of and forces on all bodies, each (n, 3)."""
    columns = {
        "position": [b.state.pos for b in O.bodies],
        "velocity": [b.state.vel for b in O.bodies],
        "rate": [b.state.angVel for b in O.bodies],
        "orientation": [[b.state.ori[i] for i in range(4)] for b in O.bodies],
        "force": [O.forces.f(b.id) for b in O.bodies],
        "torque": [O.forces.t(b.id) for b in O.bodies],
    }
    return {name: np.array([list(v) for v in rows]) for name, rows in columns.items()}


def contacts() -> dict[tuple[int, int], np.ndarray]:
    """What real interactions hold, by their ids; vectors as seen from the smaller id, as the order is arbitrary."""
    found = {}
    for i in O.interactions:
        if not i.isReal:
            continue
        p, g, sign = i.phys, i.geom, 1 if i.id1 < i.id2 else -1
        vectors = (p.normalForce, p.shearForce, p.bondBending, g.normal)
        found[tuple(sorted((i.id1, i.id2)))] = np.concatenate(
            [
                [p.bonded, p.breakage, p.overlap0, p.kn, p.contactNormal],
                [p.bondNormal, p.bondTwist, g.penetrationDepth, *g.contactPoint],
                *(sign * np.array(list(v)) for v in vectors),
            ]
        )
    return found


def assert_same(found: dict, expected: dict, tolerance: float) -> None:
    """Equal to `tolerance` of the largest number of each kind."""
    assert found.keys() == expected.keys()
    for name, values in expected.items():
        limit = tolerance * max(np.abs(values).max(), 1e-300)
        np.testing.assert_allclose(found[name], values, rtol=0, atol=limit, err_msg=str(name))


@pytest.mark.parametrize("model, substeps", [(PLANE, 1), (PLANE, 50), (SPACE, 100)])
def test_agrees_with_yades_engines_for_1000_steps(model, substeps):
    reference = crushing(model, loop=False)
    O.run(1000, True)
    expected, pairs, steps, time = bodies(), contacts(), O.iter, O.time
    events = list(zip(*(getattr(reference.engines.ledger, n) for n in EVENTS)))
    record = {n: np.array(getattr(reference.platens, n)) for n in RECORD}
    test = crushing(model, loop=True, substeps=substeps)
    O.run(1000, True)
    assert (O.iter, O.time) == (steps, pytest.approx(time, rel=1e-12))
    assert len(events) > 0
    assert list(zip(*(getattr(test.engines.ledger, n) for n in EVENTS))) == events
    assert_same(bodies(), expected, 1e-7)
    found = contacts()
    assert found.keys() == pairs.keys()
    order = sorted(pairs)
    columns = np.array([pairs[k] for k in order]), np.array([found[k] for k in order])
    for before, after in zip(columns[0].T, columns[1].T):
        np.testing.assert_allclose(after, before, rtol=0, atol=1e-7 * np.abs(before).max())
    # The force of a bond before it breaks is found from its motion, not kept: released energies are less exact.
    assert_same({n: np.array(getattr(test.platens, n)) for n in RECORD}, record, 1e-6)


EVENTS = ("brokenAtIter", "brokenId1", "brokenId2", "brokenMode")
RECORD = (
    "recordTime",
    "recordForce",
    "recordClosing",
    "recordElastic",
    "recordKinetic",
    "recordSliding",
    "recordDamped",
    "recordReleased",
    "recordTension",
    "recordShear",
)


@pytest.mark.parametrize("model", [PLANE, SPACE])
def test_substeps_change_nothing(model):
    results = []
    for substeps in (1, 7, 400):
        crushing(model, loop=True, substeps=substeps)
        O.run(400, True)
        results.append((O.iter, bodies(), contacts()))
    for iteration, motion, pairs in results[1:]:
        assert iteration == results[0][0]
        assert all(np.array_equal(motion[name], results[0][1][name]) for name in motion)
        assert pairs.keys() == results[0][2].keys()
        assert all(np.array_equal(pairs[k], results[0][2][k]) for k in pairs)


@pytest.mark.parametrize("suffix", [".yade.gz", ".xml"])
def test_goes_on_bit_by_bit_after_loading(tmp_path, suffix):
    crushing(PLANE, loop=True, substeps=50)
    O.run(1500, True)
    O.save(str(tmp_path / f"scene{suffix}"))
    O.run(1500, True)
    expected, pairs = bodies(), contacts()
    record = [list(getattr(engine(GrainLoop).loading[0], n)) for n in RECORD]
    O.reset()
    O.load(str(tmp_path / f"scene{suffix}"))
    O.run(1500, True)
    assert all(np.array_equal(bodies()[name], expected[name]) for name in expected)
    found = contacts()
    assert found.keys() == pairs.keys()
    assert all(np.array_equal(found[k], pairs[k]) for k in pairs)
    assert [list(getattr(engine(GrainLoop).loading[0], n)) for n in RECORD] == record


def test_hands_over_to_yades_engines_and_back():
    reference = crushing(PLANE, loop=False)
    yades = O.engines
    O.run(900, True)
    expected = bodies()
    test = crushing(PLANE, loop=True, substeps=100)
    loop = O.engines
    O.run(300, True)
    O.engines = test.engines.interactions.list + [test.platens, test.engines.newton]
    O.run(300, True)
    O.engines = loop
    O.run(300, True)
    assert reference.platens is not test.platens and len(yades) > len(loop)
    assert_same(bodies(), expected, 1e-7)


def test_a_grain_is_crushed_as_by_yades_engines():
    """The same course to the end, as far as round-off grows: the energy balance closes and the strength agrees."""
    strength = []
    for loop in (False, True):
        test = crushing(PLANE, loop, substeps=100)
        O.run(-1, True)
        p = test.platens
        assert p.ended == "crushed"
        spent = p.recordElastic[-1] + p.recordKinetic[-1] + p.recordReleased[-1]
        spent += p.recordSliding[-1] + p.recordDamped[-1]
        assert spent == pytest.approx(p.work, rel=0.01)
        strength.append(p.peakForce or p.maxForce)
    assert strength[1] == pytest.approx(strength[0], rel=0.05)


def two_spheres(distance: float, speed: float) -> None:
    """Two loose spheres that move towards each other along x, the second also across."""
    material = BondMat(density=2500, kn=1e6, ks=5e5, frictionAngle=0.5)
    O.materials.append(material)
    for x, v in ((0, (speed, 0, 0)), (distance, (-speed, 0.3 * speed, 0.1 * speed))):
        O.bodies.append(utils.sphere((x, 0, 0), 0.01, material=material))
        O.bodies[-1].state.vel = v
    O.dt = 1e-6


def loose(loop: bool, substeps: int) -> list:
    """Engines for loose spheres under gravity."""
    if loop:
        return [GrainLoop(damping=0, gravity=(0, 0, -10), substeps=substeps)]
    return InteractionEngines().list + [NewtonIntegrator(damping=0, gravity=(0, 0, -10))]


def test_contacts_open_and_close():
    results = []
    for loop in (False, True):
        O.reset()
        two_spheres(0.0203, 1.0)
        O.engines = loose(loop, 50)
        real = []
        for _ in range(60):
            O.run(50, True)
            real.append(sum(i.isReal for i in O.interactions))
        assert {0, 1} == set(real)
        results.append((real, bodies()))
    assert results[0][0] == results[1][0]
    np.testing.assert_allclose(
        results[1][1]["velocity"], results[0][1]["velocity"], rtol=1e-9, atol=1e-9
    )
    np.testing.assert_allclose(results[1][1]["rate"], results[0][1]["rate"], rtol=1e-9, atol=1e-7)


@pytest.mark.parametrize("skin", [1e-5, 1e-3])
def test_skin_changes_nothing(skin):
    two_spheres(0.0203, 1.0)
    O.engines = [GrainLoop(damping=0, substeps=500)]
    O.run(1000, True)
    expected = bodies()
    O.reset()
    two_spheres(0.0203, 1.0)
    O.engines = [GrainLoop(damping=0, substeps=500, skin=skin)]
    O.run(1000, True)
    assert all(np.array_equal(bodies()[name], expected[name]) for name in expected)


@pytest.mark.parametrize("second_first", [False, True])
def test_pairs_count_in_either_order(second_first):
    """Clumps and spheres stand in another order in the loop than their ids, and so do the bodies of a contact."""
    results = []
    for loop in (False, True):
        O.reset()
        material = BondMat(density=2500, kn=1e6, ks=5e5, frictionAngle=0.5)
        O.materials.append(material)
        places = [(0, 0, 0), (0.01, 0.004, 0), (-0.0195, 0.001, 0)]
        if second_first:
            places = [places[2], *places[:2]]
        ids = [O.bodies.append(utils.sphere(p, 0.01, material=material)) for p in places]
        O.bodies.clump(ids[1:] if second_first else ids[:2])
        O.dt = 1e-6
        # The contact is YADE's, whose bodies then change to the other loop.
        O.engines = loose(False, 1)
        O.run(10, True)
        O.engines = loose(loop, 10)
        O.run(100, True)
        results.append(bodies())
    assert np.abs(results[0]["force"]).max() > 1
    assert_same(results[1], results[0], 1e-9)


@pytest.mark.parametrize("blocked", ["", "XY", "xZ", "XYZ", "zXY"])
def test_blocked_axes_of_a_clump_turn_as_in_yade(blocked):
    results = []
    for loop in (False, True):
        O.reset()
        material = BondMat(density=2500, kn=1e6, ks=5e5, frictionAngle=0.5)
        O.materials.append(material)
        O.bodies.append(utils.wall(-0.0099, 2, material=material))
        spheres = ((0, 0, 0, 0.01), (0.015, 0.003, 0.004, 0.008), (-0.01, 0.005, 0.004, 0.006))
        ids = [
            O.bodies.append(utils.sphere((x, y, z), r, material=material)) for x, y, z, r in spheres
        ]
        clump = O.bodies[O.bodies.clump(ids)].state
        clump.blockedDOFs, clump.vel, clump.angVel = blocked, (0.1, 0.2, -0.3), (3, 4, 5)
        O.dt = 1e-6
        O.engines = loose(loop, 100)
        O.run(300, True)
        results.append(bodies())
    assert_same(results[1], results[0], 1e-9)


def test_damping_takes_what_gravity_gives():
    booked = []
    for engines in ([GrainLoop(damping=0.4, gravity=(0, 0, -10))], None):
        O.reset()
        two_spheres(1, 0)
        O.trackEnergy = True
        O.engines = engines or [ForceResetter(), NewtonIntegrator(damping=0.4, gravity=(0, 0, -10))]
        O.run(100, True)
        booked.append((O.energy["nonviscDamp"], O.energy["gravWork"]))
    assert booked[0] == pytest.approx(booked[1])
    assert booked[0][0] == pytest.approx(-0.4 * booked[0][1])


def test_stops_at_a_time():
    two_spheres(1, 0)
    O.engines = [GrainLoop(substeps=100)]
    O.stopAtTime = 10.5 * O.dt
    O.run(-1, True)
    O.stopAtTime = 0
    assert O.iter == 11


def refused(match: str) -> None:
    with pytest.raises(RuntimeError, match=match):
        O.step()
    O.reset()


def test_says_what_it_does_not_support():
    two_spheres(0.03, 0)
    O.engines = [GrainLoop(), NewtonIntegrator()]
    refused("work of NewtonIntegrator; take that out of O.engines")
    two_spheres(0.03, 0)
    O.engines = [ForceResetter(), GrainLoop()]
    refused("work of ForceResetter")
    O.bodies.append(utils.sphere((0, 0, 0), 1, material=O.materials.append(FrictMat())))
    O.engines = [GrainLoop()]
    refused("body 0 is of FrictMat, not BondMat; use InteractionLoop and NewtonIntegrator")
    O.bodies.append(utils.box((0, 0, 0), (1, 1, 1), material=O.materials.append(BondMat())))
    O.engines = [GrainLoop()]
    refused("body 0 is a Box")
    two_spheres(0.03, 0)
    O.periodic = True
    O.engines = [GrainLoop()]
    refused("the scene is periodic")
    two_spheres(0.03, 0)
    O.bodies[1].bounded = False
    O.engines = [GrainLoop()]
    refused("body 1 is not bounded")
    two_spheres(0.03, 0)
    O.engines = [ForceEngine(ids=[1], force=(1, 0, 0)), GrainLoop()]
    refused("body 1 has a force that an engine or a script put on it")
    two_spheres(0, 0)
    O.bodies[1].state.pos = (float("nan"), 0, 0)
    O.engines = [GrainLoop()]
    refused("the position of body 1 is not a number")


@pytest.mark.parametrize(
    "key, value, allowed",
    [("substeps", 0, "1 or more"), ("damping", 1.0, "0 to below 1"), ("skin", -1.0, "0 or more")],
)
def test_bad_settings_are_refused(key, value, allowed):
    with pytest.raises(ValueError, match=rf"GrainLoop.{key} = .*; allowed: {allowed}"):
        GrainLoop(**{key: value})


def test_empty_scene_is_fine():
    O.engines = [GrainLoop()]
    O.step()
    assert O.iter == 1
