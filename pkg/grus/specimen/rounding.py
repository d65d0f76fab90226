"""Lengths without their last digits."""

from math import frexp

import numpy as np

DIGITS = 26
"""Binary digits that are kept of a length as long as the radius of an element, 1e-8 of it."""


def on_grid(values: np.ndarray, radius: float) -> np.ndarray:
    """`values` [m] of any shape, rounded to a grid that is 2^-26 to 2^-25 of `radius` [m] wide.

    Mathematical functions differ in the last digit from one version of a library to the next, and grains that break or
    are pressed together make another test of that. What their motion starts from is therefore rounded, and then is the
    same everywhere, unless a value lies within rounding of the middle between two points of the grid.
    """
    width = 2.0 ** (
        frexp(radius)[1] - DIGITS
    )  # a power of two, so that nothing below is rounded but on purpose
    return np.rint(np.asarray(values) / width) * width
