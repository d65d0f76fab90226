"""One line of the verification table."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass, replace

import numpy as np
from numpy.typing import ArrayLike


@dataclass(frozen=True)
class Row:
    """What was expected, what YADE gave, and whether that is near enough.

    part: 'formulas', 'other laws', 'time step' or 'energy'.
    case, quantity: what was done and what was looked at; unit: of the two values, SI.
    expected, got: the values; of vectors their lengths.
    deviation: of `got`, relative to `expected`; absolute when 0 is expected. Of vectors the length of the difference.
    tolerance: largest deviation that passes; None for a row that only informs.
    note: where the expectation comes from, or why a difference remains.
    """

    part: str
    case: str
    quantity: str
    unit: str
    expected: float
    got: float
    deviation: float
    tolerance: float | None
    note: str

    @property
    def passed(self) -> bool | None:
        """None for a row that only informs; a deviation that is not a number does not pass."""
        return None if self.tolerance is None else bool(self.deviation <= self.tolerance)

    def to_dict(self) -> dict:
        """Plain JSON; numbers that are not finite become null."""
        row = asdict(self) | {"passed": self.passed}
        return {key: None if _not_finite(value) else value for key, value in row.items()}


def compare(
    part: str,
    case: str,
    quantity: str,
    unit: str,
    expected: ArrayLike,
    got: ArrayLike,
    tolerance: float | None,
    note: str,
) -> Row:
    """Row of two numbers or of two arrays of one shape."""
    expected, got = np.asarray(expected, dtype=float), np.asarray(got, dtype=float)
    size = np.linalg.norm(expected)
    difference = np.linalg.norm(got - expected)
    deviation = difference / size if size > 0 else difference
    values = [float(v if v.ndim == 0 else np.linalg.norm(v)) for v in (expected, got)]
    return Row(part, case, quantity, unit, *values, float(deviation), tolerance, note)


def at_most(
    part: str,
    case: str,
    quantity: str,
    unit: str,
    expected: float,
    got: float,
    tolerance: float,
    note: str,
) -> Row:
    """Row of a bound: only what `got` exceeds `expected` by is a deviation."""
    row = compare(part, case, quantity, unit, expected, got, tolerance, note)
    return replace(row, deviation=0.0) if got <= expected else row


def worst(rows: Iterable[Row]) -> Row:
    """The row with the largest deviation, to stand for variants of one case."""
    return max(rows, key=lambda row: np.nan_to_num(row.deviation, nan=np.inf))


def _not_finite(value: object) -> bool:
    return isinstance(value, float) and not np.isfinite(value)
