"""The block of elements that every loop computes, and how its elements move."""

import math

import numpy as np

from grus.bench.cases import Case
from grus.specimen import Circle, Specimen, Sphere, Stamp, agglomerate

RADIUS = 1e-3  # of an element [m]
DENSITY = 2500  # [kg/m3]
STIFFNESS = 1e8  # of contact and bond [N/m]
UNBREAKABLE = 1e15  # [Pa], [N] or [N m]
SKIN = 0.2 * RADIUS  # gap up to which GrainLoop keeps a pair, so other codes too [m]


def block(case: Case) -> Specimen:
    """A disc or ball of elements in closest packing."""
    filled = math.pi / math.sqrt(12) if case.dimension == 2 else math.pi / math.sqrt(18)
    diameter = 2 * RADIUS * (case.elements / filled) ** (1 / case.dimension)
    outline = Circle(diameter) if case.dimension == 2 else Sphere(diameter)
    stamp = Stamp(mean=2.1 * RADIUS, deviation=0) if case.stamped else None
    return agglomerate(outline, element_radius=RADIUS, stamp=stamp, seed=1, grain=0)


def time_step(dimension: int) -> float:
    """Small against the period of an element [s]."""
    thickness = 1.0 if dimension == 2 else RADIUS
    return 0.1 * math.sqrt(DENSITY * RADIUS**2 * thickness / STIFFNESS)


def velocities(count: int, dimension: int) -> np.ndarray:
    """Small velocities (count, 3) of bodies [m/s], so that every bond has something to do."""
    velocity = 1e-3 * (np.random.default_rng(1).random((count, 3)) - 0.5)
    velocity[:, dimension:] = 0
    return velocity
