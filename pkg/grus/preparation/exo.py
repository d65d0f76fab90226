"""Exo-spheres: the round holders in whose place the grains are put."""

import numpy as np
from yade import O
from yade.wrapper import BondMat, BondTimeStepper, NewtonIntegrator

from grus.card import Card
from grus.errors import GrusError
from grus.preparation.walls import add_walls
from grus.scene import InteractionEngines, insert
from grus.specimen import Specimen

STEPS, ITERATIONS = 40, 100
"""Steps of growth, and time steps of the scene in each."""
MOST_TRIES = 100_000
LARGEST_OVERLAP = 0.01
"""Of grown exo-spheres, over the radius of an element [-]."""
MOST_RESTS = 200


def place(
    radius: np.ndarray, size: np.ndarray, generator: np.random.Generator
) -> np.ndarray | None:
    """Centres (n, 3) [m] of spheres or discs at random in the box from 0 to `size` [m], without overlap.

    The largest come first, each at the first free place of those drawn. None when one finds no place.
    """
    centre = np.zeros((len(radius), 3))
    placed: list[int] = []
    for i in np.argsort(-radius, kind="stable"):
        for _ in range(MOST_TRIES):
            here = np.zeros(3)
            here[: len(size)] = radius[i] + (size - 2 * radius[i]) * generator.random(len(size))
            distance = np.linalg.norm(centre[placed] - here, axis=1)
            if (distance > radius[placed] + radius[i]).all():
                break
        else:
            return None
        centre[i] = here
        placed.append(i)
    return centre


def grow(card: Card, centre: np.ndarray, radius: np.ndarray, size: np.ndarray) -> np.ndarray:
    """Centres (n, 3) [m] of the exo-spheres after they have grown to their radii (n,) [m] in the box.

    They start from `preparation.start_factor` times these radii, without friction and shear stiffness; their stiffness
    grows with them, and they are cycled until they do not overlap. Uses the current scene, which is emptied first.
    Raises GrusError when they jam.
    """
    p = card.preparation
    first = _stiffness(card, float(radius.mean()))
    wall = first / 10 if p.wall_stiffness is None else _total(p.wall_stiffness, radius.mean())
    thickness = card.thickness or 0
    O.reset()
    add_walls(np.zeros(len(size)), size, BondMat(label="wall", kn=wall, ks=0, thickness=thickness))
    material = BondMat(
        label="exo-sphere", density=card.element.density, kn=first, ks=0, thickness=thickness
    )
    material.frictionAngle = O.materials[0].frictionAngle = 0
    ids = insert(_spheres(card, centre, p.start_factor * radius), material)
    interactions = InteractionEngines()
    interactions.bound.aabbEnlargeFactor = 1 / p.start_factor  # bounds of what they will grow to
    stepper = BondTimeStepper(safety=p.time_step_safety, maxDt=_longest_step(card, radius, first))
    O.engines = interactions.list + [stepper, NewtonIntegrator(damping=p.damping)]
    for grown in np.arange(1, STEPS + 1) / STEPS:
        factor = p.start_factor + grown * (1 - p.start_factor)
        for one, full in zip(ids, radius):
            O.bodies[one].shape.radius = float(factor * full)
        _harden(material, p.stiffness_growth ** (1 / STEPS))
        _cycle(ids)
    for _ in range(MOST_RESTS):
        _cycle(ids)
        if _largest_overlap() <= LARGEST_OVERLAP * card.element.radius:
            return np.array([O.bodies[one].state.pos for one in ids])
    raise GrusError(
        f"{card.source}: preparation.exo_solid_fraction = {solid_fraction(card):g}: the exo-spheres jam; allowed: less"
    )


def solid_fraction(card: Card) -> float:
    """Share of the box that the grown exo-spheres fill."""
    given = card.preparation.exo_solid_fraction
    return {2: 0.65, 3: 0.35}[card.dimension] if given is None else given


def _stiffness(card: Card, radius: float) -> float:
    given = card.preparation.normal_stiffness
    return (
        _total(card.contact.normal_stiffness, radius) / 6
        if given is None
        else _total(given, radius)
    )


def _total(stiffness: float, radius: float) -> float:
    """Stiffness of a sphere [N/m], also of one given as a modulus [Pa]."""
    return float(stiffness if stiffness.unit == "N/m" else 2 * stiffness * radius)


def _spheres(card: Card, centre: np.ndarray, radius: np.ndarray) -> Specimen:
    number = np.arange(len(radius))
    return Specimen(
        dimension=card.dimension,
        thickness=card.thickness or 1.0,
        position=centre,
        radius=radius,
        clump=number,
        grain=number,
        grain_diameter=2 * radius,
    )


def _longest_step(card: Card, radius: np.ndarray, stiffness: float) -> float:
    """Time step [s] of the smallest exo-sphere in a contact with another, for use before any touch."""
    smallest = card.preparation.start_factor * float(radius.min())
    volume = np.pi * smallest**2 * card.thickness if card.dimension == 2 else 4 * smallest**3
    return float(0.3 * np.sqrt(card.element.density * volume / stiffness))


def _cycle(ids: list[int]) -> None:
    """Lets overlaps push the exo-spheres apart, then stops them: nothing else would in free flight."""
    O.run(ITERATIONS, True)
    for one in ids:
        O.bodies[one].state.vel = (0, 0, 0)


def _harden(material: BondMat, factor: float) -> None:
    material.kn *= factor
    for interaction in O.interactions:
        interaction.phys.kn *= factor


def _largest_overlap() -> float:
    return max((i.geom.penetrationDepth for i in O.interactions), default=0.0)
