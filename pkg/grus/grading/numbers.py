"""Numbers of grains in a grading, which is given by mass."""

import numpy as np

from grus.grading.curve import Grading
from grus.specimen.require import require, require_positive

UNIT_MEASURE = {2: np.pi / 4, 3: np.pi / 6}
"""Area of the circle and volume of the sphere of diameter 1."""


def mass_moments(grading: Grading, power: int) -> np.ndarray:
    """Integrals (k - 1,) of d^power over the mass between the sieves, of total mass 1.

    Raises GrusError when something passes the smallest sieve.
    """
    open_end = grading.passing[0]
    require(
        open_end == 0, "passing of the smallest sieve", open_end, "0 %, for a sum over all grains"
    )
    mass = grading.retained[1:] / 100
    if power == 0:
        return mass
    logs = np.log(grading.sizes)
    powers = np.exp(power * logs)
    return mass * np.diff(powers) / (power * np.diff(logs))


def rms_diameter(grading: Grading, dimension: int) -> float:
    """Root of the mean square of the diameters by number [m], of discs (2) or spheres (3)."""
    require(dimension in UNIT_MEASURE, "dimension", dimension, "2 or 3")
    squares, numbers = (mass_moments(grading, power).sum() for power in (2 - dimension, -dimension))
    return float(np.sqrt(squares / numbers))


def sample_diameters(
    grading: Grading,
    dimension: int,
    generator: np.random.Generator,
    *,
    count: int | None = None,
    measure: float | None = None,
) -> np.ndarray:
    """Diameters (n,) of grains [m] in random order, whose grading by mass is close to the given.

    dimension: 2 for discs, 3 for spheres, all of one density.
    generator: of the stream that belongs to them; only `random` is called.
    count: the number n of grains; or measure: their total area [m2] or volume [m3], which is met
        to about the half of a mean grain, by the choice of n.

    Within a step of the curve the mass is spread evenly over log d, so the number goes with
    d^(-dimension). The cumulated number is cut into n equal parts and one grain is drawn from each
    (stratified sampling): a specimen of a hundred grains follows the curve to one or two per cent.
    Raises GrusError when something passes the smallest sieve, and unless just one of count and
    measure is given and makes a grain or more.
    """
    require((count is None) != (measure is None), "count, measure", (count, measure), "one of both")
    require(dimension in UNIT_MEASURE, "dimension", dimension, "2 or 3")
    number = mass_moments(grading, -dimension)
    if count is None:
        require_positive("measure", measure, f"m{dimension}")
        mean = UNIT_MEASURE[dimension] / number.sum()
        count = int(round(measure / mean))
        require(
            count >= 1, "measure", measure, f"enough for one mean grain, {mean:.4g} m{dimension}"
        )
    require(count >= 1 and count == int(count), "count", count, "a whole number, at least 1")
    count = int(count)
    below = np.concatenate([[0.0], np.cumsum(number)])
    below /= below[-1]
    place = (np.arange(count) + generator.random(count)) / count
    place = np.minimum(place, np.nextafter(1.0, 0.0))  # the sum above may round to 1
    step = np.searchsorted(below, place, side="right") - 1
    share = (place - below[step]) / (below[step + 1] - below[step])
    left, right = grading.sizes[step], grading.sizes[step + 1]
    # d^-dimension falls evenly over the step
    power = 1 + share * np.expm1(-dimension * np.log(right / left))
    diameter = np.clip(left * power ** (-1 / dimension), left, right)
    return diameter[np.argsort(generator.random(count), kind="stable")]
