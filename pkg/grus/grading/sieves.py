"""Sieves: their openings as text, and a standard series of them."""

import numpy as np

from grus.card.errors import Problem
from grus.card.interval import POSITIVE
from grus.card.quantity import Quantity
from grus.errors import GrusError, one_line
from grus.specimen.require import require

LENGTH = Quantity({"m": "a length"}, POSITIVE, "9.5 mm")
STEPS = 20
"""Sieves in a factor of ten of the series."""


def sieve_series(low: float, high: float) -> np.ndarray:
    """Openings 10^(i/20) m, i whole, from the largest below `low` to the first that `high` passes.

    low, high: smallest and largest grain size [m]. This is the series R20 of ISO 565, not rounded.
    Gradings of one specimen at different times share its openings.
    """
    require(0 < low <= high < np.inf, "sizes", (low, high), "finite, > 0 m and rising")
    # A size that equals an opening but for rounding counts as equal to it.
    first, last = np.ceil(STEPS * np.log10([low, high]) - 1e-9)
    openings = 10 ** (np.arange(first - 1, last + 1) / STEPS)
    openings[-1] = max(openings[-1], high)
    return openings


def opening(sieve: float | str) -> float:
    """Opening [m] of a sieve given as a number in m, or as a text with unit such as "9.5 mm".

    Raises GrusError for a text that is no length.
    """
    if not isinstance(sieve, str):
        return sieve
    try:
        return float(LENGTH.read(sieve))
    except Problem as problem:
        found = f"{problem.reason}; allowed: {problem.allowed}"
        raise GrusError(f"sieve = {one_line(sieve)}: {found}") from None
