"""Bonds in parallel under one dead load: a bar of spheres that hangs on fixed spheres, pulled by a permanent force."""

import grus  # noqa: F401  first, since it loads YADE
import numpy as np
from yade import O, utils
from yade.wrapper import BondAgeing, BondMat, BondTimeStepper, NewtonIntegrator

from grus.scene import InteractionEngines

RADIUS = 0.01


class Bundle:
    """Bonds with the given tensile strengths [Pa] that share `force` [N] equally, at rest.

    thickness: of a plane bundle [m]; 0: spheres. ageing: attributes of the BondAgeing.
    """

    def __init__(
        self, strengths: list[float], force: float, thickness: float = 0, **ageing: object
    ) -> None:
        O.reset()
        O.trackEnergy = True
        number = len(strengths)
        material = BondMat(
            density=2500,
            kn=1e7,
            ks=1e7,
            bond="parallel",
            bondStiffness="total",
            bondKn=1e7,
            bondKs=1e7,
            tensileStrength=1e12,
            shearStrength=1e12,
            thickness=thickness,
        )
        O.materials.append(material)
        places = [(3 * RADIUS * i, 0, 0) for i in range(number)]
        top = O.bodies.append([utils.sphere(p, RADIUS, fixed=True) for p in places])
        hanging = [utils.sphere((x, -2 * RADIUS, 0), RADIUS) for x, _, _ in places]
        if number > 1:
            bar, self.members = O.bodies.appendClumped(hanging)
        else:
            self.members = O.bodies.append(hanging)
            bar = self.members[0]
        O.bodies[bar].state.blockedDOFs = "xzXYZ"
        for body in O.bodies:
            if not body.isClump:
                body.state.grain = 0
        self.interactions = InteractionEngines()
        newton = NewtonIntegrator(damping=0.8, gravity=(0, 0, 0))
        O.engines = self.interactions.list + [newton]
        O.dt = 0
        self.interactions.reach(1.01)
        self.interactions.ip2.bonding = True
        O.step()
        self.interactions.ip2.bonding = False
        self.interactions.reach(1)
        self.bonds = [O.interactions[a, b].phys for a, b in zip(top, self.members)]
        assert all(bond.bonded for bond in self.bonds)
        for member in self.members:
            O.forces.setPermF(member, (0, -force / number, 0))
        O.dt = 0.3 * BondTimeStepper().critical()
        O.run(20_000, True)
        for bond, strength in zip(self.bonds, strengths):
            bond.tensileStrength = strength
        self.ageing = BondAgeing(
            **dict(ledger=self.interactions.ledger, unbalancedLimit=1e-10, quietSteps=500) | ageing
        )
        O.engines = O.engines + [self.ageing]

    @property
    def stress(self) -> float:
        """Tension of the strongest bond [Pa]."""
        return float(np.max([bond.tension() for bond in self.bonds]))
