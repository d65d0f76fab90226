"""Hertz-Mindlin contacts, yielding asperities and rolling resistance in YADE, against YADE's own laws and formulas."""

from math import atan

import grus  # first, since it loads YADE
import numpy as np
import pytest
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    Bo1_Wall_Aabb,
    BondLedger,
    BondMat,
    BondTimeStepper,
    CohFrictMat,
    ForceResetter,
    FrictMat,
    GrainLoop,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Sphere_Sphere_ScGeom6D,
    Ig2_Wall_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_BondMat_BondMat_BondPhys,
    Ip2_CohFrictMat_CohFrictMat_CohFrictPhys,
    Ip2_FrictMat_FrictMat_MindlinPhys,
    Law2_ScGeom6D_CohFrictPhys_CohesionMoment,
    Law2_ScGeom_BondPhys_Bonded,
    Law2_ScGeom_MindlinPhys_Mindlin,
    NewtonIntegrator,
)

YOUNG, POISSON, FRICTION = 70e9, 0.25, 0.4
R1, R2 = 1e-3, 1.6e-3
STEP = 1e-6
ALPHA, ETA = 0.7, 0.15
HERTZ = {"contactLaw": "hertz", "young": YOUNG, "poisson": POISSON}
LINEAR = {"young": YOUNG, "poisson": POISSON}
ROLLING = {**LINEAR, "rollingStiffness": ALPHA, "rollingFriction": ETA}
YIELDING = {**LINEAR, "unloadingRatio": 3.0}


def bond_mat(**options) -> BondMat:
    return BondMat(density=2600, frictionAngle=atan(FRICTION), **options)


GRUS = [Ip2_BondMat_BondMat_BondPhys, Law2_ScGeom_BondPhys_Bonded]


def pair(material, ip2, law, wall=False) -> None:
    """Two spheres that touch, the first at rest, or a wall and a sphere; all motion is prescribed."""
    O.reset()
    O.materials.append(material)
    if wall:
        O.bodies.append(utils.wall(R1, axis=0, material=material))
    else:
        O.bodies.append(utils.sphere((0, 0, 0), R1, fixed=True, material=material))
    O.bodies.append(utils.sphere((R1 + R2, 0, 0), R2, fixed=True, material=material))
    moments = law is Law2_ScGeom6D_CohFrictPhys_CohesionMoment
    spheres = Ig2_Sphere_Sphere_ScGeom6D if moments else Ig2_Sphere_Sphere_ScGeom
    # YADE's law takes the increments of rotation, as Grus does.
    made = law(useIncrementalForm=True, always_use_moment_law=True) if moments else law()
    O.engines = [
        NewtonIntegrator(damping=0, warnNoForceReset=False),
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        InteractionLoop([spheres(), Ig2_Wall_Sphere_ScGeom()], [ip2()], [made]),
    ]
    O.dt = STEP


# Overlap [m] and angle [rad] that are gone through, and in how many steps: press, shear, slide, let go a little, turn
# back and slide the other way.
PATH = [
    (2e-6, (0, 0, 0), 20),
    (0, (0, 0, 2e-4), 20),
    (0, (0, 1e-3, 2e-3), 40),
    (-8e-7, (0, 0, -1e-4), 20),
    (3e-7, (0, -1e-3, -4e-3), 60),
    (-1.4e-6, (0, 0, 1e-4), 20),
]


def follow(path=PATH, both: float = 0.0) -> list[np.ndarray]:
    """Forces and torques on both bodies after each step; the first turns by `both` times the angle of the second."""
    found = []
    for approach, angle, steps in path:
        one, two = (body.state for body in O.bodies)
        two.vel = (-approach / steps / STEP, 0, 0)
        spin = np.array(angle) / steps / STEP
        two.angVel = tuple(spin)
        if both:
            one.angVel = tuple(both * spin)
        for _ in range(steps):
            O.step()
            found.append(
                np.concatenate([list(o(i)) for o in (O.forces.f, O.forces.t) for i in (0, 1)])
            )
    return found


def agree(found, expected, tolerance=1e-6) -> None:
    found, expected = np.array(found), np.array(expected)
    assert np.abs(expected).max(axis=0).max() > 0
    for part in (slice(0, 6), slice(6, 12)):
        size = np.abs(expected[:, part]).max()
        np.testing.assert_allclose(found[:, part], expected[:, part], rtol=0, atol=tolerance * size)


@pytest.mark.parametrize("wall", [False, True])
def test_hertz_agrees_with_yades_mindlin(wall):
    rock = FrictMat(young=YOUNG, poisson=POISSON, frictionAngle=atan(FRICTION), density=2600)
    pair(rock, Ip2_FrictMat_FrictMat_MindlinPhys, Law2_ScGeom_MindlinPhys_Mindlin, wall)
    expected = follow()
    pair(bond_mat(**HERTZ), *GRUS, wall)
    found = follow()
    sliding = [np.hypot(f[4], f[5]) > 0.999 * FRICTION * abs(f[3]) for f in expected]
    assert 20 < sum(sliding) < len(sliding) - 20
    if wall:  # YADE's law turns the sphere with another arm there: docs/theory/contact.md
        found, expected = (np.array(rows)[:, :6] for rows in (found, expected))
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * np.abs(expected).max())
    else:
        agree(found, expected)


def test_rolling_agrees_with_yades_cohfrict():
    rock = CohFrictMat(
        density=2600,
        frictionAngle=atan(FRICTION),
        isCohesive=False,
        momentRotationLaw=True,
        alphaKr=ALPHA,
        alphaKtw=0,
        etaRoll=ETA,
        etaTwist=0,
        **LINEAR,
    )
    pair(rock, Ip2_CohFrictMat_CohFrictMat_CohFrictPhys, Law2_ScGeom6D_CohFrictPhys_CohesionMoment)
    # Counter-rotation rolls the two on each other without slip.
    expected = follow(both=-R2 / R1)
    pair(bond_mat(**ROLLING), *GRUS)
    found = follow(both=-R2 / R1)
    agree(found, expected)
    turning = [
        np.linalg.norm(f[6:9] + f[9:]) for f in found
    ]  # forces alone give the spheres torques of one sense
    assert max(turning) > 0


def test_unloading_along_the_steeper_line():
    pair(bond_mat(**YIELDING), *GRUS)
    ledger = BondLedger()
    O.engines[-1].lawDispatcher.functors[0].ledger = ledger
    O.engines = [*O.engines, ledger]
    follow([(2e-6, (0, 0, 0), 100)])
    phys = O.interactions[0, 1].phys
    kn, top = phys.kn, 2e-6
    assert phys.normalForce.norm() == pytest.approx(kn * top, rel=1e-9)
    follow([(-5e-7, (0, 0, 0), 50)])
    assert phys.normalForce.norm() == pytest.approx(kn * (top - 3 * 5e-7), rel=1e-9)
    follow([(-1e-7, (0, 0, 0), 10), (1e-7, (0, 0, 0), 10), (5e-7, (0, 0, 0), 50)])
    assert phys.normalForce.norm() == pytest.approx(kn * top, rel=1e-9)
    assert phys.largestOverlap == pytest.approx(top, rel=1e-9)
    assert ledger.slidingWork == pytest.approx(0.5 * kn * top**2 * (1 - 1 / 3), rel=1e-9)
    assert phys.elasticEnergy() == pytest.approx(0.5 * kn * top**2 / 3, rel=1e-9)


@pytest.mark.parametrize("options", [HERTZ, YIELDING, ROLLING, {**HERTZ, **ROLLING}])
def test_critical_step_follows_the_tangent_stiffness(options):
    pair(bond_mat(**options), *GRUS)
    pressed = follow([(4e-6, (0, 0, 0), 10)])[-1][3]
    eased = follow([(-1e-9, (0, 0, 0), 1)])[-1][3]
    # One body that moves along the normal against one that cannot: 2 / root(k / m).
    O.bodies[1].state.blockedDOFs = "yzXYZ"
    expected = 2 * (O.bodies[1].state.mass / ((pressed - eased) / 1e-9)) ** 0.5
    assert BondTimeStepper().critical() == pytest.approx(expected, rel=1e-3)


def test_a_contact_without_force_limits_the_step_too():
    pair(bond_mat(**HERTZ), *GRUS)
    O.bodies[1].state.blockedDOFs = "yzXYZ"
    follow([(1e-12, (0, 0, 0), 1)])
    k = 1.5 * O.interactions[0, 1].phys.hertzNormal * (1e-3 * R1) ** 0.5
    assert BondTimeStepper().critical() == pytest.approx(2 * (O.bodies[1].state.mass / k) ** 0.5)


def test_a_linear_wall_counts_as_rigid_for_a_hertz_sphere():
    stiff = []
    for wall in (bond_mat(kn=1e3, ks=1e3), bond_mat(contactLaw="hertz", young=1e30, poisson=0)):
        O.reset()
        O.materials.append(wall)
        rock = bond_mat(**HERTZ)
        O.materials.append(rock)
        O.bodies.append(utils.wall(0, axis=0, material=wall))
        O.bodies.append(utils.sphere((0.999 * R1, 0, 0), R1, fixed=True, material=rock))
        O.engines = [GrainLoop()]
        O.step()
        stiff.append(O.forces.f(1)[0])
    assert stiff[0] > 0
    assert stiff[0] == pytest.approx(stiff[1], rel=1e-9)


@pytest.mark.parametrize(
    "options, message",
    [
        ({"contactLaw": "mindlin"}, "BondMat.contactLaw = 'mindlin'; allowed: 'hertz', 'linear'"),
        ({"unloadingRatio": 0.5}, "BondMat.unloadingRatio = 0.5; allowed: 1 or more"),
        ({"rollingStiffness": -1.0}, "BondMat.rollingStiffness = -1; allowed: 0 or more"),
        ({"rollingFriction": -1.0}, "BondMat.rollingFriction = -1; allowed: 0 or more"),
        (
            {**HERTZ, "unloadingRatio": 2.0},
            "BondMat.unloadingRatio = 2; allowed: 1 with contactLaw",
        ),
        ({**HERTZ, "bond": "contact"}, "BondMat.bond = 'contact'; allowed: 'none' or 'parallel'"),
        ({**HERTZ, "poisson": 0.6}, "BondMat.young, poisson = .* at most 0.5"),
    ],
)
def test_bad_options_are_refused(options, message):
    with pytest.raises(ValueError, match=message):
        BondMat(**options)
