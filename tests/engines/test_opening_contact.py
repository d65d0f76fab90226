"""What a contact still holds when it opens is booked as work of sliding."""

import grus  # noqa: F401  loads YADE
import pytest
from yade import O, utils
from yade.wrapper import BondMat, NewtonIntegrator

from grus.scene import InteractionEngines

KS = 1e6  # of one body; two in series make the contact


def test_shear_energy_of_a_pair_that_is_pulled_apart():
    O.materials.append(BondMat(kn=2e6, ks=KS, frictionAngle=0.8))
    ids = [O.bodies.append(utils.sphere((x, 0, 0), 1.0, fixed=True)) for x in (0.0, 1.999)]
    moving = O.bodies[ids[1]].state
    engines = InteractionEngines()
    O.engines = engines.list + [NewtonIntegrator(damping=0)]
    O.dt = 1e-3
    for velocity in ((-0.1, 0, 0), (0, 0.02, 0)):  # press, then shear below the friction limit
        moving.vel = velocity
        O.run(10, True)
    moving.vel = 3 * moving.pos / moving.pos.norm()  # apart within one step, along the normal
    O.run(3, True)
    # ScGeom takes the slip at the spheres' surface, which is 2 m / 1.998 m of that of the centres.
    slip = 0.02 * 10 * O.dt * 2 / 1.998
    assert not any(i.isReal for i in O.interactions)
    assert engines.ledger.slidingWork == pytest.approx(0.5 * (KS / 2) * slip**2, rel=1e-4)
