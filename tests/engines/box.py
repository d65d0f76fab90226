"""A few grains in rows in a box: the smallest oedometer specimen."""

import numpy as np
from scenes import card
from yade import O, utils
from yade.wrapper import BondMat, BondTimeStepper, NewtonIntegrator, OedometerServo

from grus.scene import InteractionEngines, bond, grain_material, insert
from grus.specimen import Specimen, join
from grus.specimen.from_card import grain_from_card


def rows(model, columns: int = 1, count: int = 3) -> Specimen:
    """Grains on a square lattice, each touching the next one's outline."""
    d = 0.97 * model.agglomerate.diameter  # elements end short of the outline
    grains = [grain_from_card(model, i) for i in range(columns * count)]
    places = [(d * (i % columns), d * (i // columns), 0) for i in range(columns * count)]
    return join(grains, np.array(places))


class Box:
    """Grains, four walls that touch them, and a servo; plane, thickness 1 m."""

    def __init__(self, servo: dict | None = None, **overrides: object) -> None:
        self.model = card(**overrides)
        self.specimen = rows(self.model)
        O.reset()
        O.trackEnergy = True
        x, y = self.specimen.position[:, 0], self.specimen.position[:, 1]
        r = self.specimen.radius
        kn = self.model.contact.normal_stiffness
        O.materials.append(BondMat(label="wall", kn=kn, ks=kn, frictionAngle=0, thickness=1))
        ends = {0: ((x - r).min(), (x + r).max()), 1: ((y - r).min(), (y + r).max())}
        self.walls = {}
        for axis, pair in ends.items():
            walls = [utils.wall(float(end), axis=axis, material="wall") for end in pair]
            for wall in walls:
                wall.state.isDamped = False
            self.walls[axis] = list(O.bodies.append(walls))
        self.ids = insert(self.specimen, grain_material(self.model))
        interactions = InteractionEngines()
        settings = {
            "bottom": self.walls[1][0],
            "top": self.walls[1][1],
            "sides": self.walls[0],
            "area": float(np.ptp(ends[0])),
            "sideBreadth": 1.0,
            "solidVolume": float(np.pi * (self.specimen.grain_diameter**2).sum() / 4),
            "ledger": interactions.ledger,
            "maxSpeed": 0.3,
            "grainDiameter": self.model.agglomerate.diameter,
            "grainDensity": self.model.element.density,
            "quietSteps": 200,
        }
        self.servo = OedometerServo(**(settings | (servo or {})))
        stepper = BondTimeStepper()
        newton = NewtonIntegrator(damping=0.4, gravity=(0, 0, 0))
        O.engines = interactions.list + [newton]
        bond(self.specimen, interactions)
        O.engines = interactions.list + [stepper, self.servo, newton]
        O.dt = stepper.safety * stepper.critical()

    def stage(self, stress: float, most: int = 300_000) -> None:
        """Runs a stage to its end."""
        self.servo.begin(stress)
        O.run(most, True)
        assert self.servo.done, f"not at rest after {most} steps"
