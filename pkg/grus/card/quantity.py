"""Values with a unit."""

import re
from dataclasses import dataclass
from decimal import Decimal
from math import isfinite
from typing import Any

from grus.card.errors import Problem
from grus.card.interval import Interval
from grus.card.units import factor, long_name, parse
from grus.card.values import finite

_WRITTEN = re.compile(
    r"\s*([+-]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?)(?![0-9.,])\s*(.*?)\s*", re.DOTALL
)
_LONGEST = 60  # characters of a quantity


class Measure(float):
    """A float in SI that knows its SI `unit`; arithmetic gives plain floats."""

    unit: str

    def __new__(cls, value: float, unit: str) -> "Measure":
        self = super().__new__(cls, value)
        self.unit = unit
        return self

    def __getnewargs__(self) -> tuple[float, str]:
        return float(self), self.unit

    def written(self) -> str:
        """As a card would write it, exactly."""
        return f"{float(self)!r} {self.unit}"


@dataclass(frozen=True)
class Quantity:
    """A number and a unit in quotes.

    `units`: SI units that the key may have, each with the name of what it measures.
    `interval`: in SI; `bounds` tells it in words, where its own are awkward.
    """

    units: dict[str, str]
    interval: Interval
    example: str
    bounds: str = ""

    @property
    def allowed(self) -> str:
        kinds = " or ".join(f"{name} [{unit}]" for unit, name in self.units.items())
        return f"{kinds} {self.bounds or self.interval.text()}"

    def read(self, value: Any) -> Measure:
        hint = f'for example "{self.example}"'
        if not isinstance(value, str):
            finite(value, self.allowed)
            raise Problem(f"give a unit, {hint}", self.allowed)
        match = _WRITTEN.fullmatch(value) if len(value) <= _LONGEST else None
        if match is None:
            raise Problem(f"not a number (with a decimal point) and a unit, {hint}", self.allowed)
        number, unit = match.groups()
        if not unit:
            raise Problem(f"give a unit, {hint}", self.allowed)
        return self._convert(number, unit)

    def _convert(self, number: str, unit: str) -> Measure:
        try:
            parse(unit)
        except ValueError as error:
            raise Problem(f'{error}, for example "{self.example}"', self.allowed) from None
        for si_unit in self.units:
            scale = factor(unit, si_unit)
            if scale is not None:
                break
        else:
            name = long_name(unit)
            read_as = f" ({name})" if name else ""
            raise Problem(
                f'"{unit}"{read_as} is not {" or ".join(self.units.values())}', self.allowed
            )
        # Beyond the range of a float, Decimal may object to the exponent.
        result = float(number)
        if result and isfinite(result):
            result = float(Decimal(number) * scale)
        if not isfinite(result):
            raise Problem("too large for a number", self.allowed)
        if result not in self.interval:
            raise Problem("out of bounds", self.allowed)
        return Measure(result + 0.0, si_unit)  # -0.0 becomes 0.0
