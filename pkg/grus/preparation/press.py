"""Grains between walls under a servo: what compaction and seating have in common."""

from math import atan, prod

import numpy as np
from yade import O
from yade.wrapper import BondMat, OedometerServo

from grus.card import Card
from grus.errors import GrusError
from grus.preparation.prepared import outline_volume
from grus.preparation.walls import add_walls, wall_box
from grus.scene import CALMING, GrainEngines, insert, set_damping, stop_grains
from grus.specimen import Specimen
from grus.specimen.clump_properties import clump_volume

LOOK = 50
"""Time steps between two looks at the void ratio, and of the servo at the unbalanced force."""
CALM = 500
"""Time steps between two looks at the kinetic energy of grains that are to come to rest."""
PAST = 0.5
"""Share of a peak of their kinetic energy at which they are stopped."""
QUIET = 500
"""Time steps at rest in a row that count as rest."""
NEARER, FINE = 0.1, 0.1
"""At most, the void ratio changes by these shares of its distance from where it is to stop, and of its tolerance,
between two looks."""
MOST_STEPS = 1_000_000


class Press:
    """A specimen in a box of frictionless walls as stiff as its elements, in the current YADE scene, emptied first.

    The platens are driven by an OedometerServo. Nothing is bonded unless the caller does it.
    """

    def __init__(
        self,
        card: Card,
        specimen: Specimen,
        corners: np.ndarray,
        material: BondMat,
        speed: float,
        skin: float = 0,
    ) -> None:
        p = card.preparation
        self.card, self.specimen, self.material = card, specimen, material
        O.reset()
        stiffness = element_stiffness(material, card.element.radius)
        walls = BondMat(label="wall", kn=stiffness, ks=0, thickness=card.thickness or 0)
        walls.frictionAngle = 0
        self.walls = add_walls(*corners, walls)
        self.ids = insert(specimen, material)
        self.engines = GrainEngines("GrainLoop", p.damping, p.time_step_safety, skin=skin)
        breadth = np.subtract(corners[1], corners[0])[:-1]
        self.servo = OedometerServo(
            bottom=self.walls[-1][0],
            top=self.walls[-1][1],
            sides=[wall for pair in self.walls[:-1] for wall in pair],
            axis=card.dimension - 1,
            area=self._platen_area(),
            sideBreadth=card.thickness if card.dimension == 2 else float(breadth.mean()),
            solidVolume=outline_volume(specimen),
            maxSpeed=speed,
            unbalancedLimit=p.unbalanced_limit,
            quietSteps=QUIET,
            lookInterval=LOOK,
            ledger=self.engines.ledger,
        )
        self.stepper = self.engines.stepper
        self.stepper.maxDt = _longest_step(specimen, stiffness, card.element.density)
        self.engines.start([self.servo])

    @property
    def void_ratio(self) -> float:
        """By the outlines, now [-]."""
        lower, upper = wall_box(self.walls)
        return self.servo.area * float(upper[-1] - lower[-1]) / self.servo.solidVolume - 1

    def bond(self) -> None:
        """Makes the bonds of the specimen, in a step without time, which neither servo nor stepper would stand."""
        self.engines.bond(self.specimen)
        self.engines.start([self.servo])

    def to_rest(self) -> None:
        """Runs until the grains rest under the seating stress.

        Meanwhile damping is strong, and grains are stopped each time that their kinetic energy is well past a peak: slow
        waves through the whole specimen, and grains that fly between others, take many times longer to die out by
        themselves. Raises GrusError when they do not come to rest.
        """
        self.servo.begin(self.card.preparation.seating_stress)
        set_damping(CALMING)
        peak = 0.0
        for _ in range(MOST_STEPS // CALM):
            self.engines.run(CALM)
            if self.servo.done:
                set_damping(self.card.preparation.damping)
                return
            peak = max(peak, self.servo.kinetic)
            if self.servo.kinetic < PAST * peak:
                stop_grains()
                peak = 0.0
        raise GrusError(
            f"{self.card.source}: preparation.unbalanced_limit = {self.card.preparation.unbalanced_limit:g}: "
            f"{self.servo.unbalanced:.3g} after {MOST_STEPS} steps, the grains do not come to rest; allowed: more"
        )

    def run(self, count: int, stop_at: float | None = None) -> bool:
        """Runs `count` steps under the seating stress, or until all rest, or until the void ratio falls to `stop_at`.

        The platens slow down on the way to `stop_at`, and stay slow after that. Returns whether it was reached.
        """
        if self.servo.stage < 0 or self.servo.done:
            self.servo.begin(self.card.preparation.seating_stress)
        for _ in range(count // LOOK):
            if stop_at is not None:
                self._slow_down(self.void_ratio - stop_at)
            self.engines.run(LOOK)
            if self.servo.done or (stop_at is not None and self.void_ratio <= stop_at):
                break
        return stop_at is not None and self.void_ratio <= stop_at

    def resists(self, share: float) -> bool:
        """Whether the stress on both platens is at least this share of the seating stress."""
        least = min(self.servo.topStress, self.servo.bottomStress)
        return least >= share * self.card.preparation.seating_stress

    def _slow_down(self, distance: float) -> None:
        p = self.card.preparation
        change = NEARER * max(distance, 0) + FINE * p.void_ratio_tolerance
        lower, upper = wall_box(self.walls)
        way = change / (1 + self.void_ratio) * float(upper[-1] - lower[-1])
        self.servo.maxSpeed = min(p.compaction_speed, way / (2 * LOOK * O.dt))

    def expect(self, unbalanced: float, quiet: int) -> None:
        """Sets what counts as rest: an unbalanced force [-], for so many time steps."""
        self.servo.unbalancedLimit, self.servo.quietSteps = unbalanced, quiet

    def open(self, ways: list[float], count: int) -> None:
        """Moves the walls across each axis apart by its way [m] in `count` time steps, waits as long, stops all grains."""
        self.servo.dead = True
        for share in (1.0, 0.0):
            for axis, (pair, way) in enumerate(zip(self.walls, ways)):
                for wall, sign in zip(pair, (-1, 1)):
                    velocity = [0.0, 0.0, 0.0]
                    velocity[axis] = sign * share * way / (2 * count * O.dt)
                    O.bodies[wall].state.vel = velocity
            self.engines.run(count)
        stop_grains()
        self.servo.area = self._platen_area()
        self.servo.dead = False

    def _platen_area(self) -> float:
        lower, upper = wall_box(self.walls)
        breadth = np.subtract(upper, lower)[:-1]
        return float(prod(breadth)) * (self.card.thickness if self.card.dimension == 2 else 1)

    def movable(self) -> list:
        """Clumps, and elements that stand alone."""
        walls = {wall for pair in self.walls for wall in pair}
        return [body for body in O.bodies if body.id not in walls and not body.isClumpMember]

    def set_stiffness(self, stiffness: float) -> None:
        """Changes the stiffness of all elements, and of the walls, which are as stiff [N/m]."""
        factor = stiffness / self.material.kn
        for part in [*O.materials, *(contact.phys for contact in O.interactions)]:
            part.kn *= factor
            part.ks *= factor
        self.stepper.maxDt /= factor**0.5
        O.dt = min(self.stepper.maxDt, self.stepper.safety * self.stepper.critical())

    def set_friction(self, coefficient: float) -> None:
        """Changes the friction between grains; the walls have none."""
        self.material.frictionAngle = atan(coefficient)
        walls = {wall for pair in self.walls for wall in pair}
        for interaction in O.interactions:
            if interaction.id1 not in walls and interaction.id2 not in walls:
                interaction.phys.tangensOfFrictionAngle = coefficient

    @property
    def leaks(self) -> bool:
        """Whether the centre of an element is outside the box."""
        lower, upper = wall_box(self.walls)
        centre = self.positions()[:, : len(lower)]
        return bool(((centre < lower) | (centre > upper)).any())

    def positions(self) -> np.ndarray:
        """Centres (n, 3) of the elements now [m]."""
        return np.array([O.bodies[one].state.pos for one in self.ids])


def element_stiffness(material: BondMat, radius: float) -> float:
    """Normal stiffness [N/m] of an element of `radius` [m]."""
    return material.kn if material.kn >= 0 else 2 * material.young * radius


def _longest_step(specimen: Specimen, stiffness: float, density: float) -> float:
    """Time step [s] that is safe for the smallest clump when contacts form before the stepper looks again."""
    lightest = density * float(clump_volume(specimen).min())
    return float(0.5 * np.sqrt(lightest / stiffness))
