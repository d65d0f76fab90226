"""The order of O.interactions is one of history. The time step may not depend on it: a loaded scene has another history."""

from itertools import permutations

import grus  # noqa: F401  first, since it loads YADE
from yade import O, utils
from yade.wrapper import (
    Bo1_Sphere_Aabb,
    BondMat,
    BondTimeStepper,
    ForceResetter,
    Ig2_Sphere_Sphere_ScGeom,
    InsertionSortCollider,
    InteractionLoop,
    Ip2_BondMat_BondMat_BondPhys,
    Law2_ScGeom_BondPhys_Bonded,
    NewtonIntegrator,
)

STIFFNESS = (1.1e6, 0.7e5, 0.3e4)
"""Of the neighbours; their sum depends on its order in the last digit."""
PLACES = ((0.999, 0, 0), (0, 0.999, 0), (-0.6, -0.798, 0))


def critical_step(order: tuple[int, ...]) -> float:
    """Of a sphere that its neighbours have come to touch in this order."""
    O.reset()
    centre = BondMat(kn=1e6, ks=1e6, density=2600)
    O.bodies.append(utils.sphere((0, 0, 0), 0.5, material=centre))
    for stiffness, place in zip(STIFFNESS, PLACES):
        rock = BondMat(kn=stiffness, ks=stiffness, density=2600)
        far = tuple(3 * x for x in place)
        O.bodies.append(utils.sphere(far, 0.5, fixed=True, material=rock))
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0),
        InteractionLoop(
            [Ig2_Sphere_Sphere_ScGeom()],
            [Ip2_BondMat_BondMat_BondPhys()],
            [Law2_ScGeom_BondPhys_Bonded()],
        ),
        NewtonIntegrator(),
    ]
    O.dt = 0
    for number in order:
        O.bodies[1 + number].state.pos = PLACES[number]
        O.step()
    assert [one.id2 for one in O.interactions] == [1 + number for number in order]
    return BondTimeStepper().critical()


def test_critical_step_does_not_depend_on_the_order_of_contacts():
    assert len({critical_step(order) for order in permutations(range(3))}) == 1
