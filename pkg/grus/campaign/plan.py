"""Which values of the card's keys are tried: all combinations, or points spread over ranges."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product
from typing import Any

from scipy.stats import qmc

from grus.errors import GrusError

Overrides = dict[str, Any]
PLANS = {"sobol": qmc.Sobol, "latin-hypercube": qmc.LatinHypercube}


@dataclass(frozen=True)
class Range:
    """Values from `low` to `high` in `unit`, which is empty for a pure number. Raises GrusError unless low < high."""

    low: float
    high: float
    unit: str = ""

    def __post_init__(self) -> None:
        if not self.low < self.high:
            raise GrusError(f"range = {self.low:g}..{self.high:g}; allowed: low..high, as 1..3 MPa")

    def at(self, share: float) -> float | str:
        """The value at a share of the way, as a card has it."""
        value = self.low + share * (self.high - self.low)
        return f"{value!r} {self.unit}" if self.unit else value


def grid(choices: Mapping[str, Sequence[Any]]) -> list[Overrides]:
    """Every combination of the values of each key, the last key fastest; one without overrides when there are no keys."""
    return [dict(zip(choices, values)) for values in product(*choices.values())]


def spread(plan: str, ranges: Mapping[str, Range], points: int, seed: int) -> list[Overrides]:
    """`points` combinations spread over the ranges by a 'sobol' sequence or a 'latin-hypercube', which follow from `seed`.

    Raises GrusError for another plan, no ranges, fewer than one point, and in a Sobol sequence for a number of points that
    is no power of two, with which it would lose its balance.
    """
    if plan not in PLANS:
        raise GrusError(f"plan = {plan!r}; allowed: {', '.join(PLANS)}")
    if not ranges:
        raise GrusError(f"plan = {plan!r}: no ranges; allowed: with one key to vary or more")
    if points < 1 or (plan == "sobol" and points & (points - 1)):
        raise GrusError(
            f"points = {points}; allowed: 1 or more, of a Sobol sequence a power of two"
        )
    shares = PLANS[plan](len(ranges), seed=seed).random(points)
    return [
        {name: one.at(float(share)) for (name, one), share in zip(ranges.items(), row)}
        for row in shares
    ]
