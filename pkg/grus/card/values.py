"""Values without a unit: what a key of a card may hold, and how it is read.

Every reader has `allowed` (text) and `read(value)`: the checked value, or Problem is raised.
"""

import math
from dataclasses import dataclass
from numbers import Integral, Real
from typing import Any

from grus.card.errors import Problem
from grus.card.interval import Interval


@dataclass(frozen=True)
class Number:
    """Dimensionless number."""

    interval: Interval

    @property
    def allowed(self) -> str:
        return f"a number {self.interval.text()}"

    def read(self, value: Any) -> float:
        if isinstance(value, str):
            raise Problem("a plain number is needed here, without quotes or unit", self.allowed)
        number = finite(value, self.allowed)
        if number not in self.interval:
            raise Problem("out of bounds", self.allowed)
        return number


@dataclass(frozen=True)
class Whole:
    """Whole number from `least` to `most`."""

    least: int
    most: int

    @property
    def allowed(self) -> str:
        return f"a whole number from {self.least} to {self.most}"

    def read(self, value: Any) -> int:
        if isinstance(value, bool) or not isinstance(value, Integral):
            raise Problem("not a whole number", self.allowed)
        if not self.least <= value <= self.most:
            raise Problem("out of bounds", self.allowed)
        return int(value)


@dataclass(frozen=True)
class Choice:
    """One of a few words or whole numbers."""

    options: tuple

    @property
    def allowed(self) -> str:
        shown = [
            f'"{option}"' if isinstance(option, str) else str(option) for option in self.options
        ]
        return ", ".join(shown[:-1]) + f" or {shown[-1]}"

    def read(self, value: Any) -> Any:
        # 2 == 2.0 == Decimal(2), and True == 1: the type has to agree, too.
        if isinstance(value, type(self.options[0])) and not isinstance(value, bool):
            if value in self.options:
                return value
        raise Problem("not one of the choices", self.allowed)


@dataclass(frozen=True)
class Flag:
    """true or false."""

    allowed: str = "true or false"

    def read(self, value: Any) -> bool:
        if not isinstance(value, bool):
            raise Problem("neither true nor false", self.allowed)
        return value


@dataclass(frozen=True)
class Text:
    """`what`: printable text of at most `longest` characters, with line breaks if `lines`."""

    what: str
    longest: int
    lines: bool = False

    @property
    def allowed(self) -> str:
        return f"{self.what}, at most {self.longest} printable characters"

    def read(self, value: Any) -> str:
        if not isinstance(value, str):
            raise Problem("not a text in quotes", self.allowed)
        shown = value.replace("\n", " ") if self.lines else value
        if not shown.strip() or len(value) > self.longest or not shown.isprintable():
            raise Problem("empty, too long or not printable", self.allowed)
        return value


def finite(value: Any, allowed: str) -> float:
    """`value` as a finite float; -0.0 becomes 0.0."""
    if isinstance(value, bool) or not isinstance(value, Real):
        raise Problem("not a number", allowed)
    try:
        number = float(value)
    except OverflowError:
        raise Problem("too large for a number", allowed) from None
    if not math.isfinite(number):
        raise Problem("not a finite number", allowed)
    return number + 0.0
