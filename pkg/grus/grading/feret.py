"""Feret widths: distances of the two parallel planes (or lines) between which a body just fits."""

import numpy as np
from scipy.spatial import ConvexHull

FLAT = 1e-9
"""Points this close to one plane, as a share of their extent, lie in it [-]."""


def principal_widths(points: np.ndarray) -> np.ndarray:
    """Principal Feret widths (d,) of the convex hull of points (n, d), d = 1, 2 or 3, [their unit].

    The first is the smallest width of all directions; the second is the smallest width at right
    angles to it, and so on. A box has its edges as principal widths, in rising order. Where several
    directions share the smallest width, the one with the smallest next width counts.
    """
    if points.shape[1] == 1:
        return np.ptp(points, axis=0)
    directions, width = _narrowest(points)
    rest = [principal_widths(points @ _complement(direction)) for direction in directions]
    return np.concatenate([[width], min(rest, key=lambda widths: widths[0])])


def _narrowest(points: np.ndarray) -> tuple[np.ndarray, float]:
    """Unit vectors (k, d) in which the hull is narrowest, and its width there.

    The width in a direction is the support of the difference body (all p_i - p_j); its smallest
    value is met on a facet of the hull of that body, so that no direction is missed.
    """
    dimension = points.shape[1]
    centred = points - points.mean(axis=0)
    padded = np.concatenate([centred, np.zeros((dimension, dimension))])
    spread, axes = np.linalg.svd(padded, full_matrices=False)[1:]
    if spread[-1] <= FLAT * spread[0]:
        return axes[-1:], 0.0
    corners = centred[ConvexHull(centred).vertices]
    differences = (corners[:, None, :] - corners[None, :, :]).reshape(-1, dimension)
    facets = ConvexHull(differences).equations
    widths = -facets[:, -1]
    tied = facets[widths <= widths.min() * (1 + FLAT), :-1]
    return np.unique(tied.round(9), axis=0), float(widths.min())


def _complement(direction: np.ndarray) -> np.ndarray:
    """Orthonormal columns (d, d - 1) at right angles to the direction (d,)."""
    return np.linalg.svd(direction[None, :])[2][1:].T
