"""Fragments, gradings and measures of breakage.

Pure functions of specimens and numbers; nothing here needs YADE.
"""

from grus.grading.breakage import (
    Breakage,
    einav,
    hardin,
    lee_farhoomand,
    marsal,
    new_surface,
)
from grus.grading.curve import Grading
from grus.grading.fragment import Fragments
from grus.grading.numbers import rms_diameter, sample_diameters
from grus.grading.power_law import power_law_grading, power_law_of_rms
from grus.grading.sieves import sieve_series

__all__ = [
    "Breakage",
    "Fragments",
    "Grading",
    "einav",
    "hardin",
    "lee_farhoomand",
    "marsal",
    "new_surface",
    "power_law_grading",
    "power_law_of_rms",
    "rms_diameter",
    "sample_diameters",
    "sieve_series",
]
