"""[specimen]: the grains in the box of an oedometer, at the start of its test."""

from collections.abc import Iterator
from typing import Any

from grus.card.errors import Problem
from grus.card.interval import POSITIVE, Interval
from grus.card.presence import must_be_absent, must_be_given
from grus.card.pydantic_adapter import Section, key
from grus.card.quantity import Measure, Quantity
from grus.card.sieve import Passing, Sieves
from grus.card.values import Number, Whole

LENGTH = {"m": "a length"}
POWER_LAW = ("minimum_diameter", "maximum_diameter", "rms_diameter")
TABLE = ("sieve", "passing")
MOST_GRAINS = 100_000
NEEDED = "needed, unless sieve and passing are given"


class Specimen(Section):
    """Box, void ratio and grading; the diameter of a grain is its mean width."""

    width: Measure = key(Quantity(LENGTH, POSITIVE, "0.500 m"), "Width of the box.")
    height: Measure = key(
        Quantity(LENGTH, POSITIVE, "0.474 m"),
        "Height of the box at the void ratio asked for; the prepared one follows from the grains.",
    )
    depth: Measure | None = key(
        Quantity(LENGTH, POSITIVE, "0.500 m"),
        "Depth of the box.",
        default=None,
        default_text="needed for dimension 3, else left out",
    )
    void_ratio: float = key(
        Number(Interval(above=0, most=20)),
        "Void ratio at the start of the test, by the outlines of the grains.",
    )
    minimum_diameter: Measure | None = key(
        Quantity(LENGTH, POSITIVE, "9.5 mm"),
        "Diameter of the smallest grains of a power-law grading by mass.",
        default=None,
        default_text=NEEDED,
    )
    maximum_diameter: Measure | None = key(
        Quantity(LENGTH, POSITIVE, "19.1 mm"),
        "Diameter of its largest grains.",
        default=None,
        default_text=NEEDED,
    )
    rms_diameter: Measure | None = key(
        Quantity(LENGTH, POSITIVE, "12.6 mm"),
        "Root-mean-square diameter of its grains by number, which fixes the power.",
        default=None,
        default_text=NEEDED,
    )
    sieve: tuple | None = key(
        Sieves(),
        "Openings of the sieves of any other grading.",
        default=None,
        default_text="none: a power-law grading",
    )
    passing: tuple | None = key(
        Passing(),
        "Per cent by mass that pass these sieves.",
        default=None,
        default_text="none: a power-law grading",
    )
    grains: int | None = key(
        Whole(1, MOST_GRAINS),
        "Number of grains.",
        default=None,
        default_text="as many as fill the box at the void ratio",
    )

    @staticmethod
    def problems(section: Any) -> Iterator[Problem]:
        if any(getattr(section, name) is not None for name in TABLE):
            yield from must_be_given(section, TABLE, "a grading by sieves")
            yield from must_be_absent(section, POWER_LAW, "a grading by sieves")
            if section.sieve and section.passing and len(section.sieve) != len(section.passing):
                reason = f"{len(section.passing)} numbers for {len(section.sieve)} sieves"
                yield Problem(reason, "one number a sieve", "passing")
            return
        missing = list(must_be_given(section, POWER_LAW, "a grading without a table of sieves"))
        yield from missing
        if not missing:
            yield from _power_law(section)


def _power_law(section: Any) -> Iterator[Problem]:
    least, most, rms = (getattr(section, name) for name in POWER_LAW)
    if not least < most:
        yield Problem("not above minimum_diameter", f"more than {least:g} m", "maximum_diameter")
    elif not 1.01 * least < rms < 0.99 * most:
        reason = "not well between minimum_diameter and maximum_diameter"
        yield Problem(reason, f"{1.01 * least:.4g} to {0.99 * most:.4g} m", "rms_diameter")
