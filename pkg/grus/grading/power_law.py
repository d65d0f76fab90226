"""Gradings of which the passing grows as a power of the size."""

import numpy as np
from scipy.optimize import brentq

from grus.grading.curve import Grading
from grus.grading.numbers import rms_diameter
from grus.specimen.require import require, require_positive

STEEPEST = 300.0
"""Largest exponent searched, in either sense; the grains then are nearly of one size."""


def power_law_passing(
    size: np.ndarray, smallest: float, largest: float, exponent: float
) -> np.ndarray:
    """Share by mass [-] finer than the sizes [m]: (d^a - d1^a) / (d2^a - d1^a) from d1 to d2.

    Its limit for the exponent a = 0 is ln(d/d1) / ln(d2/d1). Talbot & Richart (1923) with d1 = 0;
    a = 3 - D is a fractal set of grains of dimension D (Turcotte 1986).
    """
    ratio = np.log(np.clip(size, smallest, largest) / smallest)
    span = np.log(largest / smallest)
    if exponent == 0:
        return ratio / span
    return np.expm1(exponent * ratio) / np.expm1(exponent * span)


def power_law_grading(
    smallest: float, largest: float, exponent: float, points: int = 41
) -> Grading:
    """Grading with that passing between two sizes [m], at points equally spaced in log size.

    Raises GrusError unless 0 < smallest < largest, the exponent is finite and points >= 2.
    """
    require_positive("smallest", smallest, "m")
    require(smallest < largest < np.inf, "largest", largest, f"finite and above {smallest} m")
    require(abs(exponent) <= STEEPEST, "exponent", exponent, f"within -{STEEPEST:g}..{STEEPEST:g}")
    require(points >= 2, "points", points, "at least 2")
    sizes = np.geomspace(smallest, largest, points)
    passing = 100 * power_law_passing(sizes, smallest, largest, exponent)
    return Grading(sizes, np.append(passing[:-1], 100.0))


def power_law_of_rms(smallest: float, largest: float, rms: float, dimension: int) -> Grading:
    """Power-law grading between two sizes [m] whose grains have a given root-mean-square diameter.

    rms [m]: root of the mean of the squared diameters by number, see `rms_diameter`. In the plane
    the number of grains times pi rms^2 / 4 is their total area. Raises GrusError as
    `power_law_grading`, and when rms is not well inside (smallest, largest).
    """

    def excess(exponent: float) -> float:
        grading = power_law_grading(smallest, largest, exponent)
        return np.log(rms_diameter(grading, dimension) / rms)

    ends = [rms * np.exp(excess(exponent)) for exponent in (-STEEPEST, STEEPEST)]
    inside = ends[0] < rms < ends[1]
    require(inside, "rms", rms, f"between {ends[0]:.6g} and {ends[1]:.6g} m for these sizes")
    exponent = brentq(excess, -STEEPEST, STEEPEST, xtol=1e-12, rtol=1e-14)
    return power_law_grading(smallest, largest, exponent)
