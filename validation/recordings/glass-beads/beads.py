"""Unbonded spheres in an oedometer: prepared at a stress and porosity, then loaded as in the recording.

A card has no word for a grain that is a single element, so the scene is put together here, of the parts that tests of
cards are made of.
"""

from dataclasses import dataclass
from math import atan

import grus  # loads YADE  # noqa: F401
import numpy as np
from grus.preparation.exo import place
from grus.preparation.walls import add_walls, wall_box
from grus.record import Record
from grus.scene import GrainEngines, insert
from grus.specimen import Specimen
from scipy.spatial import cKDTree
from yade import O
from yade.wrapper import BondMat, OedometerServo

COUNT, SEED = 500, 1
DIAMETER, SPREAD = (
    2e-3,
    0.15,
)  # m, and half the range over the mean; sizes only scale a test of linear contacts
WIDTH = 8 * DIAMETER
LOOSE = 0.35  # solid fraction at the start
DENSITY = 2500.0  # kg/m3
SHEAR_RATIO = (
    0.85  # shear over normal stiffness of glass spheres (Mindlin 1949, Poisson ratio 0.25)
)
WALLS = 6
PACKING_MODULUS = 12e9  # Pa; one for all linear contacts, since another leads to another packing
POISSON = 0.22  # of glass, in Hertz contacts
MARGIN, POINTS = 1.5, 100_000
WALL = 100.0  # stiffness of the walls over that of a sphere
DAMPING = 0.4
CLOSING = (
    2.0  # m/s, in the preparation: the stress of the impacts is a thousandth of the first stress
)
INERTIAL = 3e-4  # inertial number of the test at the first stress


@dataclass(frozen=True)
class Beads:
    """modulus [Pa]: by it a sphere of radius R has the stiffness 2 E R; with `hertz` Young's modulus of the spheres.
    friction: coefficient. packing_friction: that of the preparation."""

    modulus: float
    friction: float
    packing_friction: float
    hertz: bool = False


def loaded(beads: Beads, stresses: list[float]) -> tuple[Record, float]:
    """Brings spheres to rest under the first of the axial `stresses` [Pa], then goes from one to the next.

    Returns stage (0: at rest under the first stress), stresses [Pa] and strain since then, and the porosity
    under the first stress, away from the walls.
    """
    specimen, box = _loose()
    O.reset()
    stiffness = PACKING_MODULUS * DIAMETER
    steel = BondMat(label="wall", kn=WALL * stiffness, ks=0, frictionAngle=0)
    walls = add_walls(np.zeros(3), box, steel)
    glass = BondMat(
        label="glass",
        contactLaw="hertz" if beads.hertz else "linear",
        young=beads.modulus if beads.hertz else PACKING_MODULUS,
        poisson=POISSON if beads.hertz else SHEAR_RATIO,
        frictionAngle=atan(beads.packing_friction),
        density=DENSITY,
        bond="none",
    )
    ids = insert(specimen, glass)
    engines = GrainEngines("GrainLoop", DAMPING, safety=0.8)
    mass = DENSITY * np.pi / 6 * (DIAMETER * (1 - SPREAD)) ** 3
    engines.stepper.maxDt = 0.5 * float(np.sqrt(mass / (2 * stiffness)))
    servo = OedometerServo(
        bottom=walls[2][0],
        top=walls[2][1],
        sides=walls[0] + walls[1],
        axis=2,
        area=WIDTH**2,
        sideBreadth=WIDTH,
        solidVolume=float(np.pi / 6 * (specimen.grain_diameter**3).sum()),
        maxSpeed=CLOSING,
        unbalancedLimit=0.01,
        recordStress=0.01,
        recordStrain=1e-4,
        grainDiameter=DIAMETER,
        grainDensity=DENSITY,
        ledger=engines.ledger,
    )
    engines.start([servo])
    _stage(servo, stresses[0])
    _set_friction(glass, beads.friction)
    if not beads.hertz:
        _set_modulus(beads.modulus, engines)
    servo.maxSpeed = _test_speed(stresses[0], servo.height)
    _stage(servo, stresses[0])
    found = porosity(np.array([O.bodies[one].state.pos for one in ids]), specimen.radius, walls)
    for stress in stresses[1:]:
        _stage(servo, stress)
    return _record(servo), found


def porosity(centre: np.ndarray, radius: np.ndarray, walls: list[list[int]]) -> float:
    """Of the box without a margin of MARGIN diameters, where spheres lie looser, by points at random [-]."""
    lower, upper = (
        corner + sign * MARGIN * DIAMETER for corner, sign in zip(wall_box(walls), (1, -1))
    )
    points = lower + (upper - lower) * np.random.default_rng(SEED).random((POINTS, 3))
    distance, nearest = cKDTree(centre).query(points, k=4)
    return float((distance > radius[nearest]).all(axis=1).mean())


def _loose() -> tuple[Specimen, np.ndarray]:
    """Spheres at random without overlap in a box that they fill loosely, and its size (3,) [m]."""
    generator = np.random.default_rng(SEED)
    diameter = DIAMETER * (1 + SPREAD * (2 * generator.random(COUNT) - 1))
    height = float(np.pi / 6 * (diameter**3).sum()) / LOOSE / WIDTH**2
    box = np.array([WIDTH, WIDTH, height])
    number = np.arange(COUNT)
    return (
        Specimen(
            dimension=3,
            thickness=1.0,
            position=place(diameter / 2, box, generator),
            radius=diameter / 2,
            clump=number,
            grain=number,
            grain_diameter=diameter,
        ),
        box,
    )


def _test_speed(stress: float, height: float) -> float:
    """Of each platen [m/s]."""
    rate = INERTIAL / DIAMETER * np.sqrt(stress / DENSITY)
    return float(rate * height / 2)


def _stage(servo: OedometerServo, stress: float) -> None:
    servo.begin(stress)
    O.run(-1, True)


def _set_friction(glass: BondMat, coefficient: float) -> None:
    """Between spheres; walls stay smooth."""
    glass.frictionAngle = atan(coefficient)
    for contact in O.interactions:
        if min(contact.id1, contact.id2) >= WALLS:
            contact.phys.tangensOfFrictionAngle = coefficient


def _set_modulus(modulus: float, engines: GrainEngines) -> None:
    """Of spheres, walls and the contacts that there are."""
    factor = modulus / PACKING_MODULUS
    for body in O.bodies[0], O.bodies[WALLS]:
        for name in ("young", "kn", "ks"):
            value = getattr(body.material, name)
            if value > 0:
                setattr(body.material, name, factor * value)
    for contact in O.interactions:
        contact.phys.kn *= factor
        contact.phys.ks *= factor
    engines.stepper.maxDt /= factor**0.5
    O.dt = min(engines.stepper.maxDt, engines.stepper.safety * engines.stepper.critical())


def _record(servo: OedometerServo) -> Record:
    """From the end of the stage at the first stress on; stage 0 of the servo is the preparation."""
    stage = np.array(servo.recordStage) - 1
    first = int(np.flatnonzero(stage == 0)[-1])
    height = np.array(servo.recordHeight)[first:]
    columns = {
        "stage": stage[first:],
        "axial_stress": (np.array(servo.recordTop) + servo.recordBottom)[first:] / 2,
        "lateral_stress": np.array(servo.recordSide)[first:],
        "axial_strain": 1 - height / height[0],
    }
    units = {"axial_stress": "Pa", "lateral_stress": "Pa"}
    return Record(columns, {name: units.get(name, "1") for name in columns})
