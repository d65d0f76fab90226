"""A checked sample of crushing strengths, some of them perhaps right-censored."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from grus.errors import GrusError, one_line

MINIMUM_BROKEN = 3


@dataclass(frozen=True)
class StrengthSample:
    """Strengths of a group of grains, ready for a Weibull likelihood.

    strengths: (n,) positive, any unit.
    broken: (n,) bool; False where the grain survived the largest stress applied to it.
    logs: (n,) ln(strength / largest strength), so never positive.
    """

    strengths: np.ndarray
    broken: np.ndarray
    logs: np.ndarray

    @property
    def largest(self) -> float:
        """Largest value of the sample, in the unit of the strengths."""
        return float(self.strengths.max())


def strength_sample(strengths, censored=None) -> StrengthSample:
    """Check strengths (n,) and the mask of unbroken grains (n,), and take relative logarithms.

    Raises GrusError for fewer than 3 broken grains, values that are not positive and finite, a mask
    of another length, and samples whose likelihood grows without bound (no scatter).
    """
    values = _vector("strengths", strengths, float)
    broken = ~censored_mask(censored, values.size)
    bad = np.flatnonzero(~(np.isfinite(values) & (values > 0)))
    if bad.size:
        raise GrusError(
            f"strengths: value {values[bad[0]]:g} at index {bad[0]}; must be positive and finite"
        )
    count = int(broken.sum())
    kind = "values" if broken.all() else "broken grains"
    if count < MINIMUM_BROKEN:
        raise GrusError(f"strengths: {count} {kind}; a Weibull fit needs at least {MINIMUM_BROKEN}")
    if np.all(values[broken] == values.max()):
        raise GrusError(
            f"strengths: all {count} {kind} equal the largest, {values.max():g}; "
            "a Weibull fit needs scatter"
        )
    return StrengthSample(values, broken, relative_logs(values))


def censored_mask(censored, n: int) -> np.ndarray:
    """The mask (n,) of unbroken grains as bool; all False when ``censored`` is None."""
    if censored is None:
        return np.zeros(n, dtype=bool)
    mask = _vector("censored", censored, bool)
    if mask.size != n:
        raise GrusError(f"censored: {mask.size} values for {n} strengths; must be one per strength")
    return mask


def relative_logs(values: np.ndarray) -> np.ndarray:
    """ln(value / largest value), (n,); exact to rounding also when values agree in most digits."""
    largest = values.max()
    near = values > 0.5 * largest
    logs = np.log(values) - np.log(largest)
    logs[near] = np.log1p((values[near] - largest) / largest)
    return logs


def _vector(key: str, values, kind) -> np.ndarray:
    array = np.asarray(values)
    if kind is bool and array.dtype != bool:
        raise GrusError(f"{key}: type {array.dtype}; must be true or false per strength")
    try:
        array = np.array(array, dtype=kind)
    except (TypeError, ValueError):
        raise GrusError(f"{key}: {one_line(repr(values)):.60}; must be a list of numbers") from None
    if array.ndim != 1:
        raise GrusError(f"{key}: shape {array.shape}; must be a one-dimensional list")
    return array
