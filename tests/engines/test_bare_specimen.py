"""Spheres without bonds give the stress-strain curve of YADE's own FrictPhys, walls and law on the same packing.

Both integrate slip in their own way, and what they differ by goes to zero with the time step: steps five times as long set
the curves five times as far apart. Contacts that let go one after another spread it, so it grows with strain.
"""

import numpy as np
import pytest
from grus.scene import InteractionEngines  # loads YADE
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    Bo1_Wall_Aabb,
    BondMat,
    ForceResetter,
    FrictMat,
    GrainLoop,
    Ig2_Sphere_Sphere_ScGeom,
    Ig2_Wall_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_FrictMat_FrictMat_FrictPhys,
    Law2_ScGeom_FrictPhys_CundallStrack,
    NewtonIntegrator,
)

YOUNG, RATIO, FRICTION, DENSITY = 1e8, 0.4, 0.3, 2500
RADIUS, SPREAD, OVERLAP = 1e-3, 1e-3, 2e-3
ACROSS, LAYERS = 5, 7
SPEED, STEPS, LOOKS = 0.01, 2500, 10  # to a strain of 0.5 %
SAFETY = 0.01
DAMPING = 0.4


def yades() -> list:
    return [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
            [Ip2_FrictMat_FrictMat_FrictPhys()],
            [Law2_ScGeom_FrictPhys_CundallStrack()],
        ),
        NewtonIntegrator(damping=DAMPING),
    ]


def functors() -> list:
    return InteractionEngines().list + [NewtonIntegrator(damping=DAMPING)]


def loop() -> list:
    return [GrainLoop(damping=DAMPING, substeps=STEPS)]


def packing() -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Centres (n, 3) and radii (n,) of the closest packing, all a little different, and the box (3,) [m].

    Square layers, every other one in the hollows of those beside it: no sphere can buckle out of its place.
    """
    distance, random = 2 * RADIUS * (1 - OVERLAP), np.random.default_rng(4)
    centres = []
    for layer in range(LAYERS):
        shift, count = (layer % 2) / 2, ACROSS - layer % 2
        for i, j in np.ndindex(count, count):
            centres.append(distance * np.array([i + shift, j + shift, layer / np.sqrt(2)]))
    centres = np.array(centres)
    edge = RADIUS * (1 - OVERLAP)
    radii = RADIUS * (1 + SPREAD * (2 * random.random(len(centres)) - 1))
    return centres + edge, radii, centres.max(axis=0) + 2 * edge


def curve(material: type, engines: list) -> np.ndarray:
    """Forces on the top and the bottom platen and on one side (looks, 3) [N] as the platens close."""
    O.reset()
    # YADE's law gives the friction of a wall an arm that is longer by half the overlap, so these have none.
    for friction in (0.0, FRICTION):
        O.materials.append(
            material(young=YOUNG, poisson=RATIO, frictionAngle=friction, density=DENSITY)
        )
    centres, radii, box = packing()
    pairs = [(0.0, float(size)) for size in box]
    walls = [utils.wall(end, axis=i, material=0) for i, ends in enumerate(pairs) for end in ends]
    left, _, _, _, bottom, top = O.bodies.append(walls)
    for centre, radius in zip(centres.tolist(), radii.tolist()):
        O.bodies.append(utils.sphere(centre, radius, material=1))
    O.bodies[bottom].state.vel = (0, 0, SPEED)
    O.bodies[top].state.vel = (0, 0, -SPEED)
    O.engines = engines
    O.dt = SAFETY * np.sqrt(4 / 3 * np.pi * RADIUS**3 * DENSITY / (YOUNG * RADIUS))
    forces = []
    for _ in range(LOOKS):
        O.run(STEPS, True)
        force = O.forces.f
        forces.append([force(top)[2], -force(bottom)[2], -force(left)[0]])
    return np.array(forces)


def sliding_share() -> float:
    """Share of the contacts between spheres at the limit of friction, with YADE's law."""
    own = [one for one in O.interactions if one.isReal and one.id1 > 5 and one.id2 > 5]
    limit = np.tan(FRICTION) * np.array([one.phys.normalForce.norm() for one in own])
    return float((np.array([one.phys.shearForce.norm() for one in own]) > 0.999 * limit).mean())


@pytest.fixture(scope="module")
def expected() -> np.ndarray:
    forces = curve(FrictMat, yades())
    assert 0.1 < sliding_share() < 0.9
    return forces


@pytest.mark.parametrize("engines", [functors, loop])
def test_curve_is_that_of_yades_own_engines(engines, expected):
    found = curve(BondMat, engines())
    np.testing.assert_allclose(found, expected, rtol=0, atol=1e-6 * expected.max())
