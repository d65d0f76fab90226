"""Grains moved as rigid bodies."""

import numpy as np

from grus.specimen import Specimen
from grus.specimen.rounding import on_grid


def fit_rigid(grains: Specimen, moved: np.ndarray) -> np.ndarray:
    """Positions (n, 3) [m] of the elements with each grain of `grains` turned and shifted to lie as in `moved` (n, 3).

    Least squares over the elements of a grain (Kabsch 1976, Acta Cryst. A32, 922): its shape is as before but for the
    rounding of `on_grid`.
    """
    placed = np.zeros_like(moved)
    dimension = grains.dimension
    for grain in range(grains.grain_count):
        own = np.flatnonzero(grains.grain == grain)
        here, there = grains.position[own, :dimension], moved[own, :dimension]
        middle, goal = here.mean(axis=0), there.mean(axis=0)
        left, _, right = np.linalg.svd((here - middle).T @ (there - goal))
        sense = np.ones(dimension)
        sense[-1] = np.sign(np.linalg.det(left @ right))
        placed[own, :dimension] = (here - middle) @ (left * sense) @ right + goal
    return on_grid(placed, float(grains.radius.min()))
