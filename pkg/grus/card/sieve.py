"""A grading as a table: sieves, and the per cent by mass that pass them."""

from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from grus.card.errors import Problem
from grus.card.interval import POSITIVE, Interval
from grus.card.quantity import Measure, Quantity
from grus.card.values import Number

MOST_SIEVES = 100
OPENING = Quantity({"m": "a length"}, POSITIVE, "9.5 mm")
PERCENT = Number(Interval(least=0, most=100))


@dataclass(frozen=True)
class Sieves:
    """Openings of sieves, rising."""

    allowed: str = (
        f'a list of 2 to {MOST_SIEVES} lengths, each larger than the one before: "9.5 mm"'
    )

    def read(self, value: Any) -> tuple[Measure, ...]:
        return _rising(value, OPENING, self.allowed, strictly=True)


@dataclass(frozen=True)
class Passing:
    """Per cent passing, from 0 to 100."""

    allowed: str = f"a list of 2 to {MOST_SIEVES} numbers that rise from 0 to 100"

    def read(self, value: Any) -> tuple[float, ...]:
        shares = _rising(value, PERCENT, self.allowed, strictly=False)
        if shares[0] != 0 or shares[-1] != 100:
            raise Problem("does not go from 0 to 100", self.allowed)
        return shares


def _rising(value: Any, reader: Any, allowed: str, strictly: bool) -> tuple:
    if not isinstance(value, (list, tuple)):
        raise Problem("not a list", allowed)
    if not 2 <= len(value) <= MOST_SIEVES:
        raise Problem("too few or too many sieves", allowed)
    read = []
    for number, item in enumerate(value, start=1):
        try:
            read.append(reader.read(item))
        except Problem as problem:
            raise Problem(f"sieve {number}: {problem.reason}", allowed) from None
    for number, (one, next_) in enumerate(pairwise(read), start=2):
        if next_ < one or (strictly and next_ == one):
            raise Problem(f"sieve {number} does not rise", allowed)
    return tuple(read)
