"""Measures of breakage from the grading before and after."""

from dataclasses import dataclass

import numpy as np
from scipy.integrate import trapezoid

from grus.grading.curve import Grading
from grus.grading.numbers import mass_moments
from grus.grading.power_law import power_law_passing
from grus.specimen.require import require, require_positive

SILT = 74e-6
"""Hardin's lower limit of the sizes that break [m]."""
FRACTAL_DIMENSION = 2.6
"""Of the ultimate grading, after Einav (2007)."""
SURFACE = {2: 4.0, 3: 6.0}
"""Surface over volume of a disc (its mantle) and of a sphere, times the diameter."""


@dataclass(frozen=True)
class Breakage:
    """All measures of one pair of gradings; see the functions of these names."""

    hardin: float
    einav: float
    marsal: float
    lee_farhoomand: float
    new_surface: float

    @classmethod
    def between(
        cls,
        before: Grading,
        after: Grading,
        *,
        dimension: int,
        smallest: float,
        fractal_dimension: float = FRACTAL_DIMENSION,
        cutoff: float = SILT,
        sieves: np.ndarray | None = None,
    ) -> "Breakage":
        """Raises GrusError as the functions do."""
        return cls(
            hardin=hardin(before, after, cutoff),
            einav=einav(before, after, smallest, fractal_dimension),
            marsal=marsal(before, after, sieves),
            lee_farhoomand=lee_farhoomand(before, after),
            new_surface=new_surface(before, after, dimension),
        )


def hardin(before: Grading, after: Grading, cutoff: float = SILT) -> float:
    """Relative breakage Br = Bt / Bp [-] of Hardin (1985).

    Areas over log10 d, above the cut-off [m]: Bt between the two curves, Bp between the curve
    before and 100 %. 0 without breakage, 1 when all grains are finer than the cut-off.
    Raises GrusError when no grain before was larger than the cut-off, or when a curve is not known
    down to it.
    """
    require_positive("cutoff", cutoff, "m")
    top = _largest(before, after)
    require(cutoff < before.size_at(100), "cutoff", cutoff, f"below {before.size_at(100):g} m")
    potential = np.log10(top / cutoff) - _area(before, cutoff, top)
    return float((_area(after, cutoff, top) - _area(before, cutoff, top)) / potential)


def einav(
    before: Grading,
    after: Grading,
    smallest: float,
    fractal_dimension: float = FRACTAL_DIMENSION,
) -> float:
    """Relative breakage Br = Bt / Bp [-] of Einav (2007).

    Areas over log10 d: Bt between the curves before and after, Bp between the curve before and the
    ultimate grading, of which the share (d^(3-a) - d1^(3-a)) / (d2^(3-a) - d1^(3-a)) passes; a is
    the fractal dimension (in space; a plane cut has a - 1 and the same exponent), d1 the `smallest`
    size that breakage leaves [m], d2 the largest before. 0 without breakage, 1 at the ultimate
    grading. Raises GrusError when smallest is not below d2, a not in (0, 3), a curve not known
    down to smallest, or the grading before as fine as the ultimate.
    """
    require_positive("smallest", smallest, "m")
    largest, alpha = before.size_at(100), fractal_dimension
    require(smallest < largest, "smallest", smallest, f"below {largest:g} m")
    require(0 < alpha < 3, "fractal_dimension", alpha, "in (0, 3)")
    potential = _ultimate_area(smallest, largest, 3 - alpha) - _area(before, smallest, largest)
    require(potential > 0, "grading before", "as fine as the ultimate", "coarser")
    total = _area(after, smallest, largest) - _area(before, smallest, largest)
    return float(total / potential)


def marsal(before: Grading, after: Grading, sieves: np.ndarray | None = None) -> float:
    """Breakage Bg [%] of Marsal (1967): the sum of all decreases of the share retained on a sieve.

    sieves (k,): openings [m], rising; those of the curve before by default. More sieves give a
    larger Bg, so only values of one set can be compared. 0 without breakage, below 100.
    """
    openings = before.sizes if sieves is None else np.asarray(sieves, dtype=float)
    rising = openings.ndim == 1 and openings.size > 0 and bool((np.diff(openings) > 0).all())
    require(rising and openings[0] > 0, "sieves", openings.tolist(), "rising, > 0 m")
    change = np.diff(
        before.passing_at(openings) - after.passing_at(openings), prepend=0.0, append=0.0
    )
    return float(np.maximum(change, 0).sum())


def lee_farhoomand(before: Grading, after: Grading) -> float:
    """Relative breakage D15i / D15f [-] of Lee & Farhoomand (1967); 1 without breakage."""
    return before.d15 / after.d15


def new_surface(before: Grading, after: Grading, dimension: int) -> float:
    """Surface that breakage made, per volume of solids [m2/m3], for round grains of these sizes.

    The specific surface of a grading is the integral of 6/d (spheres) or 4/d (the mantle of discs)
    over the mass (compare Miura & O-hara 1979). True fragments have more surface than round ones.
    Raises GrusError when something passes the smallest sieve of a curve.
    """
    require(dimension in SURFACE, "dimension", dimension, "2 or 3")
    return SURFACE[dimension] * float(
        mass_moments(after, -1).sum() - mass_moments(before, -1).sum()
    )


def _largest(before: Grading, after: Grading) -> float:
    return max(before.sizes[-1], after.sizes[-1])


def _area(grading: Grading, low: float, high: float) -> float:
    """Area below the curve between two sizes [m] over log10 d, passing as a share of 1."""
    inside = grading.sizes[(grading.sizes > low) & (grading.sizes < high)]
    sizes = np.concatenate([[low], inside, [high]])
    return float(trapezoid(grading.passing_at(sizes) / 100, np.log10(sizes)))


def _ultimate_area(smallest: float, largest: float, exponent: float) -> float:
    """Area below `power_law_passing` over log10 d between its ends, exactly."""
    span = np.log(largest / smallest)
    area = 1 / exponent - span / np.expm1(exponent * span)
    return float(area / np.log(10))
