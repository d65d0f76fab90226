"""Mean width of a body: the mean of its Feret diameters over all directions."""

from functools import lru_cache

import numpy as np

from grus.specimen import Mesh, Outline, Polygon

PLANE, SPACE = 90, 200
"""Number of directions over half a circle, and over half a sphere."""


@lru_cache(maxsize=None)
def directions(dimension: int) -> np.ndarray:
    """Unit vectors (k, dimension) spread evenly over half of all directions."""
    if dimension == 2:
        angle = (np.arange(PLANE) + 0.5) * np.pi / PLANE
        return np.column_stack([np.cos(angle), np.sin(angle)])
    # A Fibonacci lattice on the upper half of the sphere.
    number = np.arange(SPACE) + 0.5
    height = number / SPACE
    across, angle = np.sqrt(1 - height**2), np.pi * (1 + np.sqrt(5)) * number
    return np.column_stack([across * np.cos(angle), across * np.sin(angle), height])


def mean_width(points: np.ndarray, radius: float, dimension: int) -> float:
    """Mean width [m] of equal balls of `radius` [m] about points (n, 2 or 3) [m]."""
    along = points[:, :dimension] @ directions(dimension).T
    return float(np.ptp(along, axis=0).mean() + 2 * radius)


def outline_mean_width(outline: Outline) -> float:
    """Mean width of an outline [m]; of a circle or sphere its diameter."""
    if isinstance(outline, (Polygon, Mesh)):
        return mean_width(outline.vertices, 0.0, outline.dimension)
    return outline.equivalent_diameter
